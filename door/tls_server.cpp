#include "door/tls_server.hpp"
#include "door/greeting.hpp"
#include "station/gateway/listener.hpp"

#include <thread>

namespace windlass::door {

using gateway::House;
using gateway::Limits;
using gateway::Listener;
using gateway::Verdict;
namespace net = gateway::net;
namespace beast = gateway::beast;

namespace {

/// Leads whoever comes by HTTP to HTTPS, and does nothing else.
class Usher final : public gateway::Host {
public:
    explicit Usher(DoorHost& door) : door_{door} {}

    void judge(const gateway::Request& request, Reply reply) override {
        const std::string& host = request.host;
        const std::string name = host.ends_with(']') ? host : host.substr(0, host.rfind(':'));
        const bool plain =
            !name.empty() &&
            name.find_first_not_of("abcdefghijklmnopqrstuvwxyz"
                                   "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-[]:") == std::string::npos;
        if (!plain || !request.target.starts_with('/')) return reply(gateway::refused(400, "ask by https"));
        const std::string place = fmt::format("https://{}:{}{}", name, port, request.target);
        reply({.kind = Verdict::Kind::answer,
               .status = 308,
               .type = "text/plain; charset=utf-8",
               .body = place + "\n",
               .headers = {{"Location", place}}});
    }
    void tick(gateway::Clock::time_point) override {}
    void log(const std::string& line) override { door_.log(line); }

    unsigned short port = 0; ///< of HTTPS, once it is known

private:
    DoorHost& door_;
};

/// The same people by plain HTTP, on this computer.
class Loopback final : public gateway::Host {
public:
    explicit Loopback(DoorHost& door) : door_{door} {}

    void judge(const gateway::Request& request, Reply reply) override {
        door_.judge(Way::loopback, request, reply);
    }
    void tick(gateway::Clock::time_point) override {}
    void log(const std::string& line) override { door_.log(line); }

private:
    DoorHost& door_;
};

net::ssl::context context_of(const Certificate& certificate) {
    net::ssl::context context{net::ssl::context::tls_server};
    context.set_options(net::ssl::context::default_workarounds | net::ssl::context::no_tlsv1 |
                        net::ssl::context::no_tlsv1_1 | SSL_OP_NO_RENEGOTIATION |
                        SSL_OP_CIPHER_SERVER_PREFERENCE);
    try {
        context.use_certificate_chain_file(certificate.chain.string());
        context.use_private_key_file(certificate.key.string(), net::ssl::context::pem);
    } catch (const std::exception& error) {
        throw std::runtime_error(certificate.chain.string() + ": " + error.what());
    }
    return context;
}

} // namespace

struct TlsServer::Impl {
    Impl(const PortOptions& options, const Certificate& certificate, DoorHost& door)
        : context{context_of(certificate)},
          usher{door},
          loopback{door},
          door_house{door, {.sessions = options.sessions, .connections = kConnections, .body = kBody}, io},
          usher_house{usher, {.sessions = 0, .connections = 64}, io},
          loopback_house{loopback, {.sessions = options.sessions, .connections = 64, .body = kBody}, io},
          listener{io, options.address, options.port,
                   [this](gateway::tcp::socket socket, const std::string& address) {
                       std::make_shared<Greeting>(std::move(socket), context, door_house, address)->begin();
                   }},
          ticker{io, door} {
        usher.port = listener.port();
        door.at_port(listener.port());
        if (options.redirect) usher_listener = plain(options.address, *options.redirect, usher_house);
        if (options.loopback) loopback_listener = plain("127.0.0.1", *options.loopback, loopback_house);
        thread = std::thread{[this] { io.run(); }};
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        io.stop();
        thread.join();
        door_house.close_sessions();
        loopback_house.close_sessions();
    }

    std::unique_ptr<Listener> plain(const std::string& address, unsigned short port, House& house) {
        return std::make_unique<Listener>(
            io, address, port, [&house](gateway::tcp::socket socket, const std::string& from) {
                gateway::open_connection(beast::tcp_stream{std::move(socket)}, house, from);
            });
    }

    net::ssl::context context;
    Usher usher;
    Loopback loopback;
    House door_house, usher_house, loopback_house;
    net::io_context io{1}; // with it go the connections, before what they use
    Listener listener;
    std::unique_ptr<Listener> usher_listener, loopback_listener;
    gateway::Ticker ticker;
    std::thread thread;
};

TlsServer::TlsServer(const PortOptions& options, const Certificate& certificate, DoorHost& host)
    : impl_{std::make_unique<Impl>(options, certificate, host)} {}
TlsServer::~TlsServer() = default;

unsigned short TlsServer::port() const {
    return impl_->listener.port();
}
unsigned short TlsServer::redirect_port() const {
    return impl_->usher_listener ? impl_->usher_listener->port() : 0;
}
unsigned short TlsServer::loopback_port() const {
    return impl_->loopback_listener ? impl_->loopback_listener->port() : 0;
}

} // namespace windlass::door
