#pragma once
// Wind force on a ship.

#include "server/physics/ship/planar_force.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// Relative wind of the given speed (m/s) from the angle off the bow (rad, starboard positive, -pi..pi).
///
/// W. Blendermann (1994), Parameter identification of wind loads on ships, J. of Wind Engineering and
/// Industrial Aerodynamics 51, 339-351: four coefficients of a kind of ship, which stay sound where sides are
/// high. (R. M. Isherwood's regression of 1972, which stood here, drives a car carrier ahead with the wind 60
/// degrees on the bow; for bulk carriers and tankers the two agree to a fifth abeam.) The moment's arm is the
/// windage's centre, less 0.18 of the length for each radian that the wind is abaft the beam.
PlanarForce wind_force(const ShipDef& ship, double speed, double angle);

} // namespace windlass::physics
