#include "recorder/record/disk_space.hpp"

#include <fmt/format.h>

namespace windlass::recorder {

namespace fs = std::filesystem;

std::optional<std::string> disk_too_full(const fs::path& folder, std::uint64_t keep_free) {
    fs::path existing = fs::absolute(folder).lexically_normal();
    while (!fs::exists(existing) && existing.has_relative_path())
        existing = existing.parent_path();
    std::error_code error;
    const auto space = fs::space(existing, error);
    if (error) return existing.string() + ": the free space is not known: " + error.message();
    if (space.available >= keep_free) return std::nullopt;
    return fmt::format("{}: {} are free, {} are to be kept free (--keep-free)", existing.string(),
                       megabytes(space.available), megabytes(keep_free));
}

std::string megabytes(std::uint64_t bytes) {
    return fmt::format("{:.1f} MB", static_cast<double>(bytes) * 1e-6);
}

} // namespace windlass::recorder
