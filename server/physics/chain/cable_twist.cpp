#include "server/physics/chain/cable_twist.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/base/turn.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kDegree = kTurn / 360;
constexpr double kTurnsPutIn = 8;  ///< by the fault in full; tuned
constexpr double kUpAndDown = 5;   ///< m off the anchor, nearer than which the cable has no bearing; tuned
constexpr double kSwivelTime = 10; ///< s in which a swivel off the bottom lets out most of the turns; tuned

/// Some 3 degrees a link turn with next to no torque; then chain quickly becomes stiff, until it knots up
/// (Chaplin, Rebel and Ridge, OTC 12173). How far until then, and what it does at the lip: tuned; 24 degrees
/// is the most at which twisted chain was tested (Ridge, Smedley and Hobbs, OMAE2011-49).
constexpr double kFree = 3 * kDegree, kKnots = 24 * kDegree;
constexpr double kLeft = 0.05; ///< of the efficiency, when it has knotted up; tuned

} // namespace

void follow_twist(const TwistStep& step, CableTwistState& state) {
    assert(step.dt > 0 && "a step takes time");
    assert(step.put_in >= 0 && step.put_in <= 1 && "a share");
    if (step.put_in == 0 && state.put_in > 0) state.turns = 0; // the instructor takes them out again
    state.turns += std::max(0.0, step.put_in - state.put_in) * kTurnsPutIn;
    state.put_in = step.put_in;

    const Vec3& way = step.to_anchor;
    const bool led = state.leads;
    state.leads = step.anchored && std::hypot(way.x(), way.y()) > kUpAndDown;
    if (!step.anchored) {
        state.turns *= std::exp(-step.dt / kSwivelTime);
        return;
    }
    state.turns += step.turned / kTurn;
    if (!state.leads) return;
    // Over the anchor the cable stands up and down, and leads off anew without having turned.
    const double bearing = std::atan2(way.x(), way.y());
    if (led) state.turns -= remainder_of_turn(bearing - state.bearing, kTurn) / kTurn;
    state.bearing = bearing;
}

double twist_per_link(const ChainDef& chain, double turns, double cable_out) {
    const double links = std::max(1.0, cable_out / (kLinksInDiameters * chain.diameter));
    return kTurn * std::abs(turns) / links;
}

double twisted_efficiency(double per_link) {
    const double share = std::clamp((per_link - kFree) / (kKnots - kFree), 0.0, 1.0);
    return 1 - share * (1 - kLeft);
}

double free_twist() {
    return kFree;
}

double knotting_twist() {
    return kKnots;
}

template <class Visitor, StateOf<CableTwistState> State>
void visit_state(Visitor& v, State& twist) {
    auto& [turns, leads, bearing, put_in] = twist;
    WINDLASS_STATE(v, turns, leads, bearing, put_in);
    WINDLASS_WITHIN(v, -kMostTurned, kMostTurned, turns, bearing);
    WINDLASS_WITHIN(v, 0, 1, put_in);
}
WINDLASS_STATE_LISTED(CableTwistState);

} // namespace windlass::physics
