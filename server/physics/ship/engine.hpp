#pragma once
// The main engine between telegraph and propeller.

#include "server/physics/ship/ship.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// What of a ship's machinery there is to be had. Causes, set from outside.
struct Machinery {
    bool engine_available = true;    ///< else it runs down and stands
    bool steering_available = true;  ///< else the rudder stays where it is
    bool thrusters_available = true; ///< else they give nothing
};

/// Advances engine by dt (s) towards what the telegraph orders (-1 full astern .. 1 full ahead), or to a stop
/// where it is not available. One that must stand to turn the other way (engine_start_time above 0) runs down
/// first, and takes that time to come up again.
void step_engine(const ShipDef& def, double ordered, bool available, double dt, ShipState& state);

} // namespace windlass::physics
