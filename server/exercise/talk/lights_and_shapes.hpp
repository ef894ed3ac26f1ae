#pragma once
// Anchor ball and anchor lights: hoisted or lit by the bridge's order, and what the log says of it.

#include "server/exercise/faults/faults.hpp"

namespace windlass::exercise {

/// From one to the other, with an event for each that changes: "signals.anchor_ball",
/// "signals.anchor_lights", value 1 shown, 0 not.
void show(const LightsAndShapes& ordered, LightsAndShapes& shown, const EventLog& log);

/// What a vessel that lies at anchor shows at that hour (s since local midnight): lights from sunset to
/// sunrise, a ball by day (COLREG 72, rules 20 and 30). The sun rises at 6 and sets at 18, as on the
/// stations' pages.
LightsAndShapes at_anchor_by(double time_of_day);

} // namespace windlass::exercise
