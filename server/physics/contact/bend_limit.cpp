#include "server/physics/contact/bend_limit.hpp"

#include "server/physics/base/vectorise.hpp"
#include "server/physics/contact/chain_self_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
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

double min_distance(const ChainDef& def, double along) {
    const double radius = def.bend_radius;
    return 2 * radius * std::sin(std::min(0.5 * along / radius, 0.5 * std::numbers::pi));
}

namespace {

/// Least distances of nodes that are one and two links apart.
struct Least {
    double one, two;
    explicit Least(const ChainDef& def)
        : one(min_distance(def, def.node_spacing)), two(min_distance(def, 2 * def.node_spacing)) {}
};

/// Two nodes of the chain, if they are as near as they may be or about to come so.
void limit(const ChainState& chain, double dt, const LinkTouch& touch, int lower, int upper, double min,
           ContactSet& set) {
    const Vec3 apart = chain.position.at(upper) - chain.position.at(lower);
    const double distance = apart.norm();
    const Vec3 normal = distance > 1e-9 * min ? Vec3(apart / distance) : Vec3::UnitZ();
    const double closing = dt * normal.dot(chain.velocity.at(lower) - chain.velocity.at(upper));
    if (distance - closing > min) return;
    const bool top = upper == chain.links;
    set.add(PairContact{.link_a = top ? upper - 1 : upper,
                        .link_b = lower,
                        .at_a = top ? 1.0 : 0.0,
                        .at_b = 0,
                        .normal = toppled(normal, lower),
                        .penetration = min - distance,
                        .stiffness = touch.stiffness,
                        .damping = touch.damping,
                        .friction = 0});
}

/// Whether limit() will have something to say of any node from first to last and the one so many links above.
bool any_folded(const ChainState& chain, double dt, int first, int last, int links, double min) {
    const double square = min * min * (1 + 1e-9); // for rounding
    std::int64_t folded = 0;
    WINDLASS_VECTORISE
    for (int i = first; i <= last; ++i) {
        const Vec3 apart = chain.position.at(i + links) - chain.position.at(i);
        const Vec3 parting = chain.velocity.at(i + links) - chain.velocity.at(i);
        const double distance2 = apart.squaredNorm();
        // Distance after the step times the one before: no root to draw.
        const double product = positive_part(distance2 + dt * apart.dot(parting));
        folded += product * product <= square * distance2 + 1e-30 ? 1 : 0;
    }
    return folded > 0;
}

} // namespace

void find_bend_limits(const ChainDef& def, const ChainState& chain, double dt, ContactSet& set) {
    constexpr int kRun = 32; // nodes looked at together
    const int n = chain.links;
    const LinkTouch touch = link_touch(def);
    const Least min(def);
    for (int first = chain.asleep; first <= n - 2; first += kRun) {
        const int last = std::min(first + kRun - 1, n - 2), last_of_two = std::min(last, n - 3);
        if (!any_folded(chain, dt, first, last, 1, min.one) &&
            !any_folded(chain, dt, first, last_of_two, 2, min.two))
            continue;
        for (int i = first; i <= last; ++i) {
            limit(chain, dt, touch, i, i + 1, min.one, set);
            if (i <= last_of_two) limit(chain, dt, touch, i, i + 2, min.two, set);
        }
    }
    find_bend_limits_at_top(def, chain, dt, set);
}

void find_bend_limits_at_top(const ChainDef& def, const ChainState& chain, double dt, ContactSet& set) {
    const int n = chain.links;
    const LinkTouch touch = link_touch(def);
    if (n - 2 >= chain.asleep)
        limit(chain, dt, touch, n - 2, n, min_distance(def, def.node_spacing + chain.top_length), set);
    limit(chain, dt, touch, n - 1, n, min_distance(def, chain.top_length), set);
}

double bend_room(const ChainDef& def, const ChainState& chain) {
    const Least min(def);
    double room = 1e300;
    for (int i = chain.asleep; i <= chain.links - 2; ++i) {
        const Vec3 at = chain.position.at(i);
        room = std::min(room, (chain.position.at(i + 1) - at).norm() - min.one);
        if (i <= chain.links - 3) room = std::min(room, (chain.position.at(i + 2) - at).norm() - min.two);
    }
    return room;
}

} // namespace windlass::physics
