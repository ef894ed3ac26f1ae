#include "server/physics/bend_limit.hpp"

#include "server/physics/chain_self_contact.hpp"

#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

/// A column of links standing on end falls to one side or other: this far from upright (rad) it is pushed, by
/// the golden angle from node to node, as chain of links set crosswise does.
constexpr double kTopple = 0.05;
constexpr double kGoldenAngle = 2.399963; // rad

Vec3 toppled(const Vec3& normal, int node) {
    if (std::abs(normal.z()) < 0.99) return normal;
    const double turn = kGoldenAngle * node;
    return (normal + kTopple * Vec3(std::cos(turn), std::sin(turn), 0)).normalized();
}

} // namespace

double least_distance(const ChainDef& def, double along) {
    const double radius = def.bend_radius;
    return 2 * radius * std::sin(std::min(0.5 * along / radius, 0.5 * std::numbers::pi));
}

void find_bend_limits(const ChainDef& def, const ChainState& chain, double dt, ContactSet& set) {
    const int n = chain.links;
    const LinkTouch touch = link_touch(def);
    const auto pair = [&](int lower, int upper, double least) {
        const Vec3 apart = chain.position.at(upper) - chain.position.at(lower);
        const double distance = apart.norm();
        const Vec3 normal = distance > 1e-9 * least ? Vec3(apart / distance) : Vec3::UnitZ();
        const double closing = dt * normal.dot(chain.velocity.at(lower) - chain.velocity.at(upper));
        if (distance - closing > least) return;
        const bool top = upper == n;
        set.add(PairContact{.link_a = top ? n - 1 : upper,
                            .link_b = lower,
                            .at_a = top ? 1.0 : 0.0,
                            .at_b = 0,
                            .normal = toppled(normal, lower),
                            .penetration = least - distance,
                            .stiffness = touch.stiffness,
                            .damping = touch.damping,
                            .friction = 0});
    };
    // The links of no interest are passed over quickly: the two nodes further apart than they can close.
    const auto folded = [&](int lower, int upper, double least) {
        const double reach = least + dt * 20; // m; two nodes that meet at 20 m/s
        return (chain.position.at(upper) - chain.position.at(lower)).squaredNorm() < reach * reach;
    };
    const double one = least_distance(def, def.node_spacing), two = least_distance(def, 2 * def.node_spacing);
    for (int i = chain.asleep; i < n; ++i) {
        const double single = i == n - 1 ? least_distance(def, chain.top_length) : one;
        if (folded(i, i + 1, single)) pair(i, i + 1, single);
        if (i + 2 > n) continue;
        const double both = i == n - 2 ? least_distance(def, def.node_spacing + chain.top_length) : two;
        if (folded(i, i + 2, both)) pair(i, i + 2, both);
    }
}

} // namespace windlass::physics
