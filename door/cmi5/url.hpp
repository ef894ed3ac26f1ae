#pragma once
// Addresses of a learning system, and whether this door may ask there.

#include <optional>
#include <string>
#include <vector>

namespace windlass::cmi5 {

struct Url {
    bool tls = true;
    std::string host; ///< lower case; of IPv6 without brackets
    unsigned short port = 443;
    std::string target; ///< path and query; "/" at least

    /// "https://lms.example:8443"; the port only where it is not the scheme's own.
    std::string origin() const;
};

/// Of an absolute address by http or https; nothing: it is none, or has a user, a fragment, or what stands in
/// no address.
std::optional<Url> url_of(const std::string& text);

/// The text with all that has a meaning in an address written as %XX, and back. plain() leaves alone what is
/// no escape.
std::string escaped(const std::string& text);
std::string plain(const std::string& text);

/// Whom the door asks, and nobody else: an address in a launch is anybody's word.
class LearningSystems {
public:
    LearningSystems() = default;
    /// Origins: https, or http of this computer alone. Throws std::runtime_error naming the one that is none.
    explicit LearningSystems(const std::vector<std::string>& origins);

    bool empty() const { return origins_.empty(); }
    bool allow(const Url& url) const;
    /// All of them, for people: "https://a, https://b".
    std::string told() const;

private:
    std::vector<std::string> origins_;
};

} // namespace windlass::cmi5
