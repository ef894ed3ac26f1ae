#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace windlass::recorder {

/// Nothing while the disk that the folder is on has so many bytes free; otherwise what is short, in words.
/// The folder need not exist yet.
std::optional<std::string> disk_too_full(const std::filesystem::path& folder, std::uint64_t keep_free);

/// "12.3 MB"
std::string megabytes(std::uint64_t bytes);

} // namespace windlass::recorder
