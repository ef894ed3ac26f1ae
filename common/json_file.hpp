#pragma once
// JSON files, read strictly: whatever is wrong with one is said with file, place and reason.

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <stdexcept>

namespace windlass {

/// A file that cannot be used. what() is the whole text for people, one line for each fault found:
/// `FILE: /json/pointer: VALUE is not allowed: ...`.
struct ConfigError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads one JSON document. Throws ConfigError when the file is missing or unreadable, is not JSON (with line
/// and column), gives a number too large for a double, or gives one field twice.
nlohmann::json read_json(const std::filesystem::path& file);

/// The same for text from elsewhere; source stands for the file in what is told. Throws ConfigError also for
/// objects and arrays nested deeper than 64, which nothing of ours comes near and which would exhaust the
/// stack.
nlohmann::json parse_json(const std::string& text, const std::string& source);

} // namespace windlass
