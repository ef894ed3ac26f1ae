#include "server/physics/contact/link_wrap.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Faster than this (m/s) a link slides on an edge; slower, friction turns by and by into a damper, which
/// takes from a link that rings by some cm/s what friction by the sign of its speed would give it.
constexpr double kSlides = 0.2;

/// Of the edge's radius: a node nearer than this to where the link meets the edge lies on the edge.
constexpr double kShortest = 0.02;

/// Unit vector along the edge, square to a link's direction there.
Vec3 along_edge(const Edge& edge, const Vec3& along) {
    return (edge.along - edge.along.dot(along) * along).stableNormalized();
}

} // namespace

LinkWay way_round(const Edge& edge, const Vec3& lower, const Vec3& upper) {
    // Across the edge, x out of the body and y aside. The way turns clockwise about `along` (hand 1), or
    // against: from the node that lies further round to the other one.
    const Vec3 aside = edge.along.cross(edge.out), arm_a = lower - edge.foot, arm_b = upper - edge.foot;
    const double ax = arm_a.dot(edge.out), ay = arm_a.dot(aside);
    const double bx = arm_b.dot(edge.out), by = arm_b.dot(aside);
    const bool a_further = (ay >= 0) != (by >= 0) ? ay >= 0 : bx * ay >= by * ax;
    const double hand = a_further ? 1 : -1;
    struct End {
        double straight, x, y; // m of tangent; where it touches the edge, as a unit vector out of it
    };
    const auto end = [&](double x, double y, double turned) {
        const double square = x * x + y * y, tangent2 = square - edge.radius * edge.radius;
        if (tangent2 <= 0) { // in the edge's round
            const double size = std::sqrt(square);
            return size > 0 ? End{0, x / size, y / size} : End{0, 1, 0};
        }
        const double straight = std::sqrt(tangent2), scale = 1 / square;
        return End{straight, (edge.radius * x - turned * straight * y) * scale,
                   (edge.radius * y + turned * straight * x) * scale};
    };
    const End a = end(ax, ay, -hand), b = end(bx, by, hand);

    LinkWay way;
    way.straight_lower = a.straight, way.straight_upper = b.straight;
    way.cosine_lower = a.x, way.cosine_upper = b.x;
    const double sine = hand * (b.x * a.y - b.y * a.x);
    const Vec3 span = upper - lower;
    if (sine <= 0) {
        way.length = span.norm();
        way.at_lower = way.at_upper = way.length > 0 ? Vec3(span / way.length) : Vec3::UnitZ();
        return way;
    }
    way.turn = std::atan2(sine, a.x * b.x + a.y * b.y);
    const double across = a.straight + edge.radius * way.turn + b.straight, on = span.dot(edge.along);
    way.length = std::sqrt(across * across + on * on);
    const auto direction = [&](const End& touches) -> Vec3 {
        const Vec3 round = hand * (touches.y * edge.out - touches.x * aside);
        return (across * round + on * edge.along) / way.length;
    };
    way.at_lower = direction(a), way.at_upper = direction(b);
    return way;
}

bool LinkWraps::add(const Edge& edge) {
    if (wraps_.size() == wraps_.capacity()) return false;
    wraps_.push_back({.edge = edge,
                      .before = {},
                      .pull_on_lower = Vec3::Zero(),
                      .pull_on_upper = Vec3::Zero(),
                      .velocity = {Vec3::Zero(), Vec3::Zero()}});
    return true;
}

const LinkWraps::Wrap* LinkWraps::of(int link) const {
    for (const Wrap& wrap : wraps_)
        if (wrap.edge.link == link) return &wrap;
    return nullptr;
}

LinkWay LinkWraps::way_after(const Wrap& wrap, const Vec3& lower, const Vec3& upper) const {
    Edge edge = wrap.edge;
    edge.foot += time_.dt * edge.surface_velocity;
    return way_round(edge, lower, upper);
}

void LinkWraps::enter(const ChainState& state, const StepTime& time, SymmetricField& inverse_mass,
                      Field& predicted) {
    time_ = time;
    for (Wrap& wrap : wraps_) {
        const Edge& edge = wrap.edge;
        const int lower = edge.link, upper = lower + 1;
        wrap.before = way_round(edge, state.position.at(lower), state.position.at(upper));
        wrap.velocity = {state.velocity.at(lower), state.velocity.at(upper)};
        wrap.pull = 0;
        // Half of the change of pull at either end: F (1 + tanh(mu turn / 2)) / F (1 - tanh) = e^(mu turn).
        const Vec3 slide = 0.5 * (wrap.velocity[0] + wrap.velocity[1]) - edge.surface_velocity;
        const double along = 0.5 * ((wrap.velocity[0] - edge.surface_velocity).dot(wrap.before.at_lower) +
                                    (wrap.velocity[1] - edge.surface_velocity).dot(wrap.before.at_upper));
        const double sideways = slide.dot(edge.along), speed = std::sqrt(along * along + sideways * sideways);
        // Where the link slides, friction goes with the pull that is sought; where it hardly moves, it is a
        // damper, which also holds.
        const double max = std::tanh(0.5 * edge.friction * wrap.before.turn);
        const double slides = std::min(1.0, speed / kSlides);
        const double part = max * slides * along / std::max(speed, kFrictionCreep);
        wrap.pull_on_lower = (1 - part) * wrap.before.at_lower;
        wrap.pull_on_upper = (1 + part) * wrap.before.at_upper;
        const double tension = state.tension[edge.link];
        // By the node's own way over the edge: by the link's, whose ends may draw together while it stays,
        // a damper would hold either with any force, and a link once stretched would stay so.
        for (const int end : {0, 1}) {
            const Vec3& g = end == 0 ? wrap.before.at_lower : wrap.before.at_upper;
            const Vec3 off = wrap.velocity[end] - edge.surface_velocity;
            const double own = std::hypot(off.dot(g), off.dot(along_edge(edge, g)));
            wrap.rubbing[end] = (1 - slides) * max * tension / std::max({speed, own, kFrictionCreep});
        }
        if (wrap.before.turn <= 0) continue;
        const auto stiffness = [&](double straight) {
            const double free = std::max(straight, kShortest * edge.radius);
            return free < edge.radius ? tension * (1 / free - 1 / edge.radius) : 0;
        };
        enter(0, stiffness(wrap.before.straight_lower), wrap, state, inverse_mass, predicted);
        enter(1, stiffness(wrap.before.straight_upper), wrap, state, inverse_mass, predicted);
    }
}

/// At one node of a wrapped link: friction along the link and the edge; and across it the stiffness (N/m)
/// with which a taut link turns back a node that is near the edge, more than a step could follow otherwise.
void LinkWraps::enter(int end, double stiffness, const Wrap& wrap, const ChainState& state,
                      SymmetricField& inverse_mass, Field& predicted) const {
    const Edge& edge = wrap.edge;
    const int node = edge.link + end;
    const SymmetricMatrix before = inverse_mass.at(node);
    if (node == 0 || before.xx + before.yy + before.zz == 0) return; // held
    const Vec3 along = end == 0 ? wrap.before.at_lower : wrap.before.at_upper, side = along_edge(edge, along);
    SymmetricMatrix mass = before.inverse();
    const Vec3 start = state.position.at(node);
    Vec3 momentum = mass * ((predicted.at(node) - start) / time_.dt);
    const auto hold = [&](const Vec3& u, double by) {
        mass.xx += by * u.x() * u.x(), mass.yy += by * u.y() * u.y(), mass.zz += by * u.z() * u.z();
        mass.xy += by * u.x() * u.y(), mass.xz += by * u.x() * u.z(), mass.yz += by * u.y() * u.z();
        momentum += by * edge.surface_velocity.dot(u) * u;
    };
    hold(along, time_.kick * wrap.rubbing[end]);
    hold(side, time_.kick * wrap.rubbing[end]);
    hold(along.cross(side), time_.kick * time_.dt * stiffness);
    const SymmetricMatrix w = mass.inverse();
    inverse_mass.set(node, w);
    predicted.set(node, start + time_.dt * (w * momentum));
}

void LinkWraps::load(const std::vector<double>& pull, const Field* straight) {
    for (Wrap& wrap : wraps_) {
        wrap.pull = pull[wrap.edge.link];
        if (straight == nullptr) continue;
        wrap.before.at_lower = wrap.before.at_upper = straight->at(wrap.edge.link);
        wrap.pull_on_lower = wrap.pull_on_upper = wrap.before.at_lower;
    }
}

LinkWraps::Reaction LinkWraps::reaction(const Wrap& wrap, const ChainState& state) const {
    const Edge& edge = wrap.edge;
    const double pulled = time_.kick * wrap.pull;
    const Vec3 turned = pulled * (wrap.pull_on_lower - wrap.pull_on_upper);
    Reaction reaction{turned, -turned.dot(edge.surface_velocity)};
    for (const int end : {0, 1}) {
        const int node = edge.link + end;
        if (node == 0 || node == state.links) continue; // the anchor's and the lip's own business
        const Vec3 g = end == 0 ? wrap.before.at_lower : wrap.before.at_upper;
        const Vec3 side = along_edge(edge, g);
        // What friction takes of the pull on its way; the links' own balance knows nothing of it.
        const Vec3 lost = end == 0 ? Vec3(g - wrap.pull_on_lower) : Vec3(wrap.pull_on_upper - g);
        const Vec3 mean = 0.5 * (wrap.velocity[end] + state.velocity.at(node));
        reaction.work += pulled * lost.dot(mean - edge.surface_velocity);
        if (wrap.rubbing[end] == 0) continue;
        const Vec3 slide = state.velocity.at(node) - edge.surface_velocity;
        const Vec3 rubbed = -time_.kick * wrap.rubbing[end] * (slide.dot(g) * g + slide.dot(side) * side);
        reaction.impulse += rubbed;
        reaction.work -= rubbed.dot(mean);
    }
    return reaction;
}

} // namespace windlass::physics
