#pragma once
// What would have kept the lost points of a recorded lesson, for its debriefing. The search is
// recorder/whatif's.

#include "recorder/debrief/page.hpp"
#include "recorder/recording/recording.hpp"

#include <filesystem>
#include <functional>
#include <stop_token>

namespace windlass::recorder {

/// Hears how far a search is, in words.
using Tell = std::function<void(const std::string&)>;

/// Of each criterion that lost points, in the order in which they were lost: by as many threads as there are
/// processors, scheduled as the calling one is. run: 1 the first, 0 the last; config: folder with the scripts
/// of the model run. tell: is called by one thread at a time. Throws std::runtime_error, with why: there is
/// no lesson that came to its end, the recording lacks what a trial needs, or it was stopped.
std::vector<debrief::Remedy> remedies_of(recording::Recording& recording, std::size_t run,
                                         const std::filesystem::path& config, const Tell& tell,
                                         std::stop_token stop = {});

} // namespace windlass::recorder
