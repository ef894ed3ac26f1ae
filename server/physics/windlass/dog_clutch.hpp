#pragma once
// The dog clutch between shaft and gypsy: its claws go in near standstill and in line, do not come out under
// load, jump out when they are worn, and shear.

#include "server/physics/base/equipment_faults.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/windlass/windlass_def.hpp"

namespace windlass::physics {

enum class Clutch { out, engaging, in };
constexpr Clutch last_of(Clutch) {
    return Clutch::in;
}

inline constexpr double kEngageSpeed = 0.02;   ///< m/s, largest difference at which the claws go in; tuned
inline constexpr double kInchingSpeed = 0.018; ///< m/s, at which the drive turns over while they seek; tuned

/// What changes of a dog clutch.
struct DogClutchState {
    Clutch position = Clutch::out;
    double claw_offset = 0; ///< m at the pitch line, of the claws from being in line, 0..claw pitch
    bool refused = false;   ///< asked for, but the claws cannot go in or out
    bool sheared = false;   ///< claws or shaft broken: nothing goes through any more
};
template <class Visitor, StateOf<DogClutchState> State>
void visit_state(Visitor& v, State& state);

/// m at the pitch line from one claw to the next.
double claw_pitch(const WindlassDef& def);

/// Whether the claws stand in front of gaps.
bool claws_in_line(const WindlassDef& def, const DogClutchState& state);

/// dt (s) with the lever in or out. slip: m/s, gypsy less shaft; through: N that the claws carry.
void work_clutch(const WindlassDef& def, double dt, bool wanted_in, double slip, double through,
                 const EquipmentFaults& causes, DogClutchState& state);

} // namespace windlass::physics
