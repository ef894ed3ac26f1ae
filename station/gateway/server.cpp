// Boost.Asio 1.74 uses std::exchange without its header, which C++20 no longer brings along.
#include <utility>

#include "station/gateway/server.hpp"

#include "station/gateway/connection.hpp"

#include <thread>

namespace windlass::gateway {

namespace {
constexpr auto kTick = 50ms; // levers go out 20 times a second
}

struct Server::Impl {
    Impl(const ServerOptions& options, const Assets& assets, Gateway& gateway) : house{options, gateway} {
        try {
            const tcp::endpoint here{net::ip::make_address(options.address), options.port};
            acceptor.open(here.protocol());
            acceptor.set_option(net::socket_base::reuse_address(true));
            acceptor.bind(here);
            acceptor.listen();
        } catch (const std::exception& error) {
            throw std::runtime_error(
                fmt::format("cannot serve pages at {}:{}: {}", options.address, options.port, error.what()));
        }
        house.admission.emplace(AdmissionOptions{.hosts = hosts(),
                                                 .tls = false,
                                                 .token = options.token,
                                                 .exercise = options.exercise,
                                                 .any_exercise = options.any_exercise,
                                                 .foxglove = options.foxglove,
                                                 .foxglove_origins = options.foxglove_origins},
                                assets);
        accept();
        tick();
        thread = std::thread{[this] { house.io.run(); }};
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        house.io.stop();
        thread.join();
        for (const auto& [socket, session] : house.sockets)
            if (session != nullptr) session->close();
    }

    /// The names under which a browser on this computer reaches us.
    std::vector<std::string> hosts() const {
        const auto port = acceptor.local_endpoint().port();
        return {fmt::format("{}:{}", house.options.address, port), fmt::format("localhost:{}", port)};
    }

    void accept() {
        acceptor.async_accept([this](error_code error, tcp::socket socket) {
            if (!error) take(std::move(socket));
            if (!error) return accept();
            // No descriptors are left, say: the others go on, and this one tries again.
            pause.expires_after(100ms);
            pause.async_wait([this](error_code) { accept(); });
        });
    }

    void take(tcp::socket socket) {
        error_code error;
        const auto peer = socket.remote_endpoint(error);
        if (error) return;
        const std::string address = peer.address().to_string();
        if (house.connections >= kConnections)
            return house.gateway.log(address + ": turned away: too many connections");
        socket.set_option(tcp::no_delay(true), error);
        std::make_shared<Connection<beast::tcp_stream>>(beast::tcp_stream{std::move(socket)}, house, address)
            ->read();
    }

    void tick() {
        ticker.expires_after(kTick);
        ticker.async_wait([this](error_code error) {
            if (error) return;
            house.gateway.tick(Clock::now());
            tick();
        });
    }

    House house;
    tcp::acceptor acceptor{house.io};
    net::steady_timer ticker{house.io}, pause{house.io};
    std::thread thread;
};

Server::Server(const ServerOptions& options, const Assets& assets, Gateway& gateway)
    : impl_{std::make_unique<Impl>(options, assets, gateway)} {}
Server::~Server() = default;

unsigned short Server::port() const {
    return impl_->acceptor.local_endpoint().port();
}

} // namespace windlass::gateway
