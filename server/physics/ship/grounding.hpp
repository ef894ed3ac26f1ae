#pragma once
// The ground under a ship's keel: how far below it is, and what it does to her when it is not.

#include "server/physics/sea/environment.hpp"
#include "server/physics/ship/planar_force.hpp"
#include "server/physics/ship/ship.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// Under the keel, from end to end; waves, trim and squat left out.
struct KeelAndGround {
    double depth = 0;     ///< m of water, in the mean along the keel
    double clearance = 0; ///< m, least under the keel; below 0 she is aground
    double bearing = 0;   ///< N, of her weight that the ground bears
    PlanarForce force;    ///< of the ground on her, her own axes
};

/// Looks at five places along the keel; where no ground departs from level, at one. Ground that stands above
/// the keel bears what the hull around it displaces no longer (a spring of rho g times the waterplane),
/// pushes along its slope, and rubs by 0.4 of what it bears (0.3 to 0.5 of steel on sand, gravel, rock; an
/// estimate) against the way it makes over ground. dt (s): of the step in which it is to come to rest.
KeelAndGround keel_and_ground(const ShipDef& def, const EnvironmentDef& environment, const ShipState& state,
                              double dt);

} // namespace windlass::physics
