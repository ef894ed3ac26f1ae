#include "server/physics/chain/chain_feed.hpp"

#include <algorithm>
#include <cassert>

namespace windlass::physics {

namespace {

/// Second derivative along the chain of a quantity with values a, b, c at three nodes; first and second are
/// the unstretched lengths (m) between them.
Vec3 curvature(const Vec3& a, const Vec3& b, const Vec3& c, double first, double second) {
    return ((c - b) / second - (b - a) / first) / (0.5 * (first + second));
}

/// Rest length that gives a top link of the present length (m) the tension T: rest (1 + T / EA) + deck T /
/// EA.
double rest_length(const ChainDef& def, double length, double tension, double deck_length) {
    return (length - deck_length * tension / def.stiffness) / (1 + tension / def.stiffness);
}

/// Where it hangs taut, the top link's rest length follows from its tension; slack, from the chain's measure.
void fit_top(const ChainDef& def, ChainState& state, double measured, double deck_length) {
    const int top = state.links - 1;
    const double length = (state.position.at(top + 1) - state.position.at(top)).norm();
    state.top_length = state.elastic_tension[top] > 0
                           ? rest_length(def, length, state.elastic_tension[top], deck_length)
                           : measured;
}

void insert_node(const ChainDef& def, ChainState& state, double feed_speed, double deck_length) {
    const int n = state.links, top = n - 1;
    const double spacing = piece_length(def, state, top), over = state.top_length - spacing;
    const Vec3 lower = state.position.at(top), lip = state.position.at(n);
    const Vec3 span = lip - lower;
    const double share = spacing / state.top_length;
    // Chain just below the lip runs out along the top link at the gypsy's speed.
    const Vec3 lip_velocity = state.velocity.at(n);
    const Vec3 chain_velocity = lip_velocity - feed_speed * span.normalized();

    Vec3 position = lower + share * span;
    Vec3 velocity = state.velocity.at(top) + share * (chain_velocity - state.velocity.at(top));
    if (top > 0) {
        const double bow = 0.5 * spacing * over;
        position -= bow * curvature(state.position.at(top - 1), lower, lip, spacing, state.top_length);
        velocity -= bow * curvature(state.velocity.at(top - 1), state.velocity.at(top), chain_velocity,
                                    spacing, state.top_length);
    }
    // Old middle of the link: at top_length / 2 from the node below; new ones: at spacing / 2 and spacing +
    // over / 2.
    const auto share_tension = [&](std::vector<double>& tension) {
        const double old = tension[top], between = 0.5 * (spacing + state.top_length);
        const double rate = top > 0 ? (old - tension[top - 1]) / between : 0; // N/m along the chain
        tension[top] = std::max(0.0, old - rate * 0.5 * over);
        tension[n] = std::max(0.0, old + rate * 0.5 * spacing);
        if (old == 0) tension[top] = tension[n] = 0;
    };
    for (std::vector<double>* tension : state.tensions())
        share_tension(*tension);
    // On the arc, at the distance from the node below that its tension asks for.
    if (state.elastic_tension[top] > 0)
        position = lower + (position - lower).normalized() * spacing *
                               (1 + state.elastic_tension[top] / def.stiffness);
    state.position.set(n + 1, lip);
    state.velocity.set(n + 1, lip_velocity);
    state.position.set(n, position);
    state.velocity.set(n, velocity);
    state.links = n + 1;
    fit_top(def, state, over, deck_length);
}

void remove_node(const ChainDef& def, ChainState& state, double deck_length) {
    const int n = state.links, top = n - 1;
    const double spacing = piece_length(def, state, top - 1), merged = spacing + state.top_length;
    const auto join_tension = [&](std::vector<double>& tension) {
        // Middle of the merged link, from those of the two: linear.
        const double place = (0.5 * merged - 0.5 * spacing) / (0.5 * merged);
        const double below = tension[top - 1], above = tension[top];
        tension[top - 1] = below == 0 || above == 0 ? 0 : below + place * (above - below);
    };
    for (std::vector<double>* tension : state.tensions())
        join_tension(*tension);
    state.position.set(top, state.position.at(n));
    state.velocity.set(top, state.velocity.at(n));
    state.links = n - 1;
    fit_top(def, state, merged, deck_length);
}

} // namespace

bool feed_chain(const ChainDef& def, ChainState& state, double feed_speed, double deck_length) {
    assert(state.links > 0 && !(state.top_length <= 0) && "some of the cable is outboard");
    const double min = 0.5 * def.node_spacing;
    while (state.top_length > min + piece_length(def, state, state.links - 1)) {
        if (state.links >= static_cast<int>(state.tension.size())) return false;
        insert_node(def, state, feed_speed, deck_length);
    }
    // A bare end keeps its last link, however short: the one below it spans to where the rest of it fell.
    while (state.top_length < min && state.links > 1 && state.links - 2 != state.parted)
        remove_node(def, state, deck_length);
    return true;
}

} // namespace windlass::physics
