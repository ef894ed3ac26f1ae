#include "server/physics/ship/hawse_pipe.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

Vec3 HawsePipe::chain_at(double inboard) const {
    const double turn = std::acos(bore.z()); // from plumb
    const Vec3 level = Vec3(bore.x(), bore.y(), 0).normalized();
    const double turned = std::clamp(inboard / bend, 0.0, turn);
    const Vec3 round = bend * (std::sin(turned) * Vec3::UnitZ() + (1 - std::cos(turned)) * level);
    return lip + round + std::max(0.0, inboard - bend * turn) * bore;
}

double HawsePipe::cable_at_home() const {
    const double turn = std::acos(bore.z());
    return -seat - bend * (turn - std::sin(turn)); // round the bend, then along the bore
}

double HawsePipe::bent(const Vec3& lead) const {
    return std::asin(bore.z()) + std::acos(std::clamp(-bore.dot(lead), -1.0, 1.0));
}

} // namespace windlass::physics
