#pragma once
// What each kind of criterion makes of a tick.

#include "server/assess/fold.hpp"

#include <optional>

namespace windlass::assess {

/// s, in which who says "secured" makes it so, or unasked takes it back.
inline constexpr double kRightAtOnce = 15;

/// What a criterion is looked at with.
struct Look {
    const Lesson& lesson;
    State& state;
    const exercise::Snapshot& seen;
    int tick_rate;
    std::int64_t tick() const { return static_cast<std::int64_t>(seen.tick); }
    bool holds(const Condition& condition) const {
        return assess::holds(condition, lesson, state, seen, tick_rate);
    }
    MissingPart missing(const Condition& condition) const {
        return missing_part(condition, lesson, state, seen, tick_rate);
    }
};

/// Takes a tick, before the lesson has ended.
void look_at(const Criterion& criterion, Mark& mark, const Look& look);

/// Takes a report that came at this tick.
void take_report(const Criterion& criterion, Mark& mark, const Heard& report, const Look& look);

/// What a report says and what is so at this tick; of a figure also what it earns, of anything else nothing.
JudgedReport as_judged(const Criterion& criterion, const Heard& report, const exercise::TackleView& tackle,
                       const Lesson& lesson);

/// From this tick on the mark is that, 0..1000.
void decide(Mark& mark, int milli, std::int64_t tick);

/// The lesson has ended: what was open is decided.
void close(const Criterion& criterion, Mark& mark, State& state, const Lesson& lesson, int tick_rate);

/// Whether a criterion of that mark, 0..1000, is met: from half on. This is the one place where it is
/// decided, for musts and objectives too.
constexpr bool is_met(int milli) {
    return milli >= 500;
}

/// Whether a report is one that the criterion asks for: shackles wherever they are, each held against its own
/// place.
bool is_report(const Criterion& criterion, exercise::ReportCode code);

/// Whether such a report gives something that can be held against a tick: shackles, turns, a lead, a weight,
/// how the cable grows.
bool gives_a_figure(exercise::ReportCode code);

/// Whether a report gives something that can be held against this tick, and is not so by more than what earns
/// half a mark. Of anything else it is not known.
bool is_false(const Heard& heard, const Look& look);

/// The report that a criterion asks for, with the figures that are true at this tick; nothing: it asks for
/// none, or there is nothing of it to be reported now.
std::optional<exercise::ReportMade> true_report(const Criterion& criterion, const Look& look);

/// s within which an order is to be repeated back; 0: it need not be.
double repeat_within(const exercise::BridgeOrderGiven& order);

} // namespace windlass::assess
