#pragma once
// Wind force on a ship: Isherwood's regression.

#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// Force on the ship's above-water part. x forward, y to starboard, moment clockwise about midships.
struct PlanarForce {
    double x = 0, y = 0, moment = 0; ///< N, N, N m
};

/// Relative wind of the given speed (m/s) from the angle off the bow (rad, starboard positive, -pi..pi).
/// R. M. Isherwood, Wind Resistance of Merchant Ships, RINA Transactions 115 (1972) 327-338.
PlanarForce wind_force(const ShipDef& ship, double speed, double angle);

} // namespace windlass::physics
