#include "server/physics/windlass/prime_mover.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/windlass/electric_drive.hpp"
#include "server/physics/windlass/hydraulic_drive.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {
constexpr double kFollowsIn = 0.5; ///< s, for the drive to follow the lever over its range; tuned
}

double light_line_speed(const WindlassDef& def) {
    return def.drive == DriveKind::hydraulic ? hydraulic_top_speed(def) : def.light_line_speed;
}

bool has_power(const WindlassDef& def, const PrimeMoverState& state, const EquipmentFaults& causes) {
    const bool hydraulic_gone =
        def.drive == DriveKind::hydraulic && (causes.hose_burst >= 1 || causes.pumps_lost >= 1);
    return causes.power_lost < 1 && !hydraulic_gone && !state.tripped && !state.overspeed && !state.burst &&
           !state.cut_off;
}

double lever_speed(const WindlassDef& def, double lever) {
    assert(lever >= -1 && lever <= 1 && "the lever has stops");
    const double share = def.drive == DriveKind::electric_pole_changing ? pole_step(lever) : lever;
    return -light_line_speed(def) * share;
}

void follow_lever(const WindlassDef& def, double dt, double wanted, bool powered, PrimeMoverState& state) {
    assert(dt > 0 && "a step takes time");
    const double max = dt * light_line_speed(def) / kFollowsIn;
    state.target += std::clamp((powered ? wanted : 0) - state.target, -max, max);
}

void guard_restart(bool off, bool lever_at_zero, PrimeMoverState& state) {
    state.cut_off = off || (state.cut_off && !lever_at_zero);
    if (!lever_at_zero) return;
    state.overspeed = false;
    state.tripped = state.tripped && state.heat.open;
}

namespace {

/// Of its pull, lost by an induction motor on two phases of three: its breakdown torque falls to 0.3 to 0.5.
constexpr double kPhaseLoss = 0.6;
/// Line current on two phases over that on three, for the same power.
constexpr double kPhaseCurrent = std::numbers::sqrt3;

} // namespace

MotorPull prime_mover_pull(const WindlassDef& def, const PrimeMoverState& state,
                           const EquipmentFaults& causes) {
    const double health = (1 - causes.power_lost) * (1 - kPhaseLoss * causes.phase_lost);
    switch (def.drive) {
    case DriveKind::electric_vfd:
        return vfd_pull(def, state.speed, state.target, health);
    case DriveKind::electric_pole_changing:
        return pole_changing_pull(def, state.speed, state.target, health);
    case DriveKind::hydraulic:
        return hydraulic_pull(def, state.target, causes);
    }
    return {};
}

void strain_prime_mover(const WindlassDef& def, double dt, double pull, bool engaged,
                        const EquipmentFaults& causes, PrimeMoverState& state) {
    assert(dt > 0 && "a step takes time");
    if (def.drive == DriveKind::hydraulic) {
        state.pressure = std::abs(pull) / hydraulic_area(def); // its relief valve limits it, no relay
    } else {
        // Two phases draw more for the same pull, and warm the winding by it; a relay set too low only sees
        // more.
        const double drawn = pull * (1 + (kPhaseCurrent - 1) * causes.phase_lost);
        heat_motor(def, dt, drawn, drawn * (1 + causes.relay_misset), state.heat);
        if (state.heat.open) state.tripped = true;
    }
    if (causes.drive_trip > 0 && !state.trip_seen) state.tripped = true; // once: the lever resets it
    state.trip_seen = causes.drive_trip > 0;
    if (!engaged) return;
    const double speed = std::abs(state.speed), top = light_line_speed(def);
    state.worst_speed = std::max(state.worst_speed, speed);
    if (speed > kOverspeedTrip * top && causes.overspeed_unprotected == 0) state.overspeed = true;
    if (speed > kBurstSpeed * top) state.burst = true;
}

double motor_temperature(const WindlassDef& def, const PrimeMoverState& state) {
    return def.drive == DriveKind::hydraulic ? kAirTemperature : winding_temperature(state.heat);
}

template <class Visitor, StateOf<PrimeMoverState> State>
void visit_state(Visitor& v, State& state) {
    auto& [speed, target, heat, pressure, tripped, trip_seen, overspeed, cut_off, burst, worst_speed] = state;
    WINDLASS_STATE(v, speed, target, heat, pressure, tripped, trip_seen, overspeed, cut_off, burst,
                   worst_speed);
    WINDLASS_WITHIN(v, -kFastest, kFastest, speed, target, worst_speed);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, pressure);
}
WINDLASS_STATE_LISTED(PrimeMoverState);

} // namespace windlass::physics
