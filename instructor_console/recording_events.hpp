#pragma once
// What happened in a recording, for a page that shows it.

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace windlass::console {

/// Its events in the order in which they were heard, 5000 at most, the last ones: position (s from the
/// recording's beginning), tick, time, number, severity, code, side, value, text. Throws std::exception, with
/// what is wrong, when the recording cannot be read.
nlohmann::json events_of(const std::filesystem::path& recording);

/// What pages draw over time (gateway::past_of), a sample a second of exercise time, 7200 of each instance at
/// most, the last ones: lists of position (s), topic and payload in base64, by position. Runs that a restore
/// has left are among it. Throws as events_of().
nlohmann::json past_of(const std::filesystem::path& recording);

} // namespace windlass::console
