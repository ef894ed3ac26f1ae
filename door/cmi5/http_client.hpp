#pragma once
// Asks a web server, once. Nothing of Boost and OpenSSL shows here.

#include "door/cmi5/url.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>

namespace windlass::cmi5 {

struct WebRequest {
    std::string method = "GET";
    Url url;
    std::vector<std::pair<std::string, std::string>> headers = {};
    std::string body = {};
};

struct WebAnswer {
    int status = 0;
    std::string body = {};
};

class WebClient {
public:
    static constexpr std::size_t kLongest = 256 * 1024; ///< bytes of an answer's body

    /// authority: certificates in PEM that are trusted beside the system's; empty: none. patience: for one
    /// question, but for the name's address, which the system looks up at its own pace.
    explicit WebClient(std::filesystem::path authority = {},
                       std::chrono::milliseconds patience = std::chrono::seconds(10))
        : authority_{std::move(authority)}, patience_{patience} {}

    /// Whatever the answer's status is; no redirection is followed. Waits. Throws std::runtime_error with the
    /// origin when nobody answers in time, or somebody whose certificate is not the host's.
    WebAnswer ask(const WebRequest& request) const;

private:
    std::filesystem::path authority_;
    std::chrono::milliseconds patience_;
};

} // namespace windlass::cmi5
