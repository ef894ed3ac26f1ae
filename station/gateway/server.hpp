#pragma once
// The gateway's own small web server: pages by HTTP, sessions by WebSocket. Nothing of Boost shows here.

#include "station/gateway/admission.hpp"
#include "station/gateway/gateway.hpp"

namespace windlass::gateway {

struct ServerOptions {
    std::string address = "127.0.0.1"; ///< to listen at
    unsigned short port = 0;           ///< 0: any that is free
    std::string token;
    std::string exercise;      ///< that the program joined
    bool any_exercise = false; ///< pages may name another
    bool foxglove = false;
    std::vector<std::string> foxglove_origins;
};

/// Serves on a thread of its own until it is destroyed.
class Server {
public:
    /// Throws std::runtime_error when it cannot listen there.
    Server(const ServerOptions& options, const Assets& assets, Gateway& gateway);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    unsigned short port() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace windlass::gateway
