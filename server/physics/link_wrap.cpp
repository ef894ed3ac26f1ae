#include "server/physics/link_wrap.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Faster than this (m/s) a link slides on an edge; slower, friction turns by and by into a damper.
constexpr double kSlides = 0.05;

/// Of the edge's radius: a node nearer than this to where the link meets the edge lies on the edge.
constexpr double kShortest = 0.02;

} // namespace

LinkWay way_round(const Edge& edge, const Vec3& lower, const Vec3& upper) {
    const Vec3 aside = edge.along.cross(edge.out);
    struct End {
        double angle, meets, straight; // rad from `out`: of the node, of the tangent's foot; m of tangent
    };
    const auto end = [&](const Vec3& node) {
        const Vec3 arm = node - edge.foot;
        const double x = arm.dot(edge.out), y = arm.dot(aside), distance = std::hypot(x, y);
        const bool off = distance > edge.radius;
        return End{std::atan2(y, x), off ? std::acos(edge.radius / distance) : 0,
                   off ? std::sqrt(distance * distance - edge.radius * edge.radius) : 0};
    };
    const End a = end(lower), b = end(upper);
    const double hand = a.angle >= b.angle ? 1 : -1; // the way turns clockwise about `along`, or against
    const double meets = a.angle - hand * a.meets, leaves = b.angle + hand * b.meets;

    LinkWay way;
    way.straight_lower = a.straight, way.straight_upper = b.straight;
    way.reach_lower = meets, way.reach_upper = leaves;
    way.turn = hand * (meets - leaves);
    const Vec3 span = upper - lower;
    if (way.turn <= 0) {
        way.turn = 0;
        way.length = span.norm();
        way.at_lower = way.at_upper = way.length > 0 ? Vec3(span / way.length) : Vec3::UnitZ();
        return way;
    }
    const double across = a.straight + edge.radius * way.turn + b.straight, on = span.dot(edge.along);
    way.length = std::hypot(across, on);
    const auto direction = [&](double angle) -> Vec3 {
        const Vec3 round = hand * (std::sin(angle) * edge.out - std::cos(angle) * aside);
        return (across * round + on * edge.along) / way.length;
    };
    way.at_lower = direction(meets), way.at_upper = direction(leaves);
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
        const double speed = std::hypot(along, slide.dot(edge.along));
        // Where the link slides, friction goes with the pull that is sought; where it hardly moves, it is a
        // damper, which also holds.
        const double most = std::tanh(0.5 * edge.friction * wrap.before.turn);
        const double slides = std::min(1.0, speed / kSlides);
        const double part = most * slides * along / std::max(speed, kFrictionCreep);
        wrap.pull_on_lower = (1 - part) * wrap.before.at_lower;
        wrap.pull_on_upper = (1 + part) * wrap.before.at_upper;
        wrap.rubbing = (1 - slides) * most * state.tension[edge.link] / std::max(speed, kFrictionCreep);
        if (wrap.before.turn <= 0) continue;
        const double tension = state.tension[edge.link];
        const auto stiffness = [&](double straight) {
            const double free = std::max(straight, kShortest * edge.radius);
            return free < edge.radius ? tension * (1 / free - 1 / edge.radius) : 0;
        };
        enter(lower, wrap.before.at_lower, stiffness(wrap.before.straight_lower), wrap, state, inverse_mass,
              predicted);
        enter(upper, wrap.before.at_upper, stiffness(wrap.before.straight_upper), wrap, state, inverse_mass,
              predicted);
    }
}

/// At one node of a wrapped link: friction along the link and the edge; and across it the stiffness (N/m)
/// with which a taut link turns back a node that is near the edge, more than a step could follow otherwise.
void LinkWraps::enter(int node, const Vec3& along, double stiffness, const Wrap& wrap,
                      const ChainState& state, SymmetricField& inverse_mass, Field& predicted) const {
    const SymmetricMatrix before = inverse_mass.at(node);
    if (node == 0 || before.xx + before.yy + before.zz == 0) return; // held
    const Edge& edge = wrap.edge;
    const Vec3 side = (edge.along - edge.along.dot(along) * along).stableNormalized();
    SymmetricMatrix mass = before.inverse();
    const Vec3 start = state.position.at(node);
    Vec3 momentum = mass * ((predicted.at(node) - start) / time_.dt);
    const auto hold = [&](const Vec3& u, double by) {
        mass.xx += by * u.x() * u.x(), mass.yy += by * u.y() * u.y(), mass.zz += by * u.z() * u.z();
        mass.xy += by * u.x() * u.y(), mass.xz += by * u.x() * u.z(), mass.yz += by * u.y() * u.z();
        momentum += by * edge.surface_velocity.dot(u) * u;
    };
    hold(along, time_.kick * wrap.rubbing);
    hold(side, time_.kick * wrap.rubbing);
    hold(along.cross(side), time_.kick * time_.dt * stiffness);
    const SymmetricMatrix w = mass.inverse();
    inverse_mass.set(node, w);
    predicted.set(node, start + time_.dt * (w * momentum));
}

void LinkWraps::take(const std::vector<double>& pull, const Field* straight) {
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
        const Vec3 side = (edge.along - edge.along.dot(g) * g).stableNormalized();
        // What friction takes of the pull on its way; the links' own balance knows nothing of it.
        const Vec3 lost = end == 0 ? Vec3(g - wrap.pull_on_lower) : Vec3(wrap.pull_on_upper - g);
        const Vec3 mean = 0.5 * (wrap.velocity[end] + state.velocity.at(node));
        reaction.work += pulled * lost.dot(mean - edge.surface_velocity);
        if (wrap.rubbing == 0) continue;
        const Vec3 slide = state.velocity.at(node) - edge.surface_velocity;
        const Vec3 rubbed = -time_.kick * wrap.rubbing * (slide.dot(g) * g + slide.dot(side) * side);
        reaction.impulse += rubbed;
        reaction.work -= rubbed.dot(mean);
    }
    return reaction;
}

} // namespace windlass::physics
