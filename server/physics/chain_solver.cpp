#include "server/physics/chain_solver.hpp"

#include "server/physics/chain_balance.hpp"
#include "server/physics/lanes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace windlass::physics {

namespace {

/// A link that turns further than this in one step (cosine) is pulled along its new direction instead of its
/// old one: robust, first order.
constexpr double kFoldCosine = 0.9;
constexpr double kHardlyTurned = 0.9999;

/// Iterations after which a step is left to ImplicitStep. Newton needs one or two, unless links go slack or
/// come taut.
constexpr int kMostIterations = 12;

/// Shortfall of a link's length, as a fraction, within which it is first taken to be taut.
constexpr double kNearlyTaut = 1e-3;

/// Length (as a fraction of the spacing) below which a link has no direction.
constexpr double kPoint = 1e-9;

/// Each pull is solved to this part of a link's weight.
constexpr double kTolerance = 1e-4;

/// Share of the stability bound of transverse waves, T dt^2 = mu l^2, up to which a step keeps its
/// directions.
constexpr double kMostWave = 0.9;

/// A step is made longer when this share of the present substeps would do.
constexpr double kFewer = 0.4;

/// T(n-1) counts no more than this, however short the step before: T(n) must not count less than nothing.
constexpr double kMostBefore = 0.5;

/// Masses that resist alike in all directions: what a pull along a link does to its upper and lower nodes.
struct EvenMass {
    const std::vector<double>& inverse;
    const Field& direction;
    Vec3 up(int i) const { return inverse[i] * direction.at(i); }
    Vec3 down(int i) const { return inverse[i] * direction.at(i - 1); }
};

/// The same of other masses, worked out once for each step.
struct UnevenMass {
    const Field &up_, &down_;
    Vec3 up(int i) const { return up_.at(i); }
    Vec3 down(int i) const { return down_.at(i); }
};

} // namespace

/// How far Newton's method has come.
struct ChainSolver::Rows {
    bool steady = false; ///< all links taut
    bool turned = false; ///< some link has turned so far that its direction may have to follow
};

ChainSolver::ChainSolver(const ChainDef& def, int capacity, ForceWeights weights)
    : def_(def),
      weights_(weights),
      direction_(capacity),
      unit_(capacity),
      length_(capacity),
      weight_(capacity),
      known_(capacity),
      pull_(capacity),
      matrix_(capacity),
      motion_(capacity + 1),
      placed_(capacity + 1),
      up_(capacity + 1),
      down_(capacity + 1),
      implicit_(def, capacity) {}

ChainStepResult ChainSolver::step(ChainState& state, const EnvironmentDef& environment, double dt,
                                  const ChainTail& tail, TopDrive& drive, const Vec3& hawse,
                                  EnergyLedger* ledger, ContactSet* contacts) {
    time_ = {dt, step_kick(state, dt)};
    reach_ = time_.dt * time_.kick;
    damping_ = def_.damping_time / dt;
    deck_length_ = drive.deck_length();
    const ChainTail foot = state.asleep > 0 ? ChainTail{} : tail;
    measure_links(state, dt);
    move_freely(def_, environment, state, time_, foot, hawse, motion_);
    if (contacts != nullptr && !contacts->empty()) {
        give_each_node_its_matrix(state, motion_);
        contacts->enter(state, dt, motion_.inverse_mass, motion_.place);
    }

    ChainStepResult result;
    solve_directly(state, drive, contacts, result);
    if (result.implicit) {
        result.iterations += implicit_.solve(state, motion_, time_, {length_, damping_}, drive, result.travel,
                                             result.top, placed_, direction_, pull_);
        std::fill(weight_.begin(), weight_.begin() + state.links, 1);
        std::fill(known_.begin(), known_.begin() + state.links, 0);
    }
    if (ledger != nullptr) {
        const double feed_speed = 0.5 * (drive.speed_before() + result.travel / dt);
        balance_chain(def_, environment, state,
                      {placed_, direction_, pull_, length_, dt, time_.kick, result.travel, feed_speed,
                       deck_length_, foot.velocity_before},
                      *ledger);
    }
    finish(state, result);
    return result;
}

/// Length and direction of each link, what earlier tensions would contribute to its mean pull, and a first
/// guess of the pull.
void ChainSolver::measure_links(const ChainState& state, double dt) {
    const double least = kPoint * def_.node_spacing;
    // Second order also where the step before was longer or shorter.
    const double before =
        state.last_step > 0 ? std::min(kMostBefore, weights_.before * dt / state.last_step) : 0;
    const double now = 1 - weights_.next - before;
    WINDLASS_LANES
    for (int i = state.asleep; i < state.links; ++i) {
        const Vec3 d = state.position.at(i + 1) - state.position.at(i);
        const double length = d.norm();
        // A link of no length (slack chain fallen onto itself) has no direction; any will do, it does not
        // pull.
        const bool point = length < least;
        const double scale = point ? 0 : 1 / length;
        length_[i] = length;
        direction_.set(i, {d.x() * scale, d.y() * scale, point ? 1 : d.z() * scale});

        const double tension = state.tension[i], tension_before = state.tension_before[i];
        // A link that was slack has no past to weigh in: its new pull counts whole (implicit Euler).
        const bool fresh = tension * tension_before == 0;
        const double weighed = now * tension + before * tension_before;
        const double weight = fresh ? 1 : weights_.next, known = fresh ? 0 : weighed;
        weight_[i] = weight;
        known_[i] = known;
        pull_[i] = known + weight * tension;
    }
}

/// What a pull of one newton along each link does to its two nodes.
void ChainSolver::spread_pulls(const ChainState& state) {
    WINDLASS_LANES
    for (int i = state.asleep; i < state.links; ++i) {
        const Vec3 g = direction_.at(i);
        up_.set(i, motion_.inverse_mass.at(i) * g);
        down_.set(i + 1, motion_.inverse_mass.at(i + 1) * g);
    }
}

/// Tension of link i at the end of the step that goes with its mean pull, N. A pull below what earlier
/// tensions would make up means that the link went slack on the way: chain lets go at once and does not push.
inline double ChainSolver::end_tension(int i) const {
    return positive_part(pull_[i] - known_[i]) / weight_[i];
}

/// Places the nodes by what the given pulls (N, of each link) do in the step to nodes at the given places.
template <class Mass>
void ChainSolver::shift_nodes(const Mass& mass, const ChainState& state, const Field& from,
                              const std::vector<double>& pulls) {
    const int foot = state.asleep, n = state.links;
    placed_.set(foot, from.at(foot) + reach_ * pulls[foot] * mass.up(foot));
    WINDLASS_LANES
    for (int i = foot + 1; i < n; ++i)
        placed_.set(i, from.at(i) + reach_ * (pulls[i] * mass.up(i) - pulls[i - 1] * mass.down(i)));
    placed_.set(n, from.at(n) - reach_ * pulls[n - 1] * mass.down(n));
}

void ChainSolver::shift_nodes(const ChainState& state, const Field& from, const std::vector<double>& pulls) {
    if (motion_.even)
        shift_nodes(EvenMass{motion_.even_inverse, direction_}, state, from, pulls);
    else
        shift_nodes(UnevenMass{up_, down_}, state, from, pulls);
}

/// Newton's matrix: how far each link is from its length, and what the pulls around it do about that.
template <class Mass>
ChainSolver::Rows ChainSolver::set_up_rows(const Mass& mass, const ChainState& state, double doubt,
                                           double travel) {
    const int foot = state.asleep, n = state.links;
    const double gain = (1 + damping_) * reach_;
    const double least = kPoint * def_.node_spacing;
    std::int64_t turned = 0, slack_links = 0;
    const auto row = [&](int i, const Vec3& below, const Vec3& above, double before, double rest,
                         double compliance, double benefit) WINDLASS_INLINE {
        const Vec3 d = placed_.at(i + 1) - placed_.at(i);
        const double length = d.norm();
        const bool point = length < least;
        const double scale = point ? 0 : 1 / length;
        const Vec3 unit(d.x() * scale, d.y() * scale, point ? 1 : d.z() * scale);
        unit_.set(i, unit);
        turned += unit.dot(direction_.at(i)) < kHardlyTurned ? 1 : 0;
        const double stretch_before = positive_part(length_[i] - before);
        const double error =
            (1 + damping_) * (length - rest) - damping_ * stretch_before - compliance * end_tension(i);
        const double springy = compliance / weight_[i], stiff = 0; // going slack, it lets go without stretch
        const double give = pull_[i] >= known_[i] ? springy : stiff;
        const double diagonal = gain * unit.dot(mass.down(i + 1) + mass.up(i)) + give;
        const double inverse = 1 / diagonal;
        const double lower = gain * unit.dot(below) * inverse, upper = gain * unit.dot(above) * inverse,
                     right = error * inverse;
        // Slack: chain does not push. The first iteration gives links that are nearly taut the benefit of the
        // doubt, else a chain at rest would be found taut only link by link from its ends.
        const bool slack = pull_[i] * diagonal + error + benefit <= 0;
        slack_links += slack ? 1 : 0;
        matrix_.diagonal_inverse[i] = slack ? 1 : inverse;
        matrix_.lower[i] = slack ? 0 : lower;
        matrix_.upper[i] = slack ? 0 : upper;
        matrix_.right[i] = slack ? -pull_[i] : right;
    };
    const double spacing = def_.node_spacing, compliance = spacing / def_.stiffness;
    const Vec3 none = Vec3::Zero();
    if (n - foot > 1) row(foot, none, mass.up(foot + 1), spacing, spacing, compliance, doubt);
    WINDLASS_LANES
    for (int i = foot + 1; i < n - 1; ++i)
        row(i, mass.down(i), mass.up(i + 1), spacing, spacing, compliance, doubt);
    const bool steady = slack_links == 0;
    // The top link is what the windlass made of it, and never given up here: the drive line says when it is
    // slack.
    const double rest = state.top_length + travel;
    row(n - 1, n - foot > 1 ? mass.down(n - 1) : none, none, state.top_length, rest,
        (rest + deck_length_) / def_.stiffness, 1e9);
    return {steady, turned > 0};
}

ChainSolver::Rows ChainSolver::set_up_rows(const ChainState& state, double doubt, double travel) {
    return motion_.even ? set_up_rows(EvenMass{motion_.even_inverse, direction_}, state, doubt, travel)
                        : set_up_rows(UnevenMass{up_, down_}, state, doubt, travel);
}

/// Finds links that pull in vain along their direction at the start of the step: they turned too far, or a
/// node that the seabed holds turns the pull aside. Lets these pull along their present direction.
/// Returns whether any did so.
bool ChainSolver::turn_folded_links(const ChainState& state) {
    bool any = false;
    const auto is_folded = [&](int i) {
        const Vec3 unit = unit_.at(i);
        const double cosine = unit.dot(direction_.at(i));
        if (cosine < kFoldCosine || cosine >= kHardlyTurned || motion_.even) return cosine < kFoldCosine;
        const SymmetricMatrix &below = motion_.inverse_mass.at(i), &above = motion_.inverse_mass.at(i + 1);
        const double shortens = unit.dot(down_.at(i + 1) + up_.at(i));
        return shortens < 0.5 * unit.dot(below * unit + above * unit);
    };
    for (int i = state.asleep; i < state.links; ++i) {
        if (!is_folded(i)) continue;
        any = true;
        direction_.set(i, unit_.at(i));
    }
    if (!any) return false;
    if (!motion_.even) spread_pulls(state);
    shift_nodes(state, motion_.place, pull_);
    return true;
}

/// Newton's method on the pulls, until they are known or the step is to be left to ImplicitStep.
void ChainSolver::solve_directly(const ChainState& state, TopDrive& drive, ContactSet* contacts,
                                 ChainStepResult& result) {
    if (!motion_.even) spread_pulls(state);
    shift_nodes(state, motion_.place, pull_);
    const double link_mass = def_.mass_per_metre * def_.node_spacing;
    const double tolerance = kTolerance * link_mass * kGravity; // N, on each link's mean pull
    double doubt = kNearlyTaut * def_.node_spacing;
    while (result.iterations < kMostIterations) {
        ++result.iterations;
        Rows rows = set_up_rows(state, doubt, result.travel);
        const bool folded = rows.turned && turn_folded_links(state);
        if (folded) rows = set_up_rows(state, doubt, result.travel);
        doubt = 0;
        const double change = eliminate(state, drive, result);
        const bool steady = take_changes(state) && rows.steady;
        shift_nodes(state, placed_, matrix_.right);
        // Of an iteration that moves the nodes by d the next one would correct the lengths by d^2 / 2 l at
        // most (Newton converges quadratically). Where links are slack or change their mind, that is no
        // bound.
        const double error =
            steady ? std::min(change, change * change * reach_ / (2 * link_mass * def_.node_spacing))
                   : change;
        if (error < tolerance && !folded) {
            if (contacts == nullptr || contacts->empty() ||
                !contacts->revise(placed_, motion_.inverse_mass, motion_.place))
                break;
            // Contacts that let go or begin to bear are part of the same solution: on with Newton's method.
            spread_pulls(state);
            shift_nodes(state, motion_.place, pull_);
        }
        result.implicit = result.iterations == kMostIterations;
    }
    let_go_of_pushes(state);
    result.implicit = result.implicit || too_long(state);
}

/// Solves the rows from the anchor up and closes them with the drive line; the changes of the pulls are then
/// the matrix' right side. Returns the largest, N.
double ChainSolver::eliminate(const ChainState& state, TopDrive& drive, ChainStepResult& result) {
    const int top = state.links - 1;
    const double pivot = matrix_.eliminate(state.asleep, top);
    // What is left: pull against travel, one straight line.
    const double yielding =
        (1 + damping_ + end_tension(top) / def_.stiffness) * pivot * matrix_.diagonal_inverse[top];
    const double half_link = 0.5 * def_.mass_per_metre * state.top_length;
    result.top = {.dt = time_.dt,
                  .pull = pull_[top] + matrix_.right[top] + yielding * result.travel,
                  .yielding = yielding,
                  .outboard_mass = half_link,
                  .outboard_pull = half_link * kGravity * direction_.z[top]};
    result.travel = drive.travel(result.top);
    matrix_.right[top] = positive_part(result.top.pull - yielding * result.travel) - pull_[top];
    return matrix_.substitute(state.asleep, top);
}

/// Adds the changes to the pulls. Returns whether every link is on the same side of its known pull as before.
bool ChainSolver::take_changes(const ChainState& state) {
    std::int64_t changed = 0;
    WINDLASS_LANES
    for (int i = state.asleep; i < state.links; ++i) {
        const double was = pull_[i], is = was + matrix_.right[i], known = known_[i];
        changed += (was >= known) != (is >= known) ? 1 : 0;
        pull_[i] = is;
    }
    return changed == 0;
}

/// Chain does not push: what iteration left of pulls below zero is taken off.
void ChainSolver::let_go_of_pushes(const ChainState& state) {
    std::int64_t pushes = 0;
    WINDLASS_LANES
    for (int i = state.asleep; i < state.links; ++i)
        pushes += pull_[i] < 0 ? 1 : 0;
    if (pushes == 0) return;
    for (int i = state.asleep; i < state.links; ++i) {
        matrix_.right[i] = positive_part(-pull_[i]);
        pull_[i] = positive_part(pull_[i]);
    }
    shift_nodes(state, placed_, matrix_.right);
}

/// Whether transverse waves would run too far in this step: along directions of its start it would not be
/// stable.
bool ChainSolver::too_long(const ChainState& state) const {
    const double most = kMostWave * def_.mass_per_metre * def_.node_spacing * def_.node_spacing / reach_; // N
    std::int64_t over = 0;
    WINDLASS_LANES
    for (int i = state.asleep; i < state.links; ++i)
        over += pull_[i] > most ? 1 : 0;
    return over > 0;
}

void ChainSolver::finish(ChainState& state, ChainStepResult& result) {
    const int foot = state.asleep, n = state.links;
    result.tail_impulse = time_.kick * pull_[foot] * direction_.at(foot);
    result.hawse_impulse = -time_.kick * pull_[n - 1] * direction_.at(n - 1);
    result.top_pull = pull_[n - 1];
    const double rate = 1 / time_.dt;
    WINDLASS_LANES
    for (int i = foot; i <= n; ++i) {
        const Vec3 p = placed_.at(i);
        state.velocity.set(i, (p - state.position.at(i)) * rate);
        state.position.set(i, p);
    }
    WINDLASS_LANES
    for (int i = foot; i < n; ++i) {
        const double now = state.tension[i], next = end_tension(i);
        state.tension_before[i] = now;
        state.tension[i] = next;
    }
    state.top_length += result.travel;
    state.last_step = time_.dt;
}

int chain_substeps(const ChainDef& def, const ChainState& state, double dt, int most) {
    double tension = 0;
    for (int i = state.asleep; i < state.links; ++i)
        tension = std::max(tension, state.tension[i]);
    const double wave = std::sqrt(tension / def.mass_per_metre);
    const double wanted = dt * wave / (0.5 * def.node_spacing);
    if (!(wanted < most)) return most; // also if it is not a number
    // Each change of step sets the stiffest links ringing: none is made for a trifle.
    const double present = state.last_step > 0 ? std::round(dt / state.last_step) : 0;
    if (present <= most && wanted <= present && wanted > kFewer * present) return static_cast<int>(present);
    int substeps = 1;
    while (substeps < wanted && substeps < most)
        substeps *= 2;
    return std::min(substeps, most);
}

} // namespace windlass::physics
