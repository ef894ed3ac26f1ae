#include "server/exercise/faults.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace windlass::exercise {

namespace {

void raise(FaultView& fault, const FaultBook::Log& log) {
    fault.phase = FaultPhase::active;
    log(Severity::warning, "fault.active", static_cast<int>(fault.order.side), fault.order.severity,
        std::string(fault_name(fault.order.code)) + " is active");
}

bool due(const FaultOrder& order, const TriggerInputs& sight) {
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

/// The cause that a fault is; null for what is not a cause in the machine.
double* cause_of(FaultCode code, physics::EquipmentFaults& causes) {
    switch (code) {
    case FaultCode::brake_lining_faded:
        return &causes.lining_faded;
    case FaultCode::brake_lining_worn:
        return &causes.lining_worn;
    case FaultCode::brake_lining_glazed:
        return &causes.lining_glazed;
    case FaultCode::brake_wet:
        return &causes.lining_wet;
    case FaultCode::motor_power_lost:
    case FaultCode::blackout:
        return &causes.power_lost;
    case FaultCode::drive_trip:
        return &causes.drive_trip;
    case FaultCode::overspeed_protection_lost:
        return &causes.overspeed_unprotected;
    case FaultCode::hydraulic_pump_lost:
        return &causes.pumps_lost;
    case FaultCode::hydraulic_hose_burst:
        return &causes.hose_burst;
    case FaultCode::counterbalance_stuck_open:
        return &causes.counterbalance_open;
    case FaultCode::relief_valve_low:
        return &causes.relief_low;
    case FaultCode::clutch_jumps_out:
        return &causes.clutch_worn;
    case FaultCode::clutch_shaft_damaged:
        return &causes.shaft_damaged;
    case FaultCode::gypsy_pockets_worn:
        return &causes.pockets_worn;
    case FaultCode::chain_link_weak:
        return &causes.link_weak;
    case FaultCode::spurling_pipe_jammed:
        return &causes.pipe_jammed;
    case FaultCode::joining_shackle_open:
        return &causes.shackle_open;
    case FaultCode::bitter_end_weak:
        return &causes.bitter_end_weak;
    case FaultCode::stopper_pin_out:
        return &causes.stopper_pin_out;
    case FaultCode::chain_counter_drift:
        return &causes.counter_drift;
    case FaultCode::cable_twisted:
        return &causes.cable_twisted;
    case FaultCode::load_cell_dead:
        return &causes.load_cell_dead;
    case FaultCode::anchor_fouled:
        return &causes.anchor_fouled;
    case FaultCode::soil_poor:
        return &causes.soil_poor;
    default:
        return nullptr;
    }
}

} // namespace

const char* fault_name(FaultCode code) {
    static constexpr std::array kNames{"brake-lining-faded",
                                       "motor-power-lost",
                                       "clutch-jumps-out",
                                       "load-cell-dead",
                                       "brake-lining-worn",
                                       "brake-wet",
                                       "stopper-pin-out",
                                       "hydraulic-pump-lost",
                                       "hydraulic-hose-burst",
                                       "drive-trip",
                                       "blackout",
                                       "clutch-shaft-damaged",
                                       "gypsy-pockets-worn",
                                       "spurling-pipe-jammed",
                                       "chain-link-weak",
                                       "joining-shackle-open",
                                       "bitter-end-weak",
                                       "chain-counter-drift",
                                       "anchor-fouled",
                                       "soil-poor",
                                       "cctv-lost",
                                       "vhf-lost",
                                       "brake-lining-glazed",
                                       "overspeed-protection-lost",
                                       "counterbalance-stuck-open",
                                       "relief-valve-low",
                                       "cable-twisted"};
    static_assert(kNames.size() == static_cast<std::size_t>(FaultCode::cable_twisted) + 1);
    return kNames.at(static_cast<std::size_t>(code));
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

void FaultBook::watch(Side side, const TriggerInputs& sight, const Log& log) {
    for (FaultView& fault : faults_) {
        if (fault.order.side == side && fault.phase == FaultPhase::armed && due(fault.order, sight))
            raise(fault, log);
    }
}

physics::EquipmentFaults FaultBook::causes(Side side) const {
    physics::EquipmentFaults causes;
    for (const FaultView& fault : faults_) {
        const bool both_sides = fault.order.code == FaultCode::blackout;
        if ((fault.order.side != side && !both_sides) || fault.phase != FaultPhase::active) continue;
        double* cause = cause_of(fault.order.code, causes);
        if (cause != nullptr) *cause = std::max(*cause, fault.order.severity);
    }
    return causes;
}

void FaultBook::visit_state(physics::StateVisitor& v) {
    std::size_t count = faults_.size();
    v.field({"count"}, count);
    const std::size_t codes = static_cast<std::size_t>(last_of(FaultCode{})) + 1;
    v.within({"count"}, count, 0, 2 * codes); // one for each code and side
    faults_.resize(count);
    for (FaultView& fault : faults_) {
        auto& [order, phase] = fault;
        auto& [code, side, severity, trigger, trigger_value, clear] = order;
        WINDLASS_STATE(v, phase, code, side, severity, trigger, trigger_value, clear);
        v.within({"severity"}, severity, 0, 1);
    }
}

} // namespace windlass::exercise
