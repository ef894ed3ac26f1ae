#pragma once
// What stands in the files of an identity, read before DDS reads them: DDS does not say why it refuses one.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace windlass::wire {

/// How long before its end a paper of an identity is told of.
inline constexpr std::chrono::days kIdentityWarning{30};

/// Looks at certificate, permissions, authorities and list of the revoked (crl.pem, where there is one) in
/// that folder. Returns what ends within kIdentityWarning of `now`, a sentence each with file, date and the
/// command that renews. Throws std::runtime_error, saying the same, where one has ended or not begun, where
/// the identity is revoked, and where a file is no certificate or no list.
std::vector<std::string> look_at_identity(const std::filesystem::path& folder,
                                          std::chrono::system_clock::time_point now);

} // namespace windlass::wire
