#pragma once
// What the server's connections share. Beast shows in house.hpp, socket.hpp and connection.hpp, which
// server.cpp alone includes: they are slow to compile.

#include "station/gateway/server.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

namespace windlass::gateway {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;
using net::ip::tcp;
using namespace std::chrono_literals;

inline constexpr auto kHandshake = 5s;
inline constexpr auto kIdle = 20s; // without a sign of life; a ping goes out after half of it

/// Everything on the server's thread.
struct House {
    House(const ServerOptions& wanted, Gateway& its_gateway) : options{wanted}, gateway{its_gateway} {}

    const ServerOptions options;
    Gateway& gateway;
    std::optional<Admission> admission;      // once the port is known
    std::map<const void*, Session*> sockets; // that are open; with a session once the page has shaken hands
    int connections = 0;                     // that are not sockets
    net::io_context io{1};                   // last: with it go the connections
};

/// What every answer carries.
template <class Message>
void set_headers(Message& message) {
    message.set(http::field::server, "windlass");
    message.set("Content-Security-Policy",
                "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
                "frame-ancestors 'none'");
    message.set("X-Content-Type-Options", "nosniff");
    message.set("Referrer-Policy", "no-referrer");
    message.set("Cross-Origin-Opener-Policy", "same-origin");
    message.set("Cross-Origin-Resource-Policy", "same-origin");
}

} // namespace windlass::gateway
