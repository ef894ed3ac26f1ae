#pragma once
// What would have kept the lost points of a recorded lesson, for its debriefing. The search is
// recorder/whatif's.

#include "recorder/debrief/page.hpp"
#include "recorder/recording/recording.hpp"

#include <filesystem>

namespace windlass::recorder {

/// Of each criterion that lost points, in the order in which they were lost; tells how far it is. run: 1 the
/// first, 0 the last; config: folder with the scripts of the model run. Nothing, and why is told: there is no
/// lesson that came to its end, or the recording lacks what a trial needs.
std::optional<std::vector<debrief::Remedy>> remedies_of(recording::Recording& recording, std::size_t run,
                                                        const std::filesystem::path& config);

} // namespace windlass::recorder
