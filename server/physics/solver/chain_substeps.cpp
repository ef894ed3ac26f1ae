#include "server/physics/solver/chain_substeps.hpp"

#include "server/physics/base/vectorise.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace windlass::physics {

namespace {

constexpr double kMaxWay = 0.5;  ///< of a link, that a transverse wave may go in a step
constexpr double kMaxTurn = 0.5; ///< rad, of a link in a step
constexpr double kMaxFall = 0.1; ///< of a link, that a node may fall from rest in a step

/// A step is made longer when this share of the present substeps would do: a change of step feeds
/// or starves transverse waves, and none is made for a trifle.
constexpr double kFewer = 0.4;

/// Links that ask for more than a step gives them.
struct Asking {
    std::int64_t links;
    bool any() const { return links > 0; }
};

/// Those with more tension (N) than given, or whose ends differ more in speed (m/s), or of which that cannot
/// be said.
Asking count_above(const ChainState& state, double tension, double difference) {
    const double square = difference * difference;
    std::int64_t fit = 0;
    WINDLASS_VECTORISE
    for (int i = state.asleep; i < state.links; ++i) {
        const Vec3 apart = state.velocity.at(i + 1) - state.velocity.at(i);
        const double slack = state.tension[i] <= tension ? 1 : 0;
        const double slow = apart.squaredNorm() <= square ? slack : 0;
        fit += slow > 0 ? 1 : 0;
    }
    return {state.links - state.asleep - fit};
}

/// Largest difference of speed between two neighbouring nodes, m/s.
double largest_difference(const ChainState& state) {
    double lane[4] = {};
    const auto look = [&](int i, double& max) {
        const Vec3 apart = state.velocity.at(i + 1) - state.velocity.at(i);
        const double square = apart.squaredNorm();
        max = square > max ? square : max;
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

Substeps chain_substeps(const ChainDef& def, const ChainState& state, double dt, int max) {
    assert(dt > 0 && max >= 1 && "some time, in one substep at least");
    const double link = def.node_spacing;
    // Tension and difference of speed that ask for as many substeps as given.
    const auto tension_of = [&](double substeps) {
        const double wave = substeps * kMaxWay * link / dt;
        return def.mass_per_metre * wave * wave;
    };
    const auto turning_of = [&](double substeps) { return substeps * kMaxTurn * link / dt; };
    const double fall = dt * std::sqrt(0.5 * kGravity / (kMaxFall * link));

    // Mostly the present substeps will do, which a count tells sooner than a maximum.
    const double present = state.last_step > 0 ? std::round(dt / state.last_step) : 0;
    if (present >= 1 && present <= max && fall <= present) {
        const Asking more = count_above(state, tension_of(present), turning_of(present));
        const bool few = present == 1 || fall > kFewer * present ||
                         count_above(state, tension_of(kFewer * present), turning_of(kFewer * present)).any();
        if (!more.any() && few) return {static_cast<int>(present), true};
    }
    const double tension = largest(&state.tension[state.asleep], state.links - state.asleep);
    const double wave = dt * std::sqrt(tension / def.mass_per_metre) / (kMaxWay * link);
    const double turn = dt * largest_difference(state) / (kMaxTurn * link);
    if (!(wave < max) || !(turn < max)) return {max, false}; // also if it is not a number
    const double wanted = std::max({wave, turn, fall});
    int substeps = 1;
    while (substeps < wanted && substeps < max)
        substeps *= 2;
    return {std::min(substeps, max), true};
}

} // namespace windlass::physics
