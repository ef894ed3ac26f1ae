#include "server/exercise/faults.hpp"

#include <algorithm>

namespace windlass::exercise {

namespace {

void raise(FaultView& fault, const FaultBook::Log& log) {
    fault.phase = FaultPhase::active;
    log(Severity::warning, "fault.active", static_cast<int>(fault.order.side), fault.order.severity,
        std::string(fault_name(fault.order.code)) + " is active");
}

bool due(const FaultOrder& order, const FaultSight& sight) {
    switch (order.trigger) {
    case FaultTrigger::now:
        return true;
    case FaultTrigger::at_time:
        return sight.time >= order.trigger_value;
    case FaultTrigger::at_cable_out:
        return sight.cable_out >= order.trigger_value;
    case FaultTrigger::at_load:
        return sight.gypsy_load >= order.trigger_value;
    }
    return false;
}

} // namespace

const char* fault_name(FaultCode code) {
    switch (code) {
    case FaultCode::brake_lining_faded:
        return "brake-lining-faded";
    case FaultCode::motor_power_lost:
        return "motor-power-lost";
    case FaultCode::clutch_jumps_out:
        return "clutch-jumps-out";
    case FaultCode::load_cell_dead:
        return "load-cell-dead";
    }
    return "unknown";
}

void FaultBook::order(const FaultOrder& order, const Log& log) {
    auto fault = std::find_if(faults_.begin(), faults_.end(), [&](const FaultView& f) {
        return f.order.code == order.code && f.order.side == order.side;
    });
    const int side = static_cast<int>(order.side);
    if (order.clear) {
        if (fault == faults_.end() || fault->phase == FaultPhase::cleared) return;
        fault->phase = FaultPhase::cleared;
        log(Severity::info, "fault.cleared", side, 0, std::string(fault_name(order.code)) + " is cleared");
        return;
    }
    if (fault == faults_.end()) fault = faults_.insert(faults_.end(), FaultView{});
    *fault = {order, FaultPhase::armed};
    if (order.trigger == FaultTrigger::now) {
        raise(*fault, log);
    } else {
        log(Severity::info, "fault.armed", side, order.trigger_value,
            std::string(fault_name(order.code)) + " is armed");
    }
}

void FaultBook::watch(Side side, const FaultSight& sight, const Log& log) {
    for (FaultView& fault : faults_) {
        if (fault.order.side == side && fault.phase == FaultPhase::armed && due(fault.order, sight))
            raise(fault, log);
    }
}

physics::WindlassCauses FaultBook::causes(Side side) const {
    physics::WindlassCauses causes;
    for (const FaultView& fault : faults_) {
        if (fault.order.side != side || fault.phase != FaultPhase::active) continue;
        switch (fault.order.code) {
        case FaultCode::brake_lining_faded:
            causes.lining_faded = fault.order.severity;
            break;
        case FaultCode::motor_power_lost:
            causes.power_lost = fault.order.severity;
            break;
        case FaultCode::clutch_jumps_out:
            causes.clutch_worn = fault.order.severity;
            break;
        case FaultCode::load_cell_dead:
            causes.load_cell_dead = fault.order.severity;
            break;
        }
    }
    return causes;
}

} // namespace windlass::exercise
