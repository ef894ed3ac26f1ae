#pragma once
// The door's ports: HTTPS and WSS for everybody, HTTP that only leads there, plain HTTP for this computer
// alone. Nothing of Boost and OpenSSL shows here.

#include "door/certificate.hpp"
#include "door/door_host.hpp"

namespace windlass::door {

struct PortOptions {
    std::string address = "0.0.0.0";        ///< to listen at
    unsigned short port = 8443;             ///< HTTPS; 0: any that is free
    std::optional<unsigned short> redirect; ///< HTTP that only leads to HTTPS
    std::optional<unsigned short> loopback; ///< plain HTTP at 127.0.0.1
    std::size_t sessions = 1000;            ///< WebSockets at a time
};

/// Serves on a thread of its own until it is destroyed.
class TlsServer {
public:
    static constexpr std::size_t kConnections = 512; ///< of HTTPS, that are no WebSockets, at a time
    static constexpr std::size_t kBody = 8192;       ///< bytes of a request's body

    /// Throws std::runtime_error when it cannot listen there, or the certificate is none.
    TlsServer(const PortOptions& options, const Certificate& certificate, DoorHost& host);
    ~TlsServer();
    TlsServer(const TlsServer&) = delete;
    TlsServer& operator=(const TlsServer&) = delete;

    unsigned short port() const;
    unsigned short redirect_port() const; ///< 0: there is none
    unsigned short loopback_port() const; ///< 0: there is none

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace windlass::door
