#include "server/physics/chain_solver.hpp"

#include "server/physics/chain_balance.hpp"
#include "server/physics/lanes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

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

/// Added to what must not be zero, m2.
constexpr double kNearZero = 1e-300;

/// A benefit of the doubt, m, that no link outdoes.
constexpr double kNoDoubt = 1e9;

/// Length (as a fraction of the spacing) below which a link has no direction.
constexpr double kPoint = 1e-9;

/// Each pull is solved to this part of a link's weight.
constexpr double kTolerance = 1e-2;

/// Share of the stability bound of transverse waves, T dt^2 = mu l^2, up to which a step keeps its
/// directions.
constexpr double kMostWave = 0.9;

/// T(n-1) counts no more than this, however short the step before: T(n) must not count less than nothing.
constexpr double kMostBefore = 0.5;

/// Masses that resist alike in all directions: what a pull along a link does to its upper and lower nodes,
/// and what the pulls of a link, of the one below and of the one above do to its length along the given unit
/// vector.
struct EvenMass {
    const std::vector<double>& inverse;
    const Field& direction;
    Vec3 up(int i) const { return inverse[i] * direction.at(i); }
    Vec3 down(int i) const { return inverse[i] * direction.at(i - 1); }
    double own(int i, const Vec3& unit) const {
        return (inverse[i] + inverse[i + 1]) * unit.dot(direction.at(i));
    }
    double below(int i, const Vec3& unit) const { return inverse[i] * unit.dot(direction.at(i - 1)); }
    double above(int i, const Vec3& unit) const { return inverse[i + 1] * unit.dot(direction.at(i + 1)); }
};

/// The same of other masses, worked out once for each step.
struct UnevenMass {
    const Field &up_, &down_;
    Vec3 up(int i) const { return up_.at(i); }
    Vec3 down(int i) const { return down_.at(i); }
    double own(int i, const Vec3& unit) const { return unit.dot(down_.at(i + 1) + up_.at(i)); }
    double below(int i, const Vec3& unit) const { return unit.dot(down_.at(i)); }
    double above(int i, const Vec3& unit) const { return unit.dot(up_.at(i + 1)); }
};

} // namespace

/// What was seen while the rows of an iteration were set up.
struct ChainSolver::Rows {
    bool all_taut = false;
    bool turned = false; ///< some link has turned so far that its direction may have to follow
};

/// What the pulls are after an iteration.
struct ChainSolver::Pulls {
    bool steady = false;     ///< each on the same side of its known part as before
    bool push = false;       ///< some are below zero
    bool too_strong = false; ///< transverse waves run too far in this step: with the directions of its start
                             ///< it would not be stable
};

ChainSolver::ChainSolver(const ChainDef& def, int capacity, ForceWeights weights)
    : def_(def),
      weights_(weights),
      direction_(capacity),
      length_(capacity),
      over_weight_(capacity),
      known_(capacity),
      pull_(capacity),
      round_(capacity),
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
    wraps_ = nullptr;
    if (contacts != nullptr && !contacts->empty()) {
        give_each_node_its_matrix(state, motion_);
        contacts->enter(state, time_, motion_.inverse_mass, motion_.place);
        if (!contacts->wraps().empty()) lay_links_round_edges(*contacts);
    }

    ChainStepResult result;
    solve_directly(state, drive, contacts, result);
    if (result.implicit) {
        result.iterations += implicit_.solve(state, motion_, time_, {length_, damping_, round_}, drive,
                                             result.travel, result.top, placed_, direction_, pull_);
        std::fill(over_weight_.begin(), over_weight_.begin() + state.links, 1);
        std::fill(known_.begin(), known_.begin() + state.links, 0);
    }
    if (wraps_ != nullptr) wraps_->take(pull_, result.implicit ? &direction_ : nullptr);
    if (ledger != nullptr) {
        const double feed_speed = 0.5 * (drive.speed_before() + result.travel / dt);
        balance_chain(def_, environment, state,
                      {placed_, direction_, pull_, length_, dt, time_.kick, result.travel, feed_speed,
                       deck_length_, foot.velocity_before, wraps_},
                      *ledger);
    }
    finish(state, result);
    return result;
}

/// Links round edges start with the length of their way round, and pull along its ends.
void ChainSolver::lay_links_round_edges(ContactSet& contacts) {
    wraps_ = &contacts.wraps();
    for (const LinkWraps::Wrap& wrap : wraps_->all()) {
        const int i = wrap.edge.link;
        round_[i] = wrap.before.length - length_[i];
        length_[i] = wrap.before.length;
    }
}

/// Length and direction of each link, what earlier tensions would contribute to its mean pull, and a first
/// guess of the pull.
void ChainSolver::measure_links(const ChainState& state, double dt) {
    const double least = kPoint * def_.node_spacing;
    // Second order also where the step before was longer or shorter.
    const double before =
        state.last_step > 0 ? std::min(kMostBefore, weights_.before * dt / state.last_step) : 0;
    const double next = weights_.next, now = 1 - next - before, over_next = 1 / next;
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
        const double weight = fresh ? 1 : next, known = fresh ? 0 : weighed;
        over_weight_[i] = fresh ? 1 : over_next;
        known_[i] = known;
        const double ahead = fresh ? tension : positive_part(2 * tension - tension_before);
        pull_[i] = known + weight * ahead;
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
    if (wraps_ == nullptr) return;
    for (const LinkWraps::Wrap& wrap : wraps_->all()) {
        const int i = wrap.edge.link;
        up_.set(i, motion_.inverse_mass.at(i) * wrap.pull_on_lower);
        down_.set(i + 1, motion_.inverse_mass.at(i + 1) * wrap.pull_on_upper);
    }
}

/// Tension of link i at the end of the step that goes with its mean pull, N. A pull below what earlier
/// tensions would make up means that the link went slack on the way: chain lets go at once and does not push.
inline double ChainSolver::end_tension(int i) const {
    return positive_part(pull_[i] - known_[i]) * over_weight_[i];
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
    std::int64_t turned = 0, slack_links = 0;
    const auto row = [&](int i, auto has_below, auto has_above, double before, double rest, double compliance,
                         double benefit) WINDLASS_INLINE {
        // The whole row is multiplied by the link's length, which saves a division; kNearZero saves that of
        // nothing.
        const Vec3 span = placed_.at(i + 1) - placed_.at(i);
        const double length = span.norm();
        turned += span.dot(direction_.at(i)) < kHardlyTurned * length ? 1 : 0;
        const double stretch_before = positive_part(length_[i] - before);
        const double error =
            (1 + damping_) * (length - rest) - damping_ * stretch_before - compliance * end_tension(i);
        const double springy =
            pull_[i] >= known_[i] ? over_weight_[i] : 0; // going slack, it lets go without stretch
        const double diagonal = gain * mass.own(i, span) + springy * compliance * length;
        const double inverse = 1 / (diagonal + kNearZero);
        // Slack: chain does not push. The first iteration gives links that are nearly taut the benefit of the
        // doubt, else a chain at rest would be found taut only link by link from its ends.
        const bool slack = pull_[i] * diagonal + (error + benefit) * length <= 0;
        slack_links += slack ? 1 : 0;
        // Sums of both cases, of which one counts nothing: a branch would end the vectors.
        const double taut = slack ? 0 : inverse, free = slack ? 1 : 0;
        matrix_.diagonal_inverse[i] = taut * length + free;
        matrix_.right[i] = taut * error * length - free * pull_[i];
        if constexpr (has_below) matrix_.lower[i] = taut * gain * mass.below(i, span);
        if constexpr (has_above) matrix_.upper[i] = taut * gain * mass.above(i, span);
    };
    matrix_.lower[foot] = matrix_.upper[n - 1] = 0;
    const double spacing = def_.node_spacing, compliance = spacing / def_.stiffness;
    constexpr std::true_type yes;
    constexpr std::false_type no;
    if (n - foot > 1) row(foot, no, yes, spacing, spacing, compliance, doubt);
    WINDLASS_LANES
    for (int i = foot + 1; i < n - 1; ++i)
        row(i, yes, yes, spacing, spacing, compliance, doubt);
    const bool all_taut = slack_links == 0;
    // The top link is what the windlass made of it, and never given up here: the drive line says when it is
    // slack.
    const double rest = state.top_length + travel;
    const double top_compliance = (rest + deck_length_) / def_.stiffness;
    if (n - foot > 1)
        row(n - 1, yes, no, state.top_length, rest, top_compliance, kNoDoubt);
    else
        row(n - 1, no, no, state.top_length, rest, top_compliance, kNoDoubt);
    if (state.parted >= foot) { // slack, whatever its ends do
        matrix_.lower[state.parted] = matrix_.upper[state.parted] = 0;
        matrix_.diagonal_inverse[state.parted] = 1;
        matrix_.right[state.parted] = -pull_[state.parted];
    }
    return {all_taut, turned > 0};
}

/// The rows of links round edges: along their way, and with another direction at either end.
void ChainSolver::set_up_wrapped(const ChainState& state, double doubt, double travel) {
    const int foot = state.asleep, top = state.links - 1;
    const double gain = (1 + damping_) * reach_;
    for (const LinkWraps::Wrap& wrap : wraps_->all()) {
        const int i = wrap.edge.link;
        const bool at_top = i == top;
        const LinkWay way = wraps_->way_after(wrap, placed_.at(i), placed_.at(i + 1));
        const double before = link_length(def_, state, i), rest = before + (at_top ? travel : 0);
        const double compliance = (rest + (at_top ? deck_length_ : 0)) / def_.stiffness;
        const double error = (1 + damping_) * (way.length - rest) -
                             damping_ * positive_part(length_[i] - before) - compliance * end_tension(i);
        const double springy = pull_[i] >= known_[i] ? over_weight_[i] : 0;
        const double diagonal =
            gain * (way.at_upper.dot(down_.at(i + 1)) + way.at_lower.dot(up_.at(i))) + springy * compliance;
        const bool slack = pull_[i] * diagonal + error + (at_top ? kNoDoubt : doubt) <= 0;
        const double inverse = slack ? 0 : 1 / (diagonal + kNearZero);
        matrix_.diagonal_inverse[i] = slack ? 1 : inverse;
        matrix_.right[i] = slack ? -pull_[i] : error * inverse;
        if (i > foot) matrix_.lower[i] = inverse * gain * way.at_lower.dot(down_.at(i));
        if (i < top) matrix_.upper[i] = inverse * gain * way.at_upper.dot(up_.at(i + 1));
    }
}

ChainSolver::Rows ChainSolver::set_up_rows(const ChainState& state, double doubt, double travel) {
    if (motion_.even) return set_up_rows(EvenMass{motion_.even_inverse, direction_}, state, doubt, travel);
    Rows rows = set_up_rows(UnevenMass{up_, down_}, state, doubt, travel);
    if (wraps_ == nullptr) return rows;
    set_up_wrapped(state, doubt, travel);
    rows.all_taut = false; // as far as is known
    return rows;
}

/// Finds links that pull in vain along their direction at the start of the step: they turned too far, or a
/// node that the seabed holds turns the pull aside. Lets these pull along their present direction.
/// Returns whether any did so.
bool ChainSolver::turn_folded_links(const ChainState& state) {
    bool any = false;
    const auto unit_of = [&](int i) -> Vec3 {
        const Vec3 span = placed_.at(i + 1) - placed_.at(i);
        const double length = span.norm();
        return length < kPoint * def_.node_spacing ? Vec3::UnitZ() : Vec3(span / length);
    };
    const auto is_folded = [&](int i, const Vec3& unit) {
        const double cosine = unit.dot(direction_.at(i));
        if (cosine < kFoldCosine || cosine >= kHardlyTurned || motion_.even) return cosine < kFoldCosine;
        const SymmetricMatrix &below = motion_.inverse_mass.at(i), &above = motion_.inverse_mass.at(i + 1);
        const double shortens = unit.dot(down_.at(i + 1) + up_.at(i));
        return shortens < 0.5 * unit.dot(below * unit + above * unit);
    };
    for (int i = state.asleep; i < state.links; ++i) {
        const Vec3 unit = unit_of(i);
        if (!is_folded(i, unit) || (wraps_ != nullptr && wraps_->of(i) != nullptr)) continue;
        any = true;
        direction_.set(i, unit);
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
    Pulls pulls;
    bool converged = false;
    while (!converged && result.iterations < kMostIterations) {
        ++result.iterations;
        Rows rows = set_up_rows(state, doubt, result.travel);
        const bool folded = rows.turned && turn_folded_links(state);
        if (folded) rows = set_up_rows(state, doubt, result.travel);
        doubt = 0;
        const double change = eliminate(state, drive, result);
        pulls = take_changes(state);
        shift_nodes(state, placed_, matrix_.right);
        // Of an iteration that moves the nodes by d the next one would correct the lengths by d^2 / 2 l at
        // most (Newton converges quadratically). Where links are slack or change their mind, that is no
        // bound.
        const double square = change * change * reach_ / (2 * link_mass * def_.node_spacing);
        const double error = rows.all_taut && pulls.steady ? std::min(change, square) : change;
        converged = error < tolerance && !folded;
        if (converged && contacts != nullptr && !contacts->empty() &&
            contacts->revise(placed_, motion_.inverse_mass, motion_.place)) {
            // Contacts that let go or begin to bear are part of the same solution: on with Newton's method.
            spread_pulls(state);
            shift_nodes(state, motion_.place, pull_);
            converged = false;
        }
    }
    if (pulls.push) let_go_of_pushes(state);
    result.implicit = !converged || pulls.too_strong;
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

/// Adds the changes to the pulls and looks at what they have become.
ChainSolver::Pulls ChainSolver::take_changes(const ChainState& state) {
    // Transverse waves must not run further than this in a step that keeps its directions, N.
    const double most = kMostWave * def_.mass_per_metre * def_.node_spacing * def_.node_spacing / reach_;
    std::int64_t changed = 0, pushes = 0, over = 0;
    WINDLASS_LANES
    for (int i = state.asleep; i < state.links; ++i) {
        const double was = pull_[i], is = was + matrix_.right[i], known = known_[i];
        changed += (was >= known) != (is >= known) ? 1 : 0;
        pushes += is < 0 ? 1 : 0;
        over += is > most ? 1 : 0;
        pull_[i] = is;
    }
    return {changed == 0, pushes > 0, over > 0};
}

/// Chain does not push: what iteration left of pulls below zero is taken off.
void ChainSolver::let_go_of_pushes(const ChainState& state) {
    for (int i = state.asleep; i < state.links; ++i) {
        matrix_.right[i] = positive_part(-pull_[i]);
        pull_[i] = positive_part(pull_[i]);
    }
    shift_nodes(state, placed_, matrix_.right);
}

void ChainSolver::finish(ChainState& state, ChainStepResult& result) {
    const int foot = state.asleep, n = state.links;
    Vec3 at_foot = direction_.at(foot), at_lip = direction_.at(n - 1);
    if (wraps_ != nullptr) {
        for (const LinkWraps::Wrap& wrap : wraps_->all()) {
            if (wrap.edge.link == foot) at_foot = wrap.pull_on_lower;
            if (wrap.edge.link == n - 1) at_lip = wrap.pull_on_upper;
            round_[wrap.edge.link] = 0;
        }
    }
    result.tail_impulse = time_.kick * pull_[foot] * at_foot;
    result.hawse_impulse = -time_.kick * pull_[n - 1] * at_lip;
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

} // namespace windlass::physics
