#include "server/physics/lod/recent_load.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

// Chosen on eight anchorings in 15 to 60 m of a Panamax and a Capesize, before anchors fell as they do now:
// of what covers, what is small when nothing happens.
constexpr double kMeanTime = 0.5;   ///< s
constexpr double kSlowTime = 5;     ///< s
constexpr double kForgetTime = 60;  ///< s
constexpr double kLoadNow = 0.2;    ///< error of the load in its unsteadiness now
constexpr double kLoadLater = 0.1;  ///< ... in what it was; the other computation's snap may yet come
constexpr double kShapeLater = 0.5; ///< m, the same of the shape
constexpr double kLoadPoor = 0.02;  ///< error of the load if every step were poor
constexpr double kShapePoor = 0.25; ///< m, the same of the shape: cable is heaped on the anchor, and wedged

/// Share of what is new in the mean of so many seconds.
double share(double dt, double time) {
    return dt / (time + dt);
}

} // namespace

void follow_load(double load, bool poor, double dt, RecentLoad& recent) {
    assert(dt > 0 && "a step takes time");
    if (recent.mean < 0) recent.mean = recent.slow = load;
    recent.mean += share(dt, kMeanTime) * (load - recent.mean);
    const double off = recent.mean - recent.slow;
    recent.slow += share(dt, kSlowTime) * off;
    recent.square += share(dt, kSlowTime) * (off * off - recent.square);
    recent.shaken = std::max(unsteadiness(recent), recent.shaken * (1 - share(dt, kForgetTime)));
    recent.poor += share(dt, kSlowTime) * ((poor ? 1 : 0) - recent.poor);
}

double unsteadiness(const RecentLoad& recent) {
    const double spread = std::sqrt(recent.square);
    return spread > 0 ? spread / std::max(recent.mean, spread) : 0;
}

ModelError unsteady_error(const RecentLoad& recent) {
    return {std::max(kLoadNow * unsteadiness(recent), kLoadLater * recent.shaken) + kLoadPoor * recent.poor,
            std::hypot(kShapeLater * recent.shaken, kShapePoor * recent.poor)};
}

template <class Visitor, StateOf<RecentLoad> State>
void visit_state(Visitor& v, State& recent) {
    auto& [mean, slow, square, shaken, poor] = recent;
    WINDLASS_STATE(v, mean, slow, square, shaken, poor);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, mean, slow);
    v.within({"square"}, square, 0, kStrongest * kStrongest);
    v.within({"shaken"}, shaken, 0, 1);
    v.within({"poor"}, poor, 0, 1);
}
WINDLASS_STATE_LISTED(RecentLoad);

} // namespace windlass::physics
