// Keeps the waves of taut, undamped chain that touches nothing in phase: of fourth order in the step.
//
// Lengthwise. With Newmark's mean pull F = T + d2T / 4, d2T = T(n+1) - 2 T(n) + T(n-1), a mode of x = (w
// dt)^2 is late by x / 12 of its phase: most of what a swing errs by. T + d2T / 12 is of fourth order
// (Numerov; Hairer, Norsett, Wanner 1993, III.10), but not stable for stiff modes, x > 6. So the difference,
// d2T / 6, is taken off only after it has passed twice through U = 1 / (1 + x / 4), which is what Newmark's
// matrix makes of tensions, F = U T:
//     F - U U d2T / 6,  and T(n+1), as the lengths then have it, more by 4 (U - U U) d2T / 6.
// The phase then errs by 0.033 x^2. Of a mode a step makes 4 sin^2(w' dt / 2) = 4 (1 - U)(1 + 2/3 U (1 - U)),
// never beyond 4: stable for every x; and the same forwards and backwards, so that energy stays. U needs no
// matrix of its own: the rows of the last iteration are solved again.
//
// Crosswise, in air. The links pull along the directions that they have at x + dt^2 / 12 d2x/dt^2 instead of
// x: the leapfrog of fourth order, up to a change of variables (Takahashi, Imada 1984).

#include "server/physics/base/fused.hpp"
#include "server/physics/base/vectorise.hpp"
#include "server/physics/solver/chain_solver.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

namespace windlass::physics {

namespace {

/// Tensions that change by more than this share in a step are not resolved by it: nothing is gained, and
/// links that have just come taut, or fold, may be thrown about.
constexpr double kMaxChange = 0.1;

} // namespace

/// Whether phase is worth its price, and can be kept: damped chain has stopped ringing before it counts, and
/// what seabed and contacts do is of second order at most. Steps of one size only.
bool ChainSolver::in_phase(const ChainState& state, bool touching) const {
    return def_.damping_time == 0 && time_.dt == state.last_step && !touching &&
           motion_.bed_first > motion_.bed_last;
}

/// Turns the links' directions to where they are a twelfth of the step's way under the present tensions.
/// Where masses are even: in water drag ends waves across the chain sooner than their phase counts.
void ChainSolver::lead_directions(const ChainState& state) {
    const int foot = state.asleep, top = state.links - 1;
    const std::vector<double>& inverse = motion_.even_inverse;
    // What the pulls of its neighbours and, at the ends, weights do to a link. Its own pull does nothing
    // across it.
    const auto lead = [&](int i, const Vec3& turned) WINDLASS_INLINE {
        const Vec3 g = direction_.at(i);
        led_.set(i, fused(1 - fused_dot(turned, g), g, turned));
    };
    const auto below = [&](int i, double share) WINDLASS_INLINE {
        return Vec3((share * inverse[i] * state.spring[i - 1]) * direction_.at(i - 1));
    };
    const auto and_above = [&](int i, double share, const Vec3& other) WINDLASS_INLINE {
        return fused(share * inverse[i + 1] * state.spring[i + 1], direction_.at(i + 1), other);
    };
    const double share = reach_ / (12 * def_.node_spacing);
    WINDLASS_VECTORISE
    for (int i = foot + 1; i < top; ++i)
        lead(i, and_above(i, share, below(i, share)));

    const auto falls = [&](int i) -> Vec3 { // m, what node i does by itself besides going on as it went
        return motion_.place.at(i) - state.position.at(i) - time_.dt * state.velocity.at(i);
    };
    for (const int i : {foot, top}) { // the nodes between fall alike
        const double own_share = reach_ / (12 * length_[i]);
        Vec3 turned = (falls(i + 1) - falls(i)) / (12 * length_[i]);
        if (i > foot) turned += below(i, own_share);
        if (i < top) turned = and_above(i, own_share, turned);
        lead(i, turned);
    }
    std::swap(direction_, led_);
}

/// Once the pulls are known: changes them, and the matrix' right side, by which the nodes are to move yet.
/// Leaves all as it was if a link was slack, would be, or changes its tension too much.
void ChainSolver::keep_phase(const ChainState& state) {
    const int foot = state.asleep, top = state.links - 1;
    const double over_stiffness = 1 / def_.stiffness;
    std::int64_t rough = 0;
    const auto begin = [&](int i, double rest) WINDLASS_INLINE {
        const double change = pull_[i] - state.spring[i];           // F - T = d2T / 4
        rough += std::abs(change) > kMaxChange * known_[i] ? 1 : 0; // known_ is 0 of one that was slack
        // Newton's rows have tensions times the compliance over their weight.
        passes_[i] = matrix_.diagonal_inverse[i] * over_weight_[i] * (rest * over_stiffness);
        once_[i] = passes_[i] * change;
    };
    WINDLASS_VECTORISE
    for (int i = foot; i < top; ++i)
        begin(i, def_.node_spacing * (1 + state.stretch[i]));
    begin(top, state.top_length + deck_length_);
    if (rough > 0) return;
    matrix_.solve_again(foot, top, once_);
    WINDLASS_VECTORISE
    for (int i = foot; i <= top; ++i)
        twice_[i] = passes_[i] * once_[i];
    matrix_.solve_again(foot, top, twice_);

    constexpr double kShare = -4.0 / 6;
    WINDLASS_VECTORISE
    for (int i = foot; i <= top; ++i) {
        const double known = std::fma(kShare, once_[i], known_[i]), more = kShare * twice_[i];
        const double pull = pull_[i] + more;
        rough += std::abs(more) > kMaxChange * known || pull <= known ? 1 : 0;
        once_[i] = known;
        twice_[i] = more;
    }
    if (rough > 0) return;
    WINDLASS_VECTORISE
    for (int i = foot; i <= top; ++i) {
        matrix_.right[i] += twice_[i];
        pull_[i] += twice_[i];
        known_[i] = once_[i]; // end_tension() is the difference of the two
    }
}

} // namespace windlass::physics
