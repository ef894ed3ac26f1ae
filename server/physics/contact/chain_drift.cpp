#include "server/physics/contact/chain_drift.hpp"

#include "server/physics/base/vectorise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windlass::physics {

void ChainDrift::mark(const ChainState& chain) {
    links_ = chain.links;
    asleep_ = chain.asleep;
    const auto copy = [&](const std::vector<double>& from, std::vector<double>& to) {
        std::copy(from.begin() + asleep_, from.begin() + links_ + 1, to.begin() + asleep_);
    };
    copy(chain.position.x, marked_.x);
    copy(chain.position.y, marked_.y);
    copy(chain.position.z, marked_.z);
}

double ChainDrift::farthest(const ChainState& chain, double dt) const {
    if (chain.links != links_ || chain.asleep != asleep_) return std::numeric_limits<double>::infinity();
    // What sleeps does not go along.
    const int middle = chain.links / 2;
    const bool together = chain.asleep == 0;
    const Vec3 gone = together ? Vec3(chain.position.at(middle) - marked_.at(middle)) : Vec3::Zero();
    const Vec3 speed = together ? chain.velocity.at(middle) : Vec3::Zero();
    const auto square = [&](int i) WINDLASS_INLINE {
        return (chain.position.at(i) - marked_.at(i) - gone).squaredNorm() +
               dt * dt * (chain.velocity.at(i) - speed).squaredNorm();
    };
    const double largest = largest_of(chain.asleep, chain.links, square);
    return std::sqrt(2 * largest); // (a + b)^2 <= 2 (a^2 + b^2)
}

} // namespace windlass::physics
