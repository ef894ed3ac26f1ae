#pragma once
// The ground under a ship's keel: how far below it is, and what it does to her when it is not.

#include "server/physics/sea/environment.hpp"
#include "server/physics/ship/flotation.hpp"
#include "server/physics/ship/planar_force.hpp"
#include "server/physics/ship/ship.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// Under the keel from end to end and bilge to bilge, as she floats and as waves move her.
struct KeelAndGround {
    double depth = 0;     ///< m of water, in the mean along the keel
    double clearance = 0; ///< m, least under the keel; below 0 she is aground
    GroundLift lift;      ///< of the ground on her
    PlanarForce force;    ///< of the ground on her, her own axes
};

/// Looks at eleven places of her bottom: three athwart at each of three stations, and the ends of the keel.
/// Ground that stands above one bears by a stiff spring that gives nothing back (her whole weight on all of
/// them goes 0.1 m into it; tuned, of any soil), pushes along its slope, and rubs by 0.4 of what it bears
/// (0.3 to 0.5 of steel on sand, gravel, rock; an estimate) against the way it makes over ground. dt (s): of
/// the step in which it is to come to rest.
KeelAndGround keel_and_ground(const ShipDef& def, const EnvironmentDef& environment, const ShipState& state,
                              double dt);

} // namespace windlass::physics
