#include "bench/methods/in_phase.hpp"

#include "bench/methods/tridiagonal.hpp"
#include "server/physics/chain/chain_forces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windlass::lab {

using namespace physics;

namespace {

/// Tensions that change by more than this share in a step are not resolved by it: nothing is gained, and
/// links that have just come taut, or fold, may be thrown about.
constexpr double kMaxChange = 0.1;

constexpr int kMaxIterations = 8;

/// Each pull is solved to this part of a link's weight.
constexpr double kTolerance = 1e-2;

} // namespace

InPhaseStep::InPhaseStep(const ChainDef& def, double bed_depth, int links)
    : def_(def),
      bed_depth_(bed_depth),
      inverse_(links + 1),
      free_(links + 1),
      placed_(links + 1),
      direction_(links),
      led_(links),
      known_(links),
      pull_(links),
      lower_(links),
      diagonal_(links),
      upper_(links),
      upper_left_(links),
      right_(links),
      once_(links),
      twice_(links) {}

bool InPhaseStep::step(ChainState& state, double dt, const ChainTail& tail, const Vec3& hawse) {
    if (!begin(state, dt, tail, hawse) || !solve(state) || !keep_phase(state)) return false;
    place_nodes(state.links);
    for (int i = 0; i <= state.links; ++i) {
        const Vec3 place = placed_.at(i);
        state.velocity.set(i, (place - state.position.at(i)) / dt);
        state.position.set(i, place);
    }
    for (int i = 0; i < state.links; ++i) {
        state.elastic_tension_earlier[i] = state.elastic_tension_before[i];
        state.elastic_tension_before[i] = state.elastic_tension[i];
        state.elastic_tension[i] = state.tension[i] = 4 * (pull_[i] - known_[i]);
    }
    state.last_step = dt;
    return true;
}

/// Where the nodes go by themselves, and what the links bring along.
bool InPhaseStep::begin(const ChainState& state, double dt, const ChainTail& tail, const Vec3& hawse) {
    const int n = state.links;
    if (dt != state.last_step || n < 2 || state.asleep > 0 || state.parted >= 0) return false;
    reach_ = dt * dt;
    inverse_[0] = tail.inverse_mass.xx;
    free_.set(0, state.position.at(0) + dt * tail.velocity);
    for (int i = 1; i < n; ++i) {
        inverse_[i] = 1 / (def_.mass_per_metre * node_length(def_, state, i));
        free_.set(i, state.position.at(i) + dt * (state.velocity.at(i) - Vec3(0, 0, dt * kGravity)));
    }
    inverse_[n] = 0;
    free_.set(n, hawse);
    for (int i = 0; i < n; ++i)
        if (state.position.z[i] < -bed_depth_) return false;
    bool taut = true;
    for (int i = 0; i < n; ++i) {
        const double now = state.elastic_tension[i], before = state.elastic_tension_before[i];
        taut = taut && now > 0 && before > 0;
        direction_.set(i, (state.position.at(i + 1) - state.position.at(i)).normalized());
        known_[i] = 0.5 * now + 0.25 * before;
        pull_[i] = known_[i] + 0.25 * positive_part(2 * now - before);
    }
    lead_directions(state);
    return taut;
}

/// Turns the links' directions to where they are a twelfth of the step's way under the present tensions.
void InPhaseStep::lead_directions(const ChainState& state) {
    const int n = state.links;
    const auto falls = [&](int i) -> Vec3 { // m, what node i does by itself besides going on as it went
        return free_.at(i) - state.position.at(i) - state.last_step * state.velocity.at(i);
    };
    const auto pulled = [&](int i) -> Vec3 { // and with its links
        Vec3 way = falls(i);
        if (i < n) way += reach_ * inverse_[i] * state.elastic_tension[i] * direction_.at(i);
        if (i > 0) way -= reach_ * inverse_[i] * state.elastic_tension[i - 1] * direction_.at(i - 1);
        return way;
    };
    for (int i = 0; i < n; ++i) {
        const Vec3 g = direction_.at(i);
        const double length = (state.position.at(i + 1) - state.position.at(i)).norm();
        const Vec3 turned = (pulled(i + 1) - pulled(i)) / (12 * length);
        led_.set(i, g + turned - turned.dot(g) * g);
    }
    std::swap(direction_, led_);
}

void InPhaseStep::place_nodes(int links) {
    for (int i = 0; i <= links; ++i) {
        Vec3 place = free_.at(i);
        if (i < links) place += reach_ * inverse_[i] * pull_[i] * direction_.at(i);
        if (i > 0) place -= reach_ * inverse_[i] * pull_[i - 1] * direction_.at(i - 1);
        placed_.set(i, place);
    }
}

/// Newmark's step, by Newton's method. False where links go slack or it comes to no end.
bool InPhaseStep::solve(const ChainState& state) {
    const int n = state.links;
    const double tolerance = kTolerance * def_.mass_per_metre * def_.node_spacing * kGravity;
    for (int k = 0; k < kMaxIterations; ++k) {
        place_nodes(n);
        for (int i = 0; i < n; ++i) {
            const Vec3 span = placed_.at(i + 1) - placed_.at(i);
            const double length = span.norm(), rest = link_length(def_, state, i);
            const double soft = 4 * rest / def_.stiffness; // m/N, of the mean pull
            const Vec3 unit = span / length;
            lower_[i] = i > 0 ? -reach_ * inverse_[i] * unit.dot(direction_.at(i - 1)) : 0;
            diagonal_[i] = reach_ * (inverse_[i] + inverse_[i + 1]) * unit.dot(direction_.at(i)) + soft;
            upper_[i] = i + 1 < n ? -reach_ * inverse_[i + 1] * unit.dot(direction_.at(i + 1)) : 0;
            right_[i] = length - rest - soft * (pull_[i] - known_[i]);
        }
        upper_left_ = upper_; // the solution uses it up
        solve_tridiagonal(lower_, diagonal_, upper_left_, right_);
        double change = 0;
        for (int i = 0; i < n; ++i) {
            pull_[i] += right_[i];
            if (!(pull_[i] > known_[i])) return false;
            change = std::max(change, std::abs(right_[i]));
        }
        if (change < tolerance) return true;
    }
    return false;
}

/// U, which is Newmark's matrix over what it has of tensions.
void InPhaseStep::pass(const ChainState& state, std::vector<double>& tensions) {
    for (int i = 0; i < state.links; ++i)
        tensions[i] *= 4 * link_length(def_, state, i) / def_.stiffness;
    upper_left_ = upper_;
    solve_tridiagonal(lower_, diagonal_, upper_left_, tensions);
}

/// Once the pulls are known. False if a link would be slack, or changes its tension too much.
bool InPhaseStep::keep_phase(const ChainState& state) {
    const int n = state.links;
    for (int i = 0; i < n; ++i) {
        once_[i] = pull_[i] - state.elastic_tension[i]; // F - T = d2T / 4
        if (std::abs(once_[i]) > kMaxChange * known_[i]) return false;
    }
    pass(state, once_);
    twice_ = once_;
    pass(state, twice_);
    constexpr double kShare = -4.0 / 6;
    for (int i = 0; i < n; ++i) {
        const double known = known_[i] + kShare * once_[i], more = kShare * twice_[i];
        if (std::abs(more) > kMaxChange * known || pull_[i] + more <= known) return false;
        known_[i] = known;
        pull_[i] += more;
    }
    return true;
}

} // namespace windlass::lab
