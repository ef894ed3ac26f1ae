#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace windlass::recording {

/// SHA-256 in hexadecimal, as sha256sum prints it. Throws std::runtime_error where OpenSSL has none.
std::string sha256(std::string_view text);

/// The same of the files' contents, one behind the other. Throws std::runtime_error naming the file that
/// cannot be read.
std::string sha256(const std::vector<std::filesystem::path>& files);

} // namespace windlass::recording
