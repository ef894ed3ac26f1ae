#pragma once
// Angles that go round.

#include <cmath>

namespace windlass::physics {

/// std::remainder(angle, turn) to the bit, for angles that have mostly not gone round: then at no cost.
inline double remainder_of_turn(double angle, double turn) {
    return std::abs(angle) <= 0.5 * turn ? angle : std::remainder(angle, turn);
}

} // namespace windlass::physics
