#pragma once
// What all prime movers of a windlass have in common: a lever that they follow, protection that trips them,
// and an end when the cable drives them faster than they can turn.
// Pulls in N as felt at the gypsy's pitch line, before the gear; speeds in m/s of chain, paying out positive.

#include "server/physics/base/equipment_faults.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/windlass/drive_line.hpp"
#include "server/physics/windlass/gearbox.hpp"
#include "server/physics/windlass/motor_heat.hpp"
#include "server/physics/windlass/windlass_def.hpp"

namespace windlass::physics {

/// Times the light line speed, at which protection cuts the motor off: UR A3 3.4 asks for it without a
/// figure; tuned.
inline constexpr double kOverspeedTrip = 1.25;
/// Times the light line speed, at which the motor flies apart: an electric one is tested at 1.2, a hydraulic
/// one bursts well above twice; tuned.
inline constexpr double kBurstSpeed = 4;

/// What changes of a prime mover.
struct PrimeMoverState {
    double speed = 0;       ///< m/s: what it turns at
    double target = 0;      ///< m/s: what the lever has made of it so far
    MotorHeat heat;         ///< electric
    double pressure = 0;    ///< Pa, hydraulic
    bool tripped = false;   ///< on overload; lever to zero resets it once it is no longer too hot
    bool trip_seen = false; ///< the fault that tripped it has been acted on
    bool overspeed = false; ///< cut off because the cable drove it too fast; lever to zero resets it
    bool cut_off = false;   ///< by emergency stop or loss of power; stays so until the lever has been at zero
    bool burst = false;     ///< flew apart: debris, and nothing left to hold or heave with
    double worst_speed = 0; ///< m/s, fastest that the cable ever drove it
};
template <class Visitor, StateOf<PrimeMoverState> State>
void visit_state(Visitor& v, State& state);

/// Chain speed of the unloaded prime mover at full lever, m/s.
double light_line_speed(const WindlassDef& def);

/// Pull before the gear at rated_pull behind it, N.
inline double rated_motor_pull(const WindlassDef& def) {
    return def.rated_pull / kGearEfficiency;
}

/// Whether it can drive, so that its fail-safe brake is lifted when the lever is off zero.
bool has_power(const WindlassDef& def, const PrimeMoverState& state, const EquipmentFaults& causes);

/// Chain speed that a lever position (-1..1, heaving positive) asks for, m/s, paying out positive.
double lever_speed(const WindlassDef& def, double lever);

/// The drive on its way to a speed (m/s, paying out positive; 0 without power) for dt (s).
void follow_lever(const WindlassDef& def, double dt, double wanted, bool powered, PrimeMoverState& state);

/// Lever at zero: the drive can be started again after a trip, once relay and winding have cooled. off: the
/// emergency stop is pressed, or there is no power; when that ends, it must not start by itself (ISO
/// 13850 4.1.4; IEC 60204-1 7.5).
void guard_restart(bool off, bool lever_at_zero, PrimeMoverState& state);

/// What it pulls in this step, against chain speed. Rises with speed along straight pieces; where the true
/// curve falls, it is taken at the speed before the step.
MotorPull prime_mover_pull(const WindlassDef& def, const PrimeMoverState& state,
                           const EquipmentFaults& causes);

/// dt (s) at the given pull (N): heat, over-speed protection, bursting.
void strain_prime_mover(const WindlassDef& def, double dt, double pull, bool engaged,
                        const EquipmentFaults& causes, PrimeMoverState& state);

/// Winding, K; the hydraulic drive's oil is not modelled and as warm as the air.
double motor_temperature(const WindlassDef& def, const PrimeMoverState& state);

} // namespace windlass::physics
