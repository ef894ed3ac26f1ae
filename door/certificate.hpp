#pragma once
// The door's own authority, for a house that has none: made once, kept in the state folder, and a certificate
// by it for the names and addresses under which this machine is reached today. By OpenSSL.

#include <filesystem>
#include <string>
#include <vector>

namespace windlass::door {

struct Certificate {
    std::filesystem::path chain, key;       ///< PEM
    std::filesystem::path authority;        ///< PEM, of our own; empty: the house's certificate
    std::string fingerprint;                ///< SHA-256 of the certificate: "AB:CD:..."
    std::string authority_fingerprint;      ///< the same of our own authority
    std::vector<std::string> left_out = {}; ///< names that our authority may not vouch for
};

/// A certificate of the house's. Throws std::runtime_error when the files are none, or do not belong
/// together.
Certificate given_certificate(const std::filesystem::path& chain, const std::filesystem::path& key);

/// Ours, for these DNS names and IP addresses, good for 397 days; the authority in the folder is made where
/// there is none. It can vouch for nothing but names of this machine and addresses of private networks (and
/// those that it was made for), so that who trusts it trusts it with no more. Throws std::runtime_error.
Certificate own_certificate(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// localhost, this machine's name with and without ".local", and the addresses of its interfaces.
std::vector<std::string> own_names();

} // namespace windlass::door
