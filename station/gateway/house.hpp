#pragma once
// What the connections of one port share. Beast shows in house.hpp, listener.hpp, socket.hpp and
// connection.hpp, which servers alone include: they are slow to compile.

// Boost.Asio 1.74 uses std::exchange without its header, which C++20 no longer brings along.
#include <utility>

#include "station/gateway/host.hpp"
#include "station/gateway/lobby.hpp"
#include "station/gateway/session.hpp"

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

/// Everything on the network's thread. The connections end before it does: it stands before its io_context.
struct House {
    House(Host& its_host, Limits its_limits, net::io_context& its_io)
        : host{its_host}, limits{its_limits}, io{its_io}, lobby{its_limits.connections} {}

    /// A place for a connection that has just come.
    std::unique_ptr<Lobby::Place> enter(const std::string& address) {
        std::string turned_out;
        auto place = lobby.enter(address, turned_out);
        if (!turned_out.empty()) host.log(turned_out + ": turned out: too many connections");
        return place;
    }

    /// Once nothing runs on its thread any more.
    void close_sessions() const {
        for (const auto& [socket, session] : sockets)
            if (session != nullptr) session->close();
    }

    Host& host;
    const Limits limits;
    net::io_context& io;
    Lobby lobby;
    std::map<const void*, FoxgloveSession*>
        sockets; // that are open; with a session once the page has shaken hands
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
