#pragma once
// The key that ties sheets to recordings and to our marks, and the forms as they come back.

#include "recorder/blind/agreement.hpp"

#include <filesystem>

namespace windlass::blind {

/// The item of a form in which the rater says who he is, and our own name, which nobody else may have.
inline constexpr const char* kRaterItem = "rater";
inline constexpr const char* kOurs = "ours";
inline constexpr const char* kKeyFormat = "windlass blind key 1";

/// Of each sheet our mark of each item; nothing: it never came into play.
using Key = std::map<std::string, std::map<std::string, std::optional<int>>>;

/// Reads what `recorder blind sheets` has written. Throws ConfigError.
Key read_key(const std::filesystem::path& file);

/// Our own marks, as a rater's.
Rater ours_of(const Key& key);

/// Reads the forms of any raters, each of one sheet or of several, separated by commas or semicolons as
/// spreadsheets write them. Throws ConfigError with a line for each fault: `FILE:LINE: answer of ITEM:
/// "VALUE" is not allowed: ...`.
std::vector<Rater> read_forms(const std::vector<std::filesystem::path>& files, const Key& key);

} // namespace windlass::blind
