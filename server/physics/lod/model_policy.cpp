#include "server/physics/lod/model_policy.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

/// Links of length h land on the bottom one by one, so the load of a plumb cable is a saw of the height w h
/// around its true value w H: root mean square h / (2 sqrt(3) H), 1.9, 3.7 and 7.4 % with links of 2, 4 and
/// 8 m in 25 m of water. Its two-second mean sees less of that: over three whole anchorings 0.64 to 0.88, 1.1
/// to 1.6 and 2.7 to 3.2 % (docs/charts/anchoring.csv has the last), of which 0.4 or 0.5 % are luck that
/// links of 0.33 m have, too. Counted are 1.0, 2.1 and 4.1 %.
constexpr double kLoadPerLink = 0.16;

/// Where the cable comes down to the bottom it bends at nodes alone. Measured as above: 0.064, 0.12, 0.25
/// and 0.45 m with links of 0.84, 2, 4 and 8 m. Twice the shortest's is counted: what a single link does that
/// cannot be halved (the one across the surface, half of one at the lip, the one that parts) is seen, too.
constexpr double kShapePerMetre = 0.16;

constexpr double kShortest = 0.2, kLongestLink = 5; ///< m; the chart ends there
constexpr double kInPipe = 2;                       ///< m; half of it has room above a shank
constexpr double kMaxLinks = 2000;                  ///< that a ChainState sample can carry, and some to spare

} // namespace

ModelError spacing_error(double spacing, double hanging) {
    return {kLoadPerLink * spacing / hanging, kShapePerMetre * spacing};
}

ModelError together(const ModelError& a, const ModelError& b) {
    return {std::hypot(a.load, b.load), std::hypot(a.shape, b.shape)};
}

ModelError worse(const ModelError& a, const ModelError& b) {
    const auto of = [](double x, double y) { return std::min(x, y) < 0 ? -1 : std::max(x, y); };
    return {of(a.load, b.load), of(a.shape, b.shape)};
}

ModelError spacing_share(const ModelError& budget) {
    return {0.8 * budget.load, 0.8 * budget.shape};
}

ModelError saving_share(const ModelError& budget) {
    return {0.5 * budget.load, 0.5 * budget.shape};
}

double spacing_within(const ModelError& budget, double hanging, const ChainDef& chain, double cable_out) {
    const double wanted = std::min(budget.load * hanging / kLoadPerLink, budget.shape / kShapePerMetre);
    const double min = std::max(kShortest, chain.length / kMaxLinks);
    // The cable is at least half a link long; with its anchor home it goes up the pipe.
    const double max = cable_out > 0 ? std::min(kLongestLink, 2 * cable_out) : kInPipe;
    return std::floor(100 * std::clamp(wanted, min, std::max(min, max))) / 100;
}

template <class Visitor, StateOf<ModelError> State>
void visit_state(Visitor& v, State& error) {
    auto& [load, shape] = error;
    WINDLASS_STATE(v, load, shape);
    WINDLASS_WITHIN(v, 0, kMostEnergy, load, shape);
}
WINDLASS_STATE_LISTED(ModelError);

} // namespace windlass::physics
