#include "server/physics/chain/shackle_marks.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {
constexpr int kMarksRestart =
    6; ///< shackle from which the marks count from 1 again (zjsnac.com, crews' slides)
constexpr int kLastLengths = 2; ///< before the bitter end, painted in the warning colour: 1 or 2 (the same)
} // namespace

int joining_shackles(const ChainDef& def) {
    constexpr double kRemainder = 0.01; // m: a cable of whole lengths has none at its bitter end
    return std::max(0, static_cast<int>(std::ceil((def.length - kRemainder) / kShackleLength)) - 1);
}

ShackleMark shackle_mark(const ChainDef& def, int n) {
    const int lengths = joining_shackles(def) + 1;
    return {.shackle = n,
            .from_anchor = n * kShackleLength,
            .white_links = (n - 1) % (kMarksRestart - 1) + 1,
            .last = lengths - n <= kLastLengths};
}

double joining_shackle_within(const ChainDef& def, double length) {
    const int reached = static_cast<int>(length / kShackleLength);
    return std::clamp(reached, 1, std::max(1, joining_shackles(def))) * kShackleLength;
}

Vec3 point_of_cable(const ChainDef& def, const ChainState& state, double from_anchor) {
    const int top = state.links - 1;
    const int link = std::clamp(static_cast<int>(from_anchor / def.node_spacing), 0, top);
    const double over = (from_anchor - link * def.node_spacing) * (1 + state.stretch[link]);
    const double along = over / link_length(def, state, link);
    const Vec3 below = state.position.at(link), above = state.position.at(link + 1);
    return below + std::clamp(along, 0.0, 1.0) * (above - below);
}

} // namespace windlass::physics
