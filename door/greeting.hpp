#pragma once
// The handshake of TLS, before there is anything to ask.

#include "station/gateway/connection.hpp"

#include <boost/asio/ssl/context.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket/ssl.hpp>

namespace windlass::door {

using TlsStream = gateway::beast::ssl_stream<gateway::beast::tcp_stream>;

/// One connection that has yet to shake hands: within gateway::kHandshake, and for as long as it has a place
/// in the lobby, so that those who never do it shut nobody out.
class Greeting : public std::enable_shared_from_this<Greeting> {
public:
    Greeting(gateway::tcp::socket socket, gateway::net::ssl::context& context, gateway::House& house,
             std::string address)
        : stream_{std::move(socket), context},
          house_{house},
          address_{std::move(address)},
          place_{house.enter(address_)} {}

    void begin() {
        place_->turned_out_by([weak = weak_from_this()] {
            if (const auto self = weak.lock()) gateway::beast::get_lowest_layer(self->stream_).close();
        });
        gateway::beast::get_lowest_layer(stream_).expires_after(gateway::kHandshake);
        stream_.async_handshake(
            gateway::net::ssl::stream_base::server, [self = shared_from_this()](gateway::error_code error) {
                if (error) return; // it went away, was turned out, or does not trust us: that is its affair
                self->place_->heard();
                std::make_shared<gateway::Connection<TlsStream>>(std::move(self->stream_), self->house_,
                                                                 self->address_, std::move(self->place_))
                    ->begin();
            });
    }

private:
    TlsStream stream_;
    gateway::House& house_;
    const std::string address_;
    std::unique_ptr<gateway::Lobby::Place> place_;
};

} // namespace windlass::door
