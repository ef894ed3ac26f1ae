#include "server/assess/result.hpp"

#include "server/assess/aids.hpp"
#include "server/assess/assessor.hpp"
#include "server/assess/bridge.hpp"
#include "server/assess/marks.hpp"
#include "server/assess/quantities.hpp"

#include <algorithm>
#include <numeric>

namespace windlass::assess {

namespace {

/// The mark that counts: the assessor's where he has spoken. Nothing: it does not come into the score.
std::optional<int> counted(const Mark& mark, bool with_overrides) {
    if (with_overrides && mark.overridden)
        return mark.given_milli < 0 ? std::nullopt : std::optional(mark.given_milli);
    return mark.state == CriterionState::not_in_play ? std::nullopt : std::optional(mark.milli);
}

/// Whether a criterion says only what must not be, or stay as it is: a hand that does nothing meets it.
bool is_safeguard(const Criterion& criterion, const Mark& mark) {
    switch (criterion.kind) {
    case CriterionKind::limit:
    case CriterionKind::prohibited:
        return true;
    case CriterionKind::final:
    case CriterionKind::state_at:
        return !mark.acted;
    default:
        return false;
    }
}

/// Whether it counts what the lesson never came to. One that is ended early is marked as far as it went,
/// unless nothing of what was to be done had been begun.
bool counts_what_was_left_out(const Lesson& lesson, const State& state) {
    if (state.ending == Ending::none) return false;
    if (state.ending != Ending::instructor) return true;
    bool waits = false; // for a deed
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k) {
        if (is_safeguard(lesson.criteria[k], state.marks[k])) continue;
        if (counted(state.marks[k], true)) return false;
        waits = waits || lesson.criteria[k].must;
    }
    return waits;
}

/// Of which marks a sum is made.
struct Which {
    bool with_overrides = true;
    const std::string* objective = nullptr; ///< of one alone; nullptr: of all
    bool left_out = false;                  ///< also of the musts that were never shown, which earn nothing
};

/// Weights and marks of what came into play: of what was to be done, and of what only guards it.
struct Sums {
    std::int64_t deeds = 0, done = 0; ///< weights; weights by thousandths
    std::int64_t guards = 0, kept = 0;
};
Sums sums_of(const Lesson& lesson, const State& state, const Which& of) {
    Sums sums;
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k) {
        const Criterion& criterion = lesson.criteria[k];
        auto milli = counted(state.marks[k], of.with_overrides);
        if (of.left_out && was_left_out(lesson, state, k, of.with_overrides)) milli = 0;
        if (!milli || (of.objective != nullptr && criterion.objective != *of.objective)) continue;
        const bool guards = is_safeguard(criterion, state.marks[k]);
        (guards ? sums.guards : sums.deeds) += criterion.weight;
        (guards ? sums.kept : sums.done) += std::int64_t{criterion.weight} * *milli;
    }
    return sums;
}

/// Whether all musts are met: not yet where one is missed, not shown where one never came into play.
Outcome musts(const Lesson& lesson, const State& state, bool with_overrides, const std::string* objective) {
    Outcome outcome = Outcome::achieved;
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k) {
        const Criterion& criterion = lesson.criteria[k];
        if (!criterion.must || (objective != nullptr && criterion.objective != *objective)) continue;
        const Mark& mark = state.marks[k];
        if (with_overrides && mark.overridden && mark.given_milli < 0) continue;
        const auto milli = counted(mark, with_overrides);
        if (milli && !is_met(*milli)) return Outcome::not_yet;
        if (!milli) outcome = Outcome::not_shown;
    }
    return outcome;
}

/// A part of a whole, in tenths of a point of 100, rounded half up.
struct Share {
    std::int64_t part = 0, whole = 0;
    int tenths(int divisor = 1) const {
        return whole == 0 ? 0 : static_cast<int>((2 * part + divisor * whole) / (2 * divisor * whole));
    }
};

/// What those criteria have earned. What only guards earns in the measure in which something was done.
Share earned(const Lesson& lesson, const State& state, const Which& of) {
    const Sums sums = sums_of(lesson, state, of);
    Sums whole = sums;
    if (of.objective != nullptr && sums.deeds == 0)
        whole = sums_of(lesson, state, {.with_overrides = of.with_overrides, .left_out = of.left_out});
    // Nothing was to be done in it: what guards stands for itself.
    const std::int64_t kept = whole.deeds > 0 ? sums.kept * whole.done / whole.deeds : 1000 * sums.kept;
    return {1000 * sums.done + kept, 1000 * (sums.deeds + sums.guards)};
}

/// Whether one of what is to be learnt was shown, and so poorly that it fails the lesson.
bool misses_an_objective(const Lesson& lesson, const State& state, bool with_overrides) {
    return std::ranges::any_of(lesson.objectives, [&](const Objective& one) {
        const Share share = earned(lesson, state, {.with_overrides = with_overrides, .objective = &one.id});
        return share.whole > 0 && share.tenths() < 10 * one.least();
    });
}

/// Tenths of a point of 100. A must or an objective that was missed or not shown, or a bridge that gave up
/// for want of an answer that is so, halves them, so that no such attempt lies above one without. A must that
/// was not shown earns nothing besides: what a crew never comes to, because it does nothing, would else not
/// count.
int tenths_of(const Lesson& lesson, const State& state, bool with_overrides, const std::string* objective) {
    const bool missed =
        musts(lesson, state, with_overrides, objective) != Outcome::achieved ||
        (objective == nullptr && (state.gave_up || misses_an_objective(lesson, state, with_overrides)));
    return earned(lesson, state, {.with_overrides = with_overrides, .objective = objective, .left_out = true})
        .tenths(state.ending != Ending::none && missed ? 2 : 1);
}

/// Whether anything was done or said that earns a mark, or done that must not be.
bool shows_anything(const Lesson& lesson, const State& state) {
    const Sums sums = sums_of(lesson, state, {});
    if (sums.done > 0 || sums.deeds == 0) return true;
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k) {
        const auto milli = counted(state.marks[k], true);
        if (milli && !is_met(*milli) && is_safeguard(lesson.criteria[k], state.marks[k])) return true;
    }
    return false;
}

/// Whether orders or reports show it: what a bridge that gave up had no true answer to. nullptr: the whole.
bool is_of_words(const Lesson& lesson, const std::string* objective) {
    return objective == nullptr || std::ranges::any_of(lesson.criteria, [&](const Criterion& one) {
               return one.objective == *objective &&
                      (one.kind == CriterionKind::order || one.kind == CriterionKind::report);
           });
}

Outcome outcome_of(const Lesson& lesson, const State& state, const std::string* objective, int pass) {
    if (state.ending != Ending::abort && !shows_anything(lesson, state)) return Outcome::not_shown;
    const Outcome outcome = musts(lesson, state, true, objective);
    if (outcome == Outcome::not_yet || state.ending == Ending::abort) return Outcome::not_yet;
    bool shown = false;
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k)
        shown = shown || ((objective == nullptr || lesson.criteria[k].objective == *objective) &&
                          counted(state.marks[k], true));
    if (!shown) return Outcome::not_shown;
    if (state.gave_up && is_of_words(lesson, objective)) return Outcome::not_yet;
    return earned(lesson, state, {.objective = objective}).tenths() < 10 * pass ? Outcome::not_yet : outcome;
}

/// When a criterion first went wrong; -1: it did not.
std::int64_t first_loss(const Lesson& lesson, const State& state, std::size_t k) {
    const Criterion& criterion = lesson.criteria[k];
    const Mark& mark = state.marks[k];
    if (mark.state == CriterionState::not_in_play || mark.milli == 1000) return -1;
    switch (criterion.kind) {
    case CriterionKind::limit:
        return mark.since;
    case CriterionKind::final:
        return mark.held ? mark.since : mark.decided; // what never was so is missed at the end
    case CriterionKind::sequence:
        return mark.wrong > 0 ? mark.worst_tick : mark.decided;
    case CriterionKind::order:
        for (const int order : criterion.orders)
            if (order == mark.wrong - 1) return state.orders[static_cast<std::size_t>(order)].given;
        return mark.decided;
    case CriterionKind::report:
        for (const JudgedReport& report : state.judged)
            if (report.criterion == static_cast<int>(k) && report.milli < 1000)
                return criterion.truth == ReportTruth::moment && report.so >= 0
                           ? std::min(report.tick, report.so)
                           : report.tick;
        // It was never made: missed since it could have been, or else at the end.
        if (criterion.truth == ReportTruth::state && mark.since >= 0) return mark.since;
        return criterion.truth == ReportTruth::moment || criterion.from ? mark.began : mark.decided;
    default:
        return mark.decided; // at once
    }
}

/// As on the wire: 0 is none.
std::uint64_t wire_tick(std::int64_t tick) {
    return tick < 0 ? 0 : static_cast<std::uint64_t>(tick);
}

CriterionResult criterion_result(const Lesson& lesson, const State& state, std::size_t k, int tick_rate) {
    const Criterion& criterion = lesson.criteria[k];
    const Mark& mark = state.marks[k];
    const bool limited = criterion.kind == CriterionKind::limit;
    const bool left_out = was_left_out(lesson, state, k);
    const auto milli = left_out ? std::optional(0) : counted(mark, true);
    return {.code = criterion.id,
            .text = criterion.text,
            .objective = criterion.objective,
            .reason = reason(lesson, state, k, tick_rate),
            .unit = limited ? quantity_at(criterion.quantity).unit : "",
            .kind = criterion.kind,
            .state = mark.overridden ? CriterionState::overridden : mark.state,
            .limit = !limited                   ? 0
                     : criterion.max < kNoLimit ? criterion.max
                                                : criterion.min,
            .worst = mark.worst,
            .time_outside = limited ? static_cast<double>(mark.outside) / tick_rate : 0,
            .weight = criterion.weight,
            .milli = mark.milli,
            .counted = milli.value_or(0),
            .counts = milli.has_value(),
            .met = milli && is_met(*milli),
            .must = criterion.must,
            .deed = !is_safeguard(criterion, mark),
            .tick = wire_tick(left_out ? state.ended : mark.decided),
            .lost_tick = wire_tick(first_loss(lesson, state, k))};
}

std::string abort_text(const Lesson& lesson, const State& state, Ending ending) {
    switch (ending) {
    case Ending::abort:
        return lesson.abort[static_cast<std::size_t>(state.aborted_by)].what;
    case Ending::time:
        return state.gave_up ? gave_up_words(lesson, state) : "time is up";
    case Ending::instructor:
        return "ended before its lesson was done";
    case Ending::none:
    case Ending::good:
        break;
    }
    return "";
}

std::vector<OrderDoneResult> orders_done(const State& state) {
    std::vector<OrderDoneResult> all;
    for (const OrderCourse& course : state.orders)
        if (course.given >= 0) all.push_back({course.number, course.taken_back ? 0 : wire_tick(course.done)});
    for (const FurtherOrder& order : state.further)
        all.push_back({order.number, wire_tick(order.done)});
    if (!state.further.empty()) std::ranges::stable_sort(all, {}, &OrderDoneResult::number);
    return all;
}

/// The lesson's own, and what the seats have asked for besides.
std::vector<HintResult> hints_given(const Lesson& lesson, const State& state) {
    std::vector<HintResult> all;
    for (std::size_t k = 0; k < lesson.hints.size(); ++k) {
        if (state.hints[k] < 0) continue;
        const Hint& hint = lesson.hints[k];
        all.push_back({.tick = wire_tick(state.hints[k]),
                       .id = hint.id,
                       .criterion = hint.criterion < 0
                                        ? ""
                                        : lesson.criteria[static_cast<std::size_t>(hint.criterion)].id,
                       .forecastle = hint.forecastle,
                       .text = hint.say});
    }
    for (const AidTaken& aid : state.aids) {
        if (!helps(aid)) continue;
        all.push_back({.tick = wire_tick(aid.tick),
                       .id = aid.kind == AidKind::ghost ? "ghost" : "asked for",
                       .criterion = aid.lever < 0 || aid.criterion < 0
                                        ? ""
                                        : lesson.criteria[static_cast<std::size_t>(aid.criterion)].id,
                       .forecastle = aid.forecastle,
                       .text = told_words(aid, lesson)});
    }
    std::ranges::stable_sort(all, {}, &HintResult::tick);
    if (all.size() > kMostAids) all.resize(kMostAids);
    return all;
}

ReportResult report_result(const Lesson& lesson, const Criterion& criterion, const JudgedReport& report,
                           int tick_rate) {
    ReportResult to{.tick = wire_tick(report.tick),
                    .code = report.code == exercise::ReportCode::text ? criterion.report : report.code,
                    .side = criterion.side,
                    .criterion = criterion.id,
                    .text = truth_words(lesson, criterion, report, tick_rate),
                    .milli = report.milli,
                    .delay = {},
                    .truth = {}};
    if (criterion.truth == ReportTruth::moment && report.so >= 0)
        to.delay = static_cast<double>(report.tick - report.so) / tick_rate;
    if (criterion.truth == ReportTruth::figure) to.truth = report.truth;
    return to;
}

} // namespace

const char* outcome_name(Outcome outcome) {
    switch (outcome) {
    case Outcome::achieved:
        return "achieved";
    case Outcome::not_yet:
        return "not_yet";
    case Outcome::not_shown:
        return "not_shown";
    case Outcome::none:
        break;
    }
    return "";
}

bool was_left_out(const Lesson& lesson, const State& state, std::size_t criterion, bool with_overrides) {
    const Mark& mark = state.marks[criterion];
    if (!lesson.criteria[criterion].must || (with_overrides && mark.overridden)) return false;
    // What came into play and was cut off is another matter: nobody knows how it would have been.
    const bool came = mark.state != CriterionState::not_in_play || mark.began >= 0;
    return !came && counts_what_was_left_out(lesson, state);
}

std::optional<bool> verdict(const Lesson& lesson, const State& state, std::size_t criterion, int milli) {
    const Mark& mark = state.marks[criterion];
    const CriterionKind kind = lesson.criteria[criterion].kind;
    const bool in_play = mark.state != CriterionState::not_in_play;
    if (mark.decided >= 0 || state.ending != Ending::none) return in_play && mark.milli >= milli;
    // These only fall; an order's mark counts what may still be earned.
    const bool falls = kind == CriterionKind::limit || kind == CriterionKind::prohibited ||
                       (kind == CriterionKind::order && milli == 1000);
    if (falls && in_play && mark.milli < milli) return false;
    return std::nullopt;
}

Result result(const Lesson& lesson, const State& state, int tick_rate) {
    const Ending ending =
        state.ending == Ending::time && !lesson.good && !state.gave_up ? Ending::good : state.ending;
    Result result{.tick = static_cast<std::uint64_t>(std::max<std::int64_t>(state.tick, 0)),
                  .time = static_cast<double>(std::max<std::int64_t>(state.tick, 0)) / tick_rate,
                  .tenths = tenths_of(lesson, state, true, nullptr),
                  .tenths_computed = tenths_of(lesson, state, false, nullptr),
                  .pass = lesson.pass,
                  .finished = state.ending != Ending::none,
                  .ending = ending,
                  .outcome = Outcome::none,
                  .abort = abort_text(lesson, state, ending),
                  .lesson_hash = lesson.hash,
                  .assessment_hash = assessment_hash(lesson, state),
                  .criteria = {},
                  .objectives = {},
                  .orders = orders_done(state),
                  .reports = {},
                  .practice = lesson.practice,
                  .hints = hints_given(lesson, state)};
    for (const JudgedReport& report : state.judged)
        result.reports.push_back(report_result(
            lesson, lesson.criteria[static_cast<std::size_t>(report.criterion)], report, tick_rate));
    for (const JudgedReport& report : state.unasked)
        result.reports.push_back(report_result(
            lesson, lesson.unasked[static_cast<std::size_t>(report.criterion)], report, tick_rate));
    std::ranges::stable_sort(result.reports, {}, &ReportResult::tick);
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k)
        result.criteria.push_back(criterion_result(lesson, state, k, tick_rate));
    bool none_fails = true;
    for (const Objective& objective : lesson.objectives) {
        const Outcome outcome = outcome_of(lesson, state, &objective.id, objective.pass);
        none_fails =
            none_fails && outcome_of(lesson, state, &objective.id, objective.least()) == Outcome::achieved;
        result.objectives.push_back({objective.id, objective.text, objective.stcw,
                                     result.finished ? outcome : Outcome::none,
                                     tenths_of(lesson, state, true, &objective.id), objective.pass});
    }
    if (!result.finished) return result;
    result.outcome = outcome_of(lesson, state, nullptr, lesson.pass);
    if (result.outcome == Outcome::achieved && !none_fails) result.outcome = Outcome::not_yet;
    return result;
}

} // namespace windlass::assess
