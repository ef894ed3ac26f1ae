#pragma once

#include <filesystem>
#include <string>

namespace windlass::console {

/// The debriefing of a recording's last run as a page that this station serves: its times open the replay
/// beside it. config: folder with the scripts of the lessons' model runs, which are laid behind the curves.
/// Throws std::exception, with what is wrong, when the recording cannot be read.
std::string debrief_page(const std::filesystem::path& recording, const std::filesystem::path& config);

} // namespace windlass::console
