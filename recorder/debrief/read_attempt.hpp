#pragma once
// An attempt out of a recording.

#include "recorder/debrief/attempt.hpp"
#include "recorder/recording/recording.hpp"

namespace windlass::debrief {

/// Reads the wanted run (1: the first of the recording; 0: the last). Runs between which the server was lost
/// and the exercise taken up again are one; what was heard of the ticks that were lost is left out. Messages
/// that are not of their type are left out, as damaged chunks are, and Origin::complete says so. Throws
/// std::runtime_error, saying what there is, when the recording has no such run, or no state of any exercise.
Attempt read_attempt(recording::Recording& recording, std::size_t run = 0);

} // namespace windlass::debrief
