#pragma once
// How warm an electric motor's winding and its overload relay are, and when they keep it from running.
// Both are one mass that the square of the current heats and the air cools: tau dh/dt = (pull / rated)^2 - h,
// so that h tends to 1 at the rated pull (the pull stands for the current, as in motor_current).

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/windlass/windlass_def.hpp"

namespace windlass::physics {

/// What changes of it. Cold at first.
struct MotorHeat {
    double relay = 0;   ///< -, h of the relay's bimetal
    double winding = 0; ///< -, h of the winding: much slower, an S2 motor never comes near 1
    bool open = false;  ///< relay or thermistor has opened, and neither has cooled enough to close again
};
template <class Visitor, StateOf<MotorHeat> State>
void visit_state(Visitor& v, State& state);

/// dt (s) at the given pull (N, before the gear), in whose stead a relay that is set wrong sees another;
/// opens and closes what guards it. No pull: it cools.
void heat_motor(const WindlassDef& def, double dt, double pull, double seen_by_relay, MotorHeat& heat);

/// Temperature of the winding, K.
double winding_temperature(const MotorHeat& heat);

} // namespace windlass::physics
