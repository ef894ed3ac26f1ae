#include "server/assess/result.hpp"

#include "server/assess/assessor.hpp"
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

/// Tenths of a point of 100, rounded half up, of those criteria that came into play.
int tenths_of(const Lesson& lesson, const State& state, bool with_overrides, const std::string* objective) {
    std::int64_t sum = 0, weights = 0;
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k) {
        const Criterion& criterion = lesson.criteria[k];
        const auto milli = counted(state.marks[k], with_overrides);
        if (!milli || (objective != nullptr && criterion.objective != *objective)) continue;
        sum += std::int64_t{criterion.weight} * *milli;
        weights += criterion.weight;
    }
    return weights == 0 ? 0 : static_cast<int>((2 * sum + weights) / (2 * weights));
}

/// Whether all musts are met: not yet where one is missed, not shown where one never came into play.
Outcome musts(const Lesson& lesson, const State& state, const std::string* objective) {
    Outcome outcome = Outcome::achieved;
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k) {
        const Criterion& criterion = lesson.criteria[k];
        if (!criterion.must || (objective != nullptr && criterion.objective != *objective)) continue;
        const Mark& mark = state.marks[k];
        if (mark.overridden && mark.given_milli < 0) continue;
        const auto milli = counted(mark, true);
        if (milli && *milli < kMet) return Outcome::not_yet;
        const bool broken_order = criterion.kind == CriterionKind::sequence && mark.wrong > 0;
        if (broken_order && !mark.overridden) return Outcome::not_yet;
        if (!milli) outcome = Outcome::not_shown;
    }
    return outcome;
}

Outcome outcome_of(const Lesson& lesson, const State& state, const std::string* objective, int pass) {
    const Outcome outcome = musts(lesson, state, objective);
    if (outcome == Outcome::not_yet || state.ending == Ending::abort) return Outcome::not_yet;
    bool shown = false;
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k)
        shown = shown || ((objective == nullptr || lesson.criteria[k].objective == *objective) &&
                          counted(state.marks[k], true));
    if (!shown) return Outcome::not_shown;
    return tenths_of(lesson, state, true, objective) < 10 * pass ? Outcome::not_yet : outcome;
}

CriterionResult criterion_result(const Lesson& lesson, const State& state, std::size_t k, int tick_rate) {
    const Criterion& criterion = lesson.criteria[k];
    const Mark& mark = state.marks[k];
    const bool limited = criterion.kind == CriterionKind::limit;
    return {.code = criterion.id,
            .text = criterion.text,
            .objective = criterion.objective,
            .reason = reason(lesson, state, k, tick_rate),
            .kind = criterion.kind,
            .state = mark.overridden ? CriterionState::overridden : mark.state,
            .limit = !limited                   ? 0
                     : criterion.max < kNoLimit ? criterion.max
                                                : criterion.min,
            .worst = mark.worst,
            .time_outside = limited ? static_cast<double>(mark.outside) / tick_rate : 0,
            .weight = criterion.weight,
            .milli = mark.milli,
            .must = criterion.must,
            .tick = mark.decided < 0 ? 0 : static_cast<std::uint64_t>(mark.decided)};
}

std::string abort_text(const Lesson& lesson, const State& state) {
    switch (state.ending) {
    case Ending::abort:
        return lesson.abort[static_cast<std::size_t>(state.aborted_by)].code;
    case Ending::time:
        return lesson.good ? "time is up" : "";
    case Ending::none:
    case Ending::good:
    case Ending::instructor:
        break;
    }
    return "";
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

Result result(const Lesson& lesson, const State& state, int tick_rate) {
    Result result{.tick = static_cast<std::uint64_t>(std::max<std::int64_t>(state.tick, 0)),
                  .time = static_cast<double>(std::max<std::int64_t>(state.tick, 0)) / tick_rate,
                  .tenths = tenths_of(lesson, state, true, nullptr),
                  .tenths_computed = tenths_of(lesson, state, false, nullptr),
                  .finished = state.ending != Ending::none,
                  .outcome = Outcome::none,
                  .abort = abort_text(lesson, state),
                  .lesson_hash = lesson.hash,
                  .assessment_hash = assessment_hash(lesson, state),
                  .criteria = {},
                  .objectives = {}};
    for (std::size_t k = 0; k < lesson.criteria.size(); ++k)
        result.criteria.push_back(criterion_result(lesson, state, k, tick_rate));
    bool all = true;
    for (const Objective& objective : lesson.objectives) {
        const Outcome outcome = outcome_of(lesson, state, &objective.id, objective.pass);
        all = all && outcome == Outcome::achieved;
        result.objectives.push_back({objective.id, objective.text, objective.stcw,
                                     result.finished ? outcome : Outcome::none,
                                     tenths_of(lesson, state, true, &objective.id)});
    }
    if (!result.finished) return result;
    result.outcome = outcome_of(lesson, state, nullptr, lesson.pass);
    if (result.outcome == Outcome::achieved && !all) result.outcome = Outcome::not_yet;
    return result;
}

} // namespace windlass::assess
