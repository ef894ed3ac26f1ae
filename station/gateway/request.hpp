#pragma once
// A request of the network and what is made of it. Nothing of Boost shows here.

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace windlass::gateway {

struct Asset;
class FoxgloveSession;
class Transport;

/// What of a request matters here; empty: not there.
struct Request {
    std::string method, target;
    std::string host, origin;
    bool upgrade = false;     ///< to a WebSocket
    std::string subprotocols; ///< comma-separated
    std::string address;      ///< whence it comes, without port
    std::string cookie = {};
    std::string body = {};
};

/// What to do with a request.
struct Verdict {
    enum class Kind { refused, file, answer, page, foxglove } kind = Kind::refused;
    int status = 200;        ///< HTTP
    std::string reason = {}; ///< of a refusal, one line
    std::shared_ptr<const Asset> file = {};
    std::string exercise = {};                                     ///< to open
    std::string subprotocol = {};                                  ///< that is spoken
    std::string type = {};                                         ///< MIME, of an answer
    std::string body = {};                                         ///< of an answer
    std::vector<std::pair<std::string, std::string>> headers = {}; ///< beside those of every answer
    /// page and foxglove: begins the session, once the WebSocket stands. Throws std::exception.
    std::function<std::shared_ptr<FoxgloveSession>(Transport&)> open = {};
};

/// A refusal that says why.
inline Verdict refused(int status, std::string reason) {
    return {.kind = Verdict::Kind::refused, .status = status, .reason = std::move(reason)};
}

} // namespace windlass::gateway
