#include "station/gateway/server.hpp"
#include "station/gateway/connection.hpp"
#include "station/gateway/listener.hpp"
#include "station/gateway/page_session.hpp"

#include <thread>

namespace windlass::gateway {

namespace {

/// A station program's: whoever has its token has its seat.
class StationHost final : public Host {
public:
    explicit StationHost(Gateway& gateway) : gateway_{gateway} {}

    /// Once the port is known.
    void admit(AdmissionOptions options, const Assets& assets) {
        admission_.emplace(std::move(options), assets);
    }

    void judge(const Request& request, Reply reply) override {
        Verdict verdict = admission_->judge(request, Clock::now());
        verdict.open = [this, kind = verdict.kind, exercise = verdict.exercise](Transport& transport) {
            return kind == Verdict::Kind::page ? gateway_.open_page(exercise, transport)
                                               : gateway_.open_foxglove(exercise, transport);
        };
        reply(std::move(verdict));
    }
    void tick(Clock::time_point now) override { gateway_.tick(now); }
    void log(const std::string& line) override { gateway_.log(line); }

private:
    Gateway& gateway_;
    std::optional<Admission> admission_;
};

} // namespace

struct Server::Impl {
    Impl(const ServerOptions& options, const Assets& assets, Gateway& gateway)
        : host{gateway},
          house{host, Limits{}, io},
          listener{io, options.address, options.port,
                   [this](tcp::socket socket, const std::string& address) {
                       open_connection(beast::tcp_stream{std::move(socket)}, house, address);
                   }},
          ticker{io, host} {
        host.admit({.hosts = hosts(options),
                    .tls = false,
                    .token = options.token,
                    .exercise = options.exercise,
                    .any_exercise = options.any_exercise,
                    .foxglove = options.foxglove,
                    .foxglove_origins = options.foxglove_origins},
                   assets);
        thread = std::thread{[this] { io.run(); }};
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        io.stop();
        thread.join();
        house.close_sessions();
    }

    /// The names under which a browser on this computer reaches us.
    std::vector<std::string> hosts(const ServerOptions& options) const {
        return {fmt::format("{}:{}", options.address, listener.port()),
                fmt::format("localhost:{}", listener.port())};
    }

    StationHost host;
    House house;
    net::io_context io{1}; // with it go the connections, before what they use
    Listener listener;
    Ticker ticker;
    std::thread thread;
};

Server::Server(const ServerOptions& options, const Assets& assets, Gateway& gateway)
    : impl_{std::make_unique<Impl>(options, assets, gateway)} {}
Server::~Server() = default;

unsigned short Server::port() const {
    return impl_->listener.port();
}

} // namespace windlass::gateway
