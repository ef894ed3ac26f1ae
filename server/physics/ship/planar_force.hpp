#pragma once
// A force on a ship in the plane.

namespace windlass::physics {

/// x forward, y to starboard, moment clockwise about midships.
struct PlanarForce {
    double x = 0, y = 0, moment = 0; ///< N, N, N m

    PlanarForce& operator+=(const PlanarForce& other) {
        x += other.x, y += other.y, moment += other.moment;
        return *this;
    }
};

} // namespace windlass::physics
