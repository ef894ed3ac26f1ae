#pragma once
// A port that takes connections, and the host's heartbeat.

#include "station/gateway/house.hpp"

#include <fmt/format.h>

namespace windlass::gateway {

class Listener {
public:
    /// A connection, and whence it comes.
    using Take = std::function<void(tcp::socket, const std::string& address)>;

    /// Port 0: any that is free. Throws std::runtime_error when it cannot listen there.
    Listener(net::io_context& io, const std::string& address, unsigned short port, Take take)
        : take_{std::move(take)}, acceptor_{io}, pause_{io} {
        try {
            const tcp::endpoint here{net::ip::make_address(address), port};
            acceptor_.open(here.protocol());
            acceptor_.set_option(net::socket_base::reuse_address(true));
            acceptor_.bind(here);
            acceptor_.listen();
        } catch (const std::exception& error) {
            throw std::runtime_error(
                fmt::format("cannot serve pages at {}:{}: {}", address, port, error.what()));
        }
        accept();
    }

    unsigned short port() const { return acceptor_.local_endpoint().port(); }

private:
    void accept() {
        acceptor_.async_accept([this](error_code error, tcp::socket socket) {
            if (!error) welcome(std::move(socket));
            if (!error) return accept();
            // No descriptors are left, say: the others go on, and this one tries again.
            pause_.expires_after(100ms);
            pause_.async_wait([this](error_code stopped) {
                if (!stopped) accept();
            });
        });
    }

    void welcome(tcp::socket socket) {
        error_code error;
        const auto peer = socket.remote_endpoint(error);
        if (error) return;
        socket.set_option(tcp::no_delay(true), error);
        take_(std::move(socket), peer.address().to_string());
    }

    Take take_;
    tcp::acceptor acceptor_;
    net::steady_timer pause_;
};

/// Ticks the host 20 times a second: levers go out so often.
class Ticker {
public:
    Ticker(net::io_context& io, Host& host) : host_{host}, timer_{io} { wait(); }

private:
    void wait() {
        timer_.expires_after(50ms);
        timer_.async_wait([this](error_code error) {
            if (error) return;
            host_.tick(Clock::now());
            wait();
        });
    }

    Host& host_;
    net::steady_timer timer_;
};

} // namespace windlass::gateway
