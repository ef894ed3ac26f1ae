#include "server/physics/lod/sleep.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/lod/catenary_spring.hpp"
#include "server/physics/sea/ground.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <stdexcept>

namespace windlass::physics {

namespace {

constexpr double kSleepLookTime = 0.25; ///< s between two looks at the chain
/// s that chain must have been still. A cable that comes to strain pulls its bights straight snap by snap:
/// with 2 s, chain slept between two of them. Of four anchorings a millimetre of water apart each, against
/// the same without sleep: 2 s 0.98 and 1.28 % of load, 5 s 0.80 and 1.12 %, a millimetre alone 0.3 to 0.5.
constexpr double kStillTime = 5;
constexpr double kSettled = 2e-3; ///< m/s; a cable that was strained settles so slowly for minutes
constexpr double kLying = 0.3;    ///< m above the bottom at which a node counts as lying (the chain's width)
constexpr double kMargin = 3;     ///< m of lying chain that stay awake, for the touchdown to move in
constexpr double kChunk = 8;      ///< m that wake at once
constexpr double kLifted = 0.05;  ///< m by which chain just above the sleeping part may rise or sink
/// Share of friction that is counted upon: what works along the chain is lost to what holds it aside.
/// Measured over a whole anchoring against the same without sleep: 0.7 differs by 2.0 % of load, 0.4 by 1.1,
/// 0.25 by 0.7, 0.1 by 0.4, which is what a millimetre of water makes; the chain sleeps as long with each.
/// That was while slack links were taken to hold a pull; since then 0.4 has come out as 0.1 does.
constexpr double kSure = 0.1;
constexpr double kSlack = 1e-3; ///< of its length, by which a link is shorter that has chain to give
constexpr int kFewest = 4;      ///< links; fewer are not worth it

double height(const EnvironmentDef& environment, const ChainState& chain, int i) {
    return height_over_bed(environment, chain.position.at(i));
}

/// Sine of the angle, seen from above, by which the chain turns at node i; 1 where it turns back.
double turn(const ChainState& chain, int i) {
    const Vec3 below = chain.position.at(i) - chain.position.at(i - 1);
    const Vec3 above = chain.position.at(i + 1) - chain.position.at(i);
    const double scale = std::hypot(below.x(), below.y()) * std::hypot(above.x(), above.y());
    if (scale <= 0 || below.x() * above.x() + below.y() * above.y() < 0) return 1;
    return std::abs(below.x() * above.y() - below.y() * above.x()) / scale;
}

/// Below node i the chain lies in bights too small for the links to show: nothing there keeps it from coming.
bool slack_below(const ChainDef& def, const ChainState& chain, int i) {
    return (chain.position.at(i) - chain.position.at(i - 1)).norm() <
           (1 - kSlack) * link_length(def, chain, i - 1);
}

} // namespace

int Sleep::links_in(double metres) const {
    return std::max(1, static_cast<int>(std::ceil(metres / chain_.node_spacing)));
}

double Sleep::friction(const EnvironmentDef& environment, const ChainState& chain, int i) const {
    const double grip = bed_grip(environment, chain.position.x[i], chain.position.y[i]);
    return grip * weight_in_water(chain_, environment.water_density);
}

bool Sleep::over_budget(const EnvironmentDef& environment, const ChainState& chain) const {
    const ModelError now = error(environment, chain);
    return now.load > budget_.load || now.shape > budget_.shape;
}

bool Sleep::must_wake(const EnvironmentDef& environment, const ChainState& chain) const {
    const int foot = chain.asleep, margin = foot + links_in(0.5 * kMargin);
    const double pull = chain.tension[foot];
    if (pull > state_.holds || margin >= chain.links) return true;
    if (std::abs(height(environment, chain, margin) - state_.margin_height) > kLifted) return true;
    // The waking end must not be pulled aside.
    return pull * turn(chain, foot) > kSure * friction(environment, chain, foot) * chain_.node_spacing;
}

/// Links from the anchor up whose nodes lie still. Near the anchor the cable may hang from its shackle; what
/// keeps that still is the chain that lies beyond.
int Sleep::still_links(const EnvironmentDef& environment, const ChainState& chain) const {
    const auto still = [&](int i) { return chain.velocity.at(i).squaredNorm() < kSettled * kSettled; };
    int node = chain.asleep + 1;
    if (chain.asleep == 0)
        while (node < chain.links && still(node) && height(environment, chain, node) >= kLying)
            ++node;
    const int first = node;
    while (node < chain.links && still(node) && height(environment, chain, node) < kLying)
        ++node;
    return node - first < links_in(kChunk) && chain.asleep == 0 ? 0 : node - 1;
}

void Sleep::work_out_holds(const EnvironmentDef& environment, const AnchorAtRest& anchor,
                           const ChainState& chain) {
    const double h = chain_.node_spacing;
    const int foot = chain.asleep;
    // A node feels more than the tension with which it fell asleep when the pull exceeds that by the friction
    // on the way to it; and it is pulled aside when its tension turns, or ends, by more than its friction.
    double way = 0; // N
    state_.holds = 1e300;
    for (int i = foot - 1; i >= 0; --i) {
        const bool lies = height(environment, chain, i) < kLying;
        const double rubs = kSure * friction(environment, chain, i);
        way += rubs * h;
        const double aside = i == 0 ? 0 : slack_below(chain_, chain, i) ? 1 : turn(chain, i);
        // What hangs from the anchor's shackle gives to any more pull.
        const double own = !lies ? 0 : i == 0 ? anchor.holds : aside > 0 ? rubs * h / aside : 1e300;
        const double holds = std::max(chain.tension[i], own) + way;
        if (holds < state_.holds) state_.holds = holds, state_.weakest = i;
        if (!lies) break;
    }
    state_.margin_height = height(environment, chain, foot + links_in(0.5 * kMargin));
    // It lies still under the pull that there is: so much it holds, and a little more.
    state_.holds =
        std::max(state_.holds, 1.05 * chain.tension[foot] + kSure * friction(environment, chain, foot) * h);
}

void Sleep::wake(ChainState& chain) {
    chain.asleep = 0;
    state_.settling = state_.settled = 0;
    state_.still_for = 0;
    state_.still_links = 0;
}

void Sleep::move_end(const EnvironmentDef& environment, const AnchorAtRest& anchor, int node,
                     ChainState& chain) {
    if (node < kFewest) {
        wake(chain);
        return;
    }
    for (int i = chain.asleep; i <= node; ++i)
        chain.velocity.set(i, Vec3::Zero());
    chain.asleep = node;
    state_.still_for = 0;
    work_out_holds(environment, anchor, chain);
}

bool Sleep::rest(const EnvironmentDef& environment, double dt, const ChainState& chain) {
    assert(dt > 0 && "a step takes time");
    state_.settled += state_.settling * dt;
    return !over_budget(environment, chain);
}

bool Sleep::watch(const EnvironmentDef& environment, const AnchorAtRest& anchor, double dt,
                  ChainState& chain) {
    if (chain.asleep > 0 && must_wake(environment, chain)) {
        const bool held = chain.tension[chain.asleep] <= state_.holds;
        const int from = held ? chain.asleep : std::min(chain.asleep, state_.weakest);
        move_end(environment, anchor, from - links_in(kChunk), chain);
        return false;
    }
    if (chain.asleep > 0) state_.settled += state_.settling * dt;
    // A snap that passes leaves the cable slack, and then what has settled is more of its load.
    if (chain.asleep > 0 && over_budget(environment, chain)) {
        wake(chain);
        return false;
    }
    state_.to_look -= dt;
    if (state_.to_look > 0) return false;
    state_.to_look = kSleepLookTime;
    if (!anchor.still && chain.asleep == 0) {
        state_.still_for = 0;
        return false;
    }
    const int still = still_links(environment, chain);
    state_.still_links = state_.still_for > 0 ? std::min(state_.still_links, still) : still;
    state_.still_for += kSleepLookTime;
    if (state_.still_for < kStillTime) return false;
    state_.still_for = 0;
    const int asleep = std::min(state_.still_links, chain.links - 1) - links_in(kMargin);
    // Not for a link or two: what friction holds is worked out anew each time.
    if (asleep < std::max(kFewest, chain.asleep + links_in(0.5 * kChunk))) return false;
    const int was_asleep = chain.asleep;
    const bool anchor_falls_asleep = was_asleep == 0;
    chain.asleep = asleep;
    if (over_budget(environment, chain)) { // a taut cable's own stretch is too much from the start
        chain.asleep = was_asleep;
        return false;
    }
    for (int i = was_asleep; i <= asleep; ++i) {
        state_.settling = std::max(state_.settling, chain.velocity.at(i).norm());
        chain.velocity.set(i, Vec3::Zero());
    }
    for (int i = was_asleep; i < asleep; ++i)
        chain.set_tension(i, chain.tension[i]);
    work_out_holds(environment, anchor, chain);
    return anchor_falls_asleep;
}

/// Settling draws chain from the touchdown towards the anchor, as if the ship moved away by as much.
ModelError Sleep::error(const EnvironmentDef& environment, const ChainState& chain) const {
    if (chain.asleep == 0) return {};
    const double w = weight_in_water(chain_, environment.water_density);
    const double stretch = chain.tension[chain.asleep] * chain.tension[chain.asleep] /
                           (2 * friction(environment, chain, chain.asleep) * chain_.stiffness);
    const double top = chain.tension[chain.links - 1];
    const Vec3 foot = chain.position.at(chain.asleep);
    const double height = chain.position.z[chain.links] - bed_height(environment, foot.x(), foot.y());
    const double spring = catenary_spring(w, height, top);
    return {(stretch + state_.settled) * spring / std::max(top, w * height), stretch + state_.settled};
}

template <class Visitor, StateOf<SleepState> State>
void visit_state(Visitor& v, State& state) {
    auto& [to_look, still_for, still_links, holds, margin_height, settling, settled, weakest] = state;
    WINDLASS_STATE(v, to_look, still_for, still_links, holds, margin_height, settling, settled, weakest);
    WINDLASS_WITHIN(v, -kLongest, kLongest, to_look, still_for);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, holds);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, margin_height, settling, settled);
}
WINDLASS_STATE_LISTED(SleepState);

} // namespace windlass::physics
