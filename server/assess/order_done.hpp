#pragma once
// When an order of the bridge is carried out, and what makes a report true beyond what words.json says of it.

#include "server/assess/lesson.hpp"
#include "server/exercise/picture/snapshot.hpp"

namespace windlass::assess {

/// Adds an event, or report, to those that a lesson waits for; its place.
int watch(Lesson& lesson, const WatchedEvent& event);
int watch(Lesson& lesson, const WatchedReport& report);

/// The windlass as it is when the order has been carried out. side: whose.
Condition usual_done(Lesson& lesson, const exercise::BridgeOrderGiven& order, int side);

/// Whether nobody repeats it back: it is answered instead.
bool is_question(exercise::BridgeOrderCode code);

/// Whether the order is for cable to a figure: it is carried out when the cable stands at that.
bool is_to_a_figure(const exercise::BridgeOrderGiven& order);

/// Whether it is for cable that is to be stopped at a figure and stand there: once it only pauses there, the
/// order is not carried out.
bool is_to_stand(exercise::BridgeOrderCode code, double figure);

/// Whether the cable stands at the figure of an order that is to one.
bool stands_at_figure(exercise::BridgeOrderCode code, double figure, const exercise::TackleView& tackle);

/// Lays the usual truth of a report and its tolerances over the criterion; a moment that it needs is added to
/// the lesson's. False: this report has none, and the lesson must say what is true.
bool lay_usual_truth(Lesson& lesson, Criterion& criterion);

} // namespace windlass::assess
