#pragma once
// What the elements ask of a ship that lies still: the load of her cables once she is brought up.

#include "server/physics/ship/ship.hpp"

namespace windlass::physics {

/// Level force (N, world) of wind, stream, wave drift, engine, rudder and thrusters on her, were she at rest
/// over the ground on her present heading. Found from step_ship itself, so that it is always the ship's own
/// law: what she gains in a short step from rest, over what a known pull adds to that.
Vec3 force_at_rest(const ShipDef& def, const EnvironmentDef& environment, const Helm& helm,
                   const ShipState& state);

} // namespace windlass::physics
