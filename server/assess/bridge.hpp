#pragma once
// The bridge of a lesson: it gives the orders, and goes by what it hears and what a bridge can know. It has a
// wrong repeat put right, asks when it hears nothing, renews an order that was not carried out in full, does
// not order what is reported done, takes back what is rightly called unsafe, and gives up when nobody
// answers, or nobody truly.

#include "server/assess/marks.hpp"

namespace windlass::assess {

/// Whether a bridge takes the repeat of an order for its answer, since no report tells that it is done.
bool answered_by_repeat(const exercise::BridgeOrderGiven& order);

/// Takes a report for the answer that it may be to the orders that have been given, and to what was asked.
void take_answer(const Heard& report, const Look& look);

/// What the bridge says now, put behind `due`. false: it has asked as often as it does, and gives up.
bool speak(const Lesson& lesson, State& state, const exercise::Snapshot& seen, int tick_rate,
           std::vector<exercise::Order>& due);

/// Tick at which it gives up, and the lesson ends, if it hears nothing until then and no men are at work; -1:
/// it has not had to ask.
std::int64_t gives_up_at(const Lesson& lesson, const State& state, int tick_rate);

/// Whether it gave up over an order that was repeated back wrongly to the last: it did have an answer.
bool was_misunderstood(const Lesson& lesson, const State& state);

/// Whether it gave up over a question of its own that was answered to the last, and not by what is so.
bool was_told_falsely(const Lesson& lesson, const State& state);

/// Why it gave up: "the bridge had no answer to \"pay out port cable to 3 shackles in the pipe\""; of an
/// order that was repeated back, by the report that it waited for, "the bridge heard no \"ready\" after \"put
/// port windlass in gear\"". All begin with "the bridge ", by which debriefing and pages know them from "time
/// is up".
std::string gave_up_words(const Lesson& lesson, const State& state);

} // namespace windlass::assess
