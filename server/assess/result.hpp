#pragma once
// What an assessment says: points, objectives, and reasons in words with figures.

#include "common/fields.hpp"
#include "server/assess/state.hpp"

namespace windlass::assess {

/// Names, units and meaning as in idl Criterion.
struct CriterionResult {
    std::string code, text, objective, reason, unit;
    CriterionKind kind = CriterionKind::limit;
    CriterionState state = CriterionState::not_in_play;
    double limit = 0, worst = 0, time_outside = 0;
    int weight = 0, milli = 0, counted = 0;
    bool counts = false, met = false, must = false, deed = false;
    std::uint64_t tick = 0, lost_tick = 0;
};
WINDLASS_FIELDS(CriterionResult, code, text, objective, reason, unit, kind, state, limit, worst, time_outside,
                weight, milli, counted, counts, met, must, deed, tick, lost_tick)

enum class Outcome { none, achieved, not_yet, not_shown };

struct ObjectiveResult {
    std::string id, text, stcw;
    Outcome outcome = Outcome::none;
    int tenths = 0; ///< points of 1000
    int pass = 0;   ///< points of 100
};

/// Names, units and meaning as in idl OrderDone.
struct OrderDoneResult {
    int number = 0;
    std::uint64_t tick = 0;
};
WINDLASS_FIELDS(OrderDoneResult, number, tick)

/// Names, units and meaning as in idl JudgedReport.
struct ReportResult {
    std::uint64_t tick = 0;
    exercise::ReportCode code = exercise::ReportCode::text;
    int side = 0;
    std::string criterion, text;
    int milli = 0;
    std::optional<double> delay, truth;
};
WINDLASS_FIELDS(ReportResult, tick, code, side, criterion, text, milli, delay, truth)

/// Names, units and meaning as in idl HintGiven.
struct HintResult {
    std::uint64_t tick = 0;
    std::string id, criterion;
    bool forecastle = true;
    std::string text;
};
WINDLASS_FIELDS(HintResult, tick, id, criterion, forecastle, text)

/// Names, units and meaning as in idl Assessment.
struct Result {
    std::uint64_t tick = 0;
    double time = 0;
    int tenths = 0, tenths_computed = 0; ///< tenths of a point of 100
    int pass = 0;                        ///< points of 100
    bool finished = false;
    Ending ending = Ending::none; ///< good where it was to end with its time
    Outcome outcome = Outcome::none;
    std::string abort;
    std::uint64_t lesson_hash = 0, assessment_hash = 0;
    std::vector<CriterionResult> criteria;
    std::vector<ObjectiveResult> objectives;
    std::vector<OrderDoneResult> orders;
    std::vector<ReportResult> reports;
    bool practice = false;
    std::vector<HintResult> hints;
};

/// "achieved", "not_yet", "not_shown"; "" while it runs.
const char* outcome_name(Outcome outcome);

/// tick_rate: Hz.
Result result(const Lesson& lesson, const State& state, int tick_rate);

/// Whether it is a must that never came into play in a lesson that is over: nobody has shown it. It counts,
/// and earns nothing.
bool was_left_out(const Lesson& lesson, const State& state, std::size_t criterion,
                  bool with_overrides = true);

/// Whether a mark can still come to be `milli`, or is; nothing: that is open.
std::optional<bool> verdict(const Lesson& lesson, const State& state, std::size_t criterion, int milli);

/// Why the mark is what it is: "0:41 worst 6.9 m/s, at most 5.5; 3.2 s beyond: 20 % of its points lost".
std::string reason(const Lesson& lesson, const State& state, std::size_t criterion, int tick_rate);

/// What was so when that report came: "3.6 shackles", "it never was so". criterion: that it was held against.
std::string truth_words(const Lesson& lesson, const Criterion& criterion, const JudgedReport& report,
                        int tick_rate);

} // namespace windlass::assess
