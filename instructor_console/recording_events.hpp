#pragma once
// What happened in a recording, for a page that shows it.

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace windlass::console {

/// Its events in the order in which they were heard, 5000 at most, the last ones: position (s from the
/// recording's beginning), tick, time, number, severity, code, side, value, text. Throws std::exception, with
/// what is wrong, when the recording cannot be read.
nlohmann::json events_of(const std::filesystem::path& recording);

} // namespace windlass::console
