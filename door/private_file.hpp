#pragma once
// Files that nobody but the door's user may read.

#include <filesystem>
#include <string>

namespace windlass::door {

/// The folder, made where it is missing, mode 0700. Throws std::runtime_error, also when others may read it.
void private_folder(const std::filesystem::path& folder);

/// Writes the file whole or not at all, mode 0600. Throws std::runtime_error with its name.
void write_private(const std::filesystem::path& file, const std::string& text);

/// Throws std::runtime_error with its name.
std::string read_file(const std::filesystem::path& file);

} // namespace windlass::door
