#include "server/physics/anchor/anchor_drift.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

double AnchorDrift::clear(const AnchorPlace& place, double reach) const {
    const double shift = (place.centre - marked_.centre).norm();
    if (!(shift < clear_)) return 0;
    // A turn by an angle moves a point at the distance 1 by 2 sin(angle / 2) = 4 sin(angle / 4) cos(angle /
    // 4), and two unit quaternions are 2 sin(angle / 4) apart; either sign of one means the same turn.
    const Eigen::Vector4d was = marked_.attitude.coeffs(), is = place.attitude.coeffs();
    const double turn = 2 * std::sqrt(std::min((is - was).squaredNorm(), (is + was).squaredNorm()));
    // Flukes turn about a pin that is within reach, too.
    const double swing = 2 * std::abs(place.flukes - marked_.flukes);
    return clear_ - shift - (turn + swing) * reach;
}

} // namespace windlass::physics
