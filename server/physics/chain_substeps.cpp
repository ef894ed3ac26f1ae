#include "server/physics/chain_substeps.hpp"

#include "server/physics/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kMostWay = 0.5;  ///< of a link, that a transverse wave may go in a step
constexpr double kMostTurn = 0.5; ///< rad, of a link in a step
constexpr double kMostFall = 0.1; ///< of a link, that a node may fall from rest in a step

/// A step is made longer when this share of the present substeps would do: each change of step sets the
/// stiffest links ringing, and none is made for a trifle.
constexpr double kFewer = 0.4;

/// Largest difference of speed between two neighbouring nodes, m/s.
double largest_difference(const ChainState& state) {
    double lane[4] = {};
    const auto look = [&](int i, double& most) {
        const Vec3 apart = state.velocity.at(i + 1) - state.velocity.at(i);
        const double square = apart.squaredNorm();
        most = square > most ? square : most;
    };
    int i = state.asleep;
    for (; i + 4 <= state.links; i += 4)
        for (int k = 0; k < 4; ++k)
            look(i + k, lane[k]);
    for (; i < state.links; ++i)
        look(i, lane[0]);
    return std::sqrt(std::max(std::max(lane[0], lane[1]), std::max(lane[2], lane[3])));
}

} // namespace

int chain_substeps(const ChainDef& def, const ChainState& state, double dt, int most) {
    const double tension = largest(&state.tension[state.asleep], state.links - state.asleep);
    const double link = def.node_spacing;
    const double wave = dt * std::sqrt(tension / def.mass_per_metre) / (kMostWay * link);
    const double turn = dt * largest_difference(state) / (kMostTurn * link);
    const double fall = dt * std::sqrt(0.5 * kGravity / (kMostFall * link));
    const double wanted = std::max({wave, turn, fall});
    if (!(wave < most) || !(turn < most)) return most; // also if it is not a number
    const double present = state.last_step > 0 ? std::round(dt / state.last_step) : 0;
    if (present <= most && wanted <= present && wanted > kFewer * present) return static_cast<int>(present);
    int substeps = 1;
    while (substeps < wanted && substeps < most)
        substeps *= 2;
    return std::min(substeps, most);
}

} // namespace windlass::physics
