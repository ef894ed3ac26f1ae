#include "server/physics/solver/chain_solver.hpp"

#include "server/physics/base/vectorise.hpp"
#include "server/physics/solver/chain_balance.hpp"
#include "server/physics/solver/friction_revision.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace windlass::physics {

namespace {

/// Iterations after which a step is left to ImplicitStep. Newton needs one or two, unless links go slack or
/// come taut; and as many again each time that friction or contacts turn out otherwise.
constexpr int kMaxIterations = 36;

/// Shortfall of a link's length, as a fraction, within which it is first taken to be taut.
constexpr double kNearlyTaut = 1e-3;

/// Each pull is solved to this part of a link's weight.
constexpr double kTolerance = 1e-2;

/// Share of the stability bound of transverse waves, T dt^2 = mu l^2, up to which a step keeps its
/// directions.
constexpr double kMaxWave = 0.9;

/// Times that a step looks anew which nodes slide on the seabed and which stick.
constexpr int kMaxRevisions = 4;

bool any(const ContactSet* contacts) {
    return contacts != nullptr && !contacts->empty();
}

/// Changes W and p* beneath what the contacts made of them.
template <class Change>
void beneath(ContactSet* contacts, FreeMotion& motion, const Change& change) {
    if (any(contacts)) contacts->take_off(motion.inverse_mass, motion.place);
    change();
    if (any(contacts)) contacts->put_on(motion.inverse_mass, motion.place);
}

} // namespace

ChainSolver::ChainSolver(const ChainDef& def, int capacity)
    : def_(def),
      direction_(capacity),
      length_(capacity),
      damping_(capacity),
      damped_(capacity),
      inverse_weight_(capacity),
      history_force_(capacity),
      pull_(capacity),
      round_(capacity),
      matrix_(capacity),
      motion_(capacity + 1),
      placed_(capacity + 1),
      up_(capacity + 1),
      down_(capacity + 1),
      implicit_(def, capacity) {}

CableInStep ChainSolver::predict(const ChainState& state, const EnvironmentDef& environment, double dt,
                                 const ChainTail& tail, const UpperEnd& drive, const Vec3& hawse) {
    assert(dt > 0 && "a step takes time");
    assert(state.asleep >= 0 && state.asleep < state.links && "one link at least is awake");
    assert(state.links <= static_cast<int>(pull_.size()) &&
           "no more links than the capacity given at the start");
    time_ = {dt, step_kick(state, dt)};
    reach_ = time_.dt * time_.kick;
    deck_length_ = drive.deck_length();
    const ChainTail foot = state.asleep > 0 ? ChainTail{} : tail;
    foot_velocity_ = foot.velocity_before;
    measure_links(state);
    damp_links(state, drive.speed_before());
    move_freely(def_, environment, state, time_, foot, hawse, motion_);
    return {&state, &motion_.inverse_mass, &motion_.place};
}

ChainStepResult ChainSolver::solve(ChainState& state, const EnvironmentDef& environment, UpperEnd& drive,
                                   EnergyLedger* ledger, ContactSet* contacts, const AnchorEnd* anchor) {
    assert(time_.dt > 0 && "predict() comes first");
    assert((anchor == nullptr || contacts != nullptr) && "an anchor is there for contacts with it");
    wraps_ = nullptr;
    friction_revisions_ = 0;
    if (any(contacts)) {
        contacts->enter(state, time_, motion_.inverse_mass, motion_.place, anchor);
        if (!contacts->wraps().empty()) lay_links_round_edges(state, drive.speed_before(), *contacts);
    }

    ChainStepResult result;
    solve_directly(state, drive, contacts, result);
    result.friction_given_up = friction_revisions_ == kMaxRevisions;
    result.contacts_unsettled = any(contacts) && contacts->unsettled(placed_);
    if (result.implicit) solve_implicitly(state, drive, contacts, result);
    if (wraps_ != nullptr) wraps_->load(pull_, result.implicit ? &direction_ : nullptr);
    if (ledger != nullptr) {
        const double feed_speed = 0.5 * (drive.speed_before() + result.travel / time_.dt);
        balance_chain(def_, environment, state,
                      {placed_, direction_, pull_, length_, time_.dt, time_.kick, result.travel, feed_speed,
                       deck_length_, foot_velocity_, wraps_, motion_.friction},
                      *ledger);
    }

    // The nodes have their places, and what they did to the chain's ends is known.
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
    WINDLASS_VECTORISE
    for (int i = foot; i <= n; ++i) {
        const Vec3 p = placed_.at(i);
        state.velocity.set(i, (p - state.position.at(i)) * rate);
        state.position.set(i, p);
    }
    take_tensions(state, result.travel);
    state.top_length += result.travel;
    state.last_step = time_.dt;
    time_ = {}; // the next step is to be predicted first
    return result;
}

/// The step that cannot fail, for one that was too long for its tension or hard to solve.
void ChainSolver::solve_implicitly(const ChainState& state, UpperEnd& drive, ContactSet* contacts,
                                   ChainStepResult& result) {
    beneath(contacts, motion_, [&] { make_friction_proportional(state, time_, motion_); });
    const ImplicitStep::Iterations taken =
        implicit_.solve(state, motion_, time_, {length_, def_.damping_time / time_.dt, round_}, drive,
                        result.travel, result.top, placed_, direction_, pull_);
    result.iterations += taken.count;
    result.unsolved = !taken.still;
    std::fill(inverse_weight_.begin(), inverse_weight_.begin() + state.links, 1);
    std::fill(history_force_.begin(), history_force_.begin() + state.links, 0);
    for (int i = state.asleep; i < state.links; ++i)
        damp(link_damping(state.last_step), i, length_[i] - link_length(def_, state, i), 0);
}

/// Newton's method on the pulls, until they are known or the step is to be left to ImplicitStep.
void ChainSolver::solve_directly(const ChainState& state, UpperEnd& drive, ContactSet* contacts,
                                 ChainStepResult& result) {
    spread_pulls(state);
    shift_nodes(state, motion_.place, pull_);
    const double link_mass = def_.mass_per_metre * def_.node_spacing;
    const double tolerance = kTolerance * link_mass * kGravity; // N, on each link's mean pull
    double doubt = kNearlyTaut * def_.node_spacing;
    Pulls pulls;
    bool converged = false;
    while (!converged && result.iterations < kMaxIterations) {
        ++result.iterations;
        Rows rows = set_up_rows(state, doubt, result.travel);
        const bool folded = rows.turned && turn_folded_links(state);
        if (folded) rows = set_up_rows(state, doubt, result.travel);
        doubt = 0;
        pulls = change_pulls(state, drive, result);
        // Of an iteration that moves the nodes by d the next one would correct the lengths by d^2 / 2 l at
        // most, l the shortest straight piece (Newton converges quadratically). Where links are slack or
        // change their mind, that is no bound.
        const double square = pulls.change * pulls.change * reach_ / (2 * link_mass * rows.shortest);
        const bool taut = rows.all_taut && pulls.steady;
        const double error = taut ? std::min(pulls.change, square) : pulls.change;
        const bool found = error < tolerance && !folded;
        shift_nodes(state, placed_, matrix_.right);
        converged = found && !revise(state, contacts);
    }
    if (pulls.push) { // chain does not push: what iteration left of pulls below zero is taken off
        for (int i = state.asleep; i < state.links; ++i) {
            matrix_.right[i] = positive_part(-pull_[i]);
            pull_[i] = positive_part(pull_[i]);
        }
        shift_nodes(state, placed_, matrix_.right);
    }
    result.implicit = !converged || pulls.too_strong;
}

/// Contacts that let go or begin to bear, and nodes that stop or begin to slide on the seabed, are part of
/// the same solution: on with Newton's method where there are any.
bool ChainSolver::revise(const ChainState& state, ContactSet* contacts) {
    const bool slides = friction_revisions_ < kMaxRevisions && !friction_fits(state, time_, placed_, motion_);
    if (slides) {
        const bool last = ++friction_revisions_ == kMaxRevisions;
        beneath(contacts, motion_, [&] {
            if (last)
                make_friction_proportional(state, time_, motion_);
            else
                revise_friction(state, time_, placed_, motion_);
        });
    }
    const bool bears = any(contacts) && contacts->revise(placed_, motion_.inverse_mass, motion_.place);
    if (!slides && !bears) return false;
    spread_pulls(state);
    shift_nodes(state, motion_.place, pull_);
    return true;
}

/// Solves the rows from the anchor up, closes them with the drive line, adds the changes to the pulls and
/// looks at what they have become. The changes stay in the matrix' right side.
ChainSolver::Pulls ChainSolver::change_pulls(const ChainState& state, UpperEnd& drive,
                                             ChainStepResult& result) {
    const int top = state.links - 1;
    matrix_.eliminate(state.asleep, top);
    // What is left: pull against travel, one straight line.
    const double yielding =
        (1 + damping_[top] + end_tension(top) / def_.stiffness) * matrix_.diagonal_inverse[top];
    const double half_link = 0.5 * def_.mass_per_metre * state.top_length;
    result.top = {.dt = time_.dt,
                  .pull = pull_[top] + matrix_.right[top] + yielding * result.travel,
                  .yielding = yielding,
                  .outboard_mass = half_link,
                  .outboard_pull = half_link * kGravity * direction_.z[top]};
    result.travel = drive.speed(result.top) * time_.dt;
    matrix_.right[top] = positive_part(result.top.pull - yielding * result.travel) - pull_[top];
    matrix_.substitute(state.asleep, top);
    // Transverse waves must not run further than this in a step that keeps its directions, N.
    const double max = kMaxWave * def_.mass_per_metre * def_.node_spacing * def_.node_spacing / reach_;
    std::int64_t changed = 0, pushes = 0, over = 0;
    const double change = largest_of(state.asleep, top, [&](int i) WINDLASS_INLINE {
        const double was = pull_[i], is = was + matrix_.right[i], history = history_force_[i];
        changed += (was >= history) != (is >= history) ? 1 : 0;
        pushes += is < 0 ? 1 : 0;
        over += is > max ? 1 : 0;
        pull_[i] = is;
        return std::abs(matrix_.right[i]);
    });
    return {changed == 0, pushes > 0, change, over > 0};
}

} // namespace windlass::physics
