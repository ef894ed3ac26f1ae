#include "server/run/hint_search.hpp"

#include "server/assess/result.hpp"
#include "server/exercise/checkpoint.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::run {

using assess::CriterionKind;
using assess::Lever;
using assess::LeverKind;

namespace {

constexpr double kLook = 0.1;  // s between two looks at the marks
constexpr double kGrid = 0.05; // of a lever's way: as finely as a hand sets one that is told to
constexpr double kSlow = 0.3;  // of the engine

std::uint64_t ticks(double seconds, const Course& course) {
    return static_cast<std::uint64_t>(std::llround(seconds * course.exercise().def().tick_rate_hz));
}

void take(Course& course, exercise::Order order) {
    course.take({.run = 0, .tick = 0, .number = 0, .source = {}, .command = std::move(order)});
}

/// What is armed is to come: nobody knows of it, and it comes in no branch.
void disarm(Course& course) {
    exercise::Snapshot seen;
    course.exercise().view_unhashed(seen);
    for (const exercise::FaultView& fault : seen.faults)
        if (fault.phase == exercise::FaultPhase::armed)
            take(course,
                 exercise::FaultOrder{
                     .code = fault.order.code, .side = fault.order.side, .severity = 0, .clear = true});
}

} // namespace

HintSearch::HintSearch(const std::vector<std::uint8_t>& checkpoint, bool forecastle)
    : checkpoint_(checkpoint),
      forecastle_(forecastle),
      found_{.kind = assess::AidKind::told, .forecastle = forecastle} {
    const Course course = course_of(checkpoint_);
    if (!course.assessor().assesses()) throw exercise::CheckpointError("an exercise without a lesson");
    lesson_ = *course.assessor().lesson();
    helm_ = course.exercise().helm();
    rudder_max_ = course.exercise().def().ship.rudder_max;
    for (const exercise::GroundTackleDef& tackle : course.exercise().def().tackle) {
        sides_.push_back(tackle.side);
        windlass_.at(static_cast<std::size_t>(tackle.side)) = course.exercise().levers(tackle.side);
    }
    const assess::State& state = course.assessor().state();
    for (std::size_t k = 0; k < lesson_.criteria.size(); ++k) {
        const assess::Criterion& criterion = lesson_.criteria[k];
        // What is said no lever keeps.
        const bool is_said =
            criterion.kind == CriterionKind::question || criterion.kind == CriterionKind::report;
        open_.push_back(criterion.kind != CriterionKind::rubric && !is_said && criterion.weight > 0 &&
                        assess::verdict(lesson_, state, k, goal(k)) != false);
    }
    begin(std::nullopt, 0);
}

/// A must is to be met; of the others all is to be kept.
int HintSearch::goal(std::size_t criterion) const {
    return lesson_.criteria[criterion].must ? 500 : 1000;
}

void HintSearch::begin(const std::optional<Move>& move, double at) {
    ++tried_;
    course_.emplace(course_of(checkpoint_));
    disarm(*course_);
    move_ = move;
    began_ = course_->exercise().tick();
    moves_at_ = began_ + ticks(at, *course_);
    ends_ = began_ + ticks(kAhead, *course_);
    lost_.assign(lesson_.criteria.size(), -1);
}

bool HintSearch::step() {
    if (part_ == Part::done) return false;
    Course& course = *course_;
    if (move_ && course.exercise().tick() == moves_at_) {
        const Lever& lever = move_->lever;
        exercise::WindlassOrder windlass = windlass_.at(static_cast<std::size_t>(lever.side));
        exercise::HelmOrder helm = helm_;
        switch (lever.kind) {
        case LeverKind::brake:
            windlass.brake = move_->value;
            break;
        case LeverKind::speed:
            windlass.speed_lever = move_->value;
            break;
        case LeverKind::clutch:
            windlass.clutch_in = move_->value > 0.5;
            break;
        case LeverKind::stopper:
            windlass.stopper_closed = move_->value > 0.5;
            break;
        case LeverKind::engine:
            helm.engine = move_->value;
            break;
        case LeverKind::rudder:
            helm.rudder = move_->value;
            break;
        }
        take(course, lever.of_helm() ? exercise::Order{helm} : exercise::Order{windlass});
    }
    // What the lesson orders is left: it is what is to come.
    if (!course.step()) {
        lost_.assign(lost_.size(), 0); // a state that is not finite keeps nothing
        end_of_branch();
        return part_ != Part::done;
    }
    const std::uint64_t now = course.exercise().tick();
    const bool ended = now >= ends_ || course.assessor().ended();
    if (!ended && now % ticks(kLook, course) != 0) return true;
    look();
    if (ended || over()) end_of_branch();
    return part_ != Part::done;
}

/// More of the branch would make no difference.
bool HintSearch::over() const {
    const auto beyond = static_cast<std::int64_t>(ticks(kBeyond, *course_));
    const auto now = static_cast<std::int64_t>(course_->exercise().tick());
    if (part_ != Part::as_it_is) return !keeps() || now >= as_it_is_[target_] + beyond;
    for (std::size_t k = 0; k < lost_.size(); ++k)
        if (lesson_.criteria[k].must && lost_[k] >= 0 && now >= lost_[k] + beyond) return true;
    return false;
}

void HintSearch::look() {
    const assess::State& state = course_->assessor().state();
    for (std::size_t k = 0; k < lost_.size(); ++k)
        if (open_[k] && lost_[k] < 0 && state.marks[k].state != assess::CriterionState::not_in_play &&
            assess::verdict(lesson_, state, k, goal(k)) == false)
            lost_[k] = state.tick;
}

/// The target is not lost, no must is that would not be, and, where it is no must itself, less is lost.
bool HintSearch::keeps() const {
    if (lost_[target_] >= 0) return false;
    int as_it_is = 0, now = 0;
    for (std::size_t k = 0; k < lost_.size(); ++k) {
        if (lesson_.criteria[k].must && lost_[k] >= 0 && as_it_is_[k] < 0) return false;
        as_it_is += as_it_is_[k] >= 0 ? lesson_.criteria[k].weight : 0;
        now += lost_[k] >= 0 ? lesson_.criteria[k].weight : 0;
    }
    return lesson_.criteria[target_].must || now < as_it_is;
}

void HintSearch::end_of_branch() {
    switch (part_) {
    case Part::as_it_is:
        return after_as_it_is();
    case Part::strong:
    case Part::weak:
        if (!keeps()) return next_of(moves_, part_);
        best_ = moves_[at_ - 1];
        keeps_ = best_.value, fails_ = best_.from;
        if (part_ == Part::strong && !best_.lever.catches() && best_.lever.kind != LeverKind::rudder)
            return begin_smaller();
        part_ = Part::later;
        return begin(best_, kReading + 1);
    case Part::smaller:
        (keeps() ? keeps_ : fails_) = move_->value;
        return begin_smaller();
    case Part::later: {
        // A hand that is a second slower still keeps it, or else the strong move is the one to be told.
        Move told = best_;
        if (keeps()) told.value = keeps_;
        return tell(told);
    }
    case Part::done:
        return;
    }
}

void HintSearch::after_as_it_is() {
    as_it_is_ = lost_;
    const auto sooner = [&](bool must) {
        std::optional<std::size_t> first;
        for (std::size_t k = 0; k < lost_.size(); ++k)
            if (lost_[k] >= 0 && lesson_.criteria[k].must == must && (!first || lost_[k] < lost_[*first]))
                first = k;
        return first;
    };
    const auto must = sooner(true);
    const auto first = must ? must : sooner(false);
    if (!first) {
        part_ = Part::done; // nothing is being lost
        return;
    }
    target_ = *first;
    found_.criterion = static_cast<int>(target_);
    moves_ = strong_moves();
    at_ = 0;
    next_of(moves_, Part::strong);
}

/// The next of them; behind the strong ones the weak ones; behind these there is none.
void HintSearch::next_of(const std::vector<Move>& moves, Part part) {
    part_ = part;
    if (at_ < moves.size()) return begin(moves[at_++], kReading);
    if (part == Part::weak) {
        part_ = Part::done;
        return;
    }
    moves_ = weak_moves();
    at_ = 0;
    next_of(moves_, Part::weak);
}

/// Halves the way between where it keeps and where it does not, on the grid of a hand.
void HintSearch::begin_smaller() {
    const double half = kGrid * std::round((keeps_ + fails_) / 2 / kGrid);
    const bool fine = std::abs(keeps_ - fails_) <= kGrid * 1.5 || half == keeps_ || half == fails_;
    part_ = fine ? Part::later : Part::smaller;
    Move move = best_;
    move.value = fine ? keeps_ : half;
    begin(move, fine ? kReading + 1 : kReading);
}

void HintSearch::tell(const Move& move) {
    found_.lever = move.lever;
    found_.value = move.value;
    part_ = Part::done;
}

void HintSearch::give_up() {
    // What keeps it is known, only not how little would.
    if (part_ == Part::smaller || part_ == Part::later) return tell(best_);
    if (part_ == Part::as_it_is) found_.found = false; // not that nothing is lost
    part_ = Part::done;
}

std::vector<Lever> HintSearch::levers() const {
    if (!forecastle_) return {{LeverKind::engine, {}}, {LeverKind::rudder, {}}};
    std::vector<Lever> all;
    for (const exercise::Side side : sides_)
        for (const LeverKind kind :
             {LeverKind::brake, LeverKind::speed, LeverKind::clutch, LeverKind::stopper})
            all.push_back({kind, side});
    return all;
}

double HintSearch::value_now(const Lever& lever) const {
    return assess::place_of(lever, windlass_.at(static_cast<std::size_t>(lever.side)), helm_);
}

/// To the end of a lever's way, or to stop; in the order in which a hand would think of them.
std::vector<HintSearch::Move> HintSearch::strong_moves() const {
    std::vector<Move> moves;
    const auto add = [&](LeverKind kind, std::initializer_list<double> values) {
        for (const Lever& lever : levers())
            for (const double value : values)
                if (const double now = value_now(lever);
                    lever.kind == kind && std::abs(value - now) > kGrid / 2)
                    moves.push_back({lever, value, now});
    };
    add(LeverKind::brake, {1});
    add(LeverKind::speed, {0});
    add(LeverKind::brake, {0});
    add(LeverKind::clutch, {1, 0});
    add(LeverKind::stopper, {1, 0});
    add(LeverKind::engine, {0, kSlow, -kSlow});
    add(LeverKind::rudder, {0, rudder_max_, -rudder_max_});
    return moves;
}

/// Part of the way, either way: what is too much at its end may be right before it.
std::vector<HintSearch::Move> HintSearch::weak_moves() const {
    std::vector<Move> moves;
    for (const Lever& lever : levers()) {
        if (lever.catches() || lever.kind == LeverKind::rudder) continue;
        const double now = value_now(lever), least = lever.kind == LeverKind::brake ? 0 : -1;
        for (const double by : {0.15, -0.15, 0.5, -0.5, 1.0, -1.0})
            if (const double value = now + by; value >= least - 1e-9 && value <= 1 + 1e-9)
                moves.push_back({lever, std::clamp(kGrid * std::round(value / kGrid), least, 1.0), now});
    }
    return moves;
}

} // namespace windlass::run
