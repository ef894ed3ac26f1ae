#pragma once
// A ghost: the same lesson as other hands did it, to be laid behind an attempt's curves.

#include "recorder/debrief/attempt.hpp"
#include "recorder/recording/recording.hpp"

namespace windlass::recorder {

/// The model run of the attempt's lesson: its scripts played from the state in which the attempt began, with
/// the same chances, weather and instructor's faults. config: folder with the scripts. Throws
/// std::runtime_error, saying what is missing, when the attempt was at no lesson, the recording has no state
/// of its beginning that this program can go on from, or a script is not there.
debrief::Attempt model_ghost(recording::Recording& recording, const debrief::Attempt& attempt,
                             const std::filesystem::path& config);

} // namespace windlass::recorder
