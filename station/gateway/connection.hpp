#pragma once
// One HTTP connection: asks the host, and gives its answers, until it becomes a WebSocket.

#include "common/text.hpp"
#include "station/gateway/assets.hpp"
#include "station/gateway/socket.hpp"

namespace windlass::gateway {

/// Stream as with Socket.
template <class Stream>
class Connection : public std::enable_shared_from_this<Connection<Stream>> {
public:
    Connection(Stream stream, House& house, std::string address, std::unique_ptr<Lobby::Place> place)
        : stream_{std::move(stream)}, house_{house}, address_{std::move(address)}, place_{std::move(place)} {}

    void begin() {
        place_->turned_out_by([weak = this->weak_from_this()] {
            if (const auto self = weak.lock()) beast::get_lowest_layer(self->stream_).close();
        });
        read();
    }

private:
    using Body = http::string_body;
    static constexpr std::size_t kHeader = 8 * 1024;

    static std::string text(beast::string_view view) { return {view.data(), view.size()}; }

    void read() {
        parser_.emplace();
        parser_->header_limit(kHeader);
        // boost::none is less than any length to Boost 1.74; a body that nobody reads needs no limit.
        if (house_.limits.body > 0) parser_->body_limit(house_.limits.body);
        beast::get_lowest_layer(stream_).expires_after(kHandshake);
        http::async_read_header(stream_, buffer_, *parser_,
                                [self = this->shared_from_this()](error_code error, std::size_t) {
                                    if (error) return self->no_request(error);
                                    self->read_body();
                                });
    }

    void read_body() {
        if (house_.limits.body == 0 || parser_->is_done()) return ask();
        http::async_read(stream_, buffer_, *parser_,
                         [self = this->shared_from_this()](error_code error, std::size_t) {
                             if (error) return self->no_request(error);
                             self->ask();
                         });
    }

    void no_request(error_code error) {
        if (error == http::error::body_limit)
            return refuse(413, fmt::format("{} bytes are taken at most", house_.limits.body));
        if (error != http::error::end_of_stream && error != beast::error::timeout)
            house_.host.log(fmt::format("{}: no request: {}", address_, error.message()));
    }

    void ask() {
        place_->heard();
        const auto& message = parser_->get();
        house_.host.judge(
            {.method = text(message.method_string()),
             .target = text(message.target()),
             .host = text(message[http::field::host]),
             .origin = text(message[http::field::origin]),
             .upgrade = websocket::is_upgrade(message),
             .subprotocols = text(message[http::field::sec_websocket_protocol]),
             .address = address_,
             .cookie = text(message[http::field::cookie]),
             .body = message.body()},
            [self = this->shared_from_this()](Verdict verdict) { self->answer(std::move(verdict)); });
    }

    void answer(Verdict verdict) {
        switch (verdict.kind) {
        case Verdict::Kind::refused:
            return refuse(verdict.status, verdict.reason);
        case Verdict::Kind::file:
            return give(verdict.file);
        case Verdict::Kind::answer:
            return say(verdict);
        case Verdict::Kind::page:
        case Verdict::Kind::foxglove:
            return upgrade(std::move(verdict));
        }
    }

    void upgrade(Verdict verdict) {
        if (house_.sockets.size() >= house_.limits.sessions)
            return refuse(503, "there are as many pages as this station takes");
        place_.reset();
        std::make_shared<Socket<Stream>>(std::move(stream_), house_, std::move(verdict), address_)
            ->run(parser_->release());
    }

    void refuse(int status, const std::string& reason) {
        const auto& message = parser_->get();
        const std::string target = text(message.target());
        const std::string path = printable(target.substr(0, std::min<std::size_t>(target.find('?'), 100)));
        house_.host.log(fmt::format("{}: {} {}: {} {}", address_, printable(text(message.method_string())),
                                    path, status, reason));
        auto response = make_response<http::string_body>(status);
        response->set(http::field::content_type, "text/plain; charset=utf-8");
        response->set(http::field::cache_control, "no-store");
        if (status == 405) response->set(http::field::allow, "GET, HEAD");
        if (status != 404) response->keep_alive(false);
        response->body() = reason + "\n";
        response->prepare_payload();
        send(std::move(response));
    }

    void say(const Verdict& verdict) {
        auto response = make_response<http::string_body>(verdict.status);
        response->set(http::field::content_type, verdict.type);
        response->set(http::field::cache_control, "no-store");
        for (const auto& [name, value] : verdict.headers)
            response->set(name, value);
        response->body() = verdict.body;
        response->prepare_payload();
        send(std::move(response));
    }

    void give(const std::shared_ptr<const Asset>& file) {
        const Asset& asset = *file;
        const auto& message = parser_->get();
        const bool zipped = !asset.zipped.empty() &&
                            message[http::field::accept_encoding].find("gzip") != beast::string_view::npos;
        const std::string& content = zipped ? asset.zipped : asset.content;
        auto response = make_response<http::span_body<const char>>(200);
        response->set(http::field::content_type, asset.type);
        response->set(http::field::cache_control,
                      asset.immutable ? "public, max-age=31536000, immutable" : "no-cache");
        if (!asset.zipped.empty()) response->set(http::field::vary, "Accept-Encoding");
        if (zipped) response->set(http::field::content_encoding, "gzip");
        response->body() = {content.data(), content.size()};
        response->prepare_payload();
        send(std::move(response), file);
    }

    template <class Content>
    std::shared_ptr<http::response<Content>> make_response(int status) const {
        const auto& message = parser_->get();
        auto response =
            std::make_shared<http::response<Content>>(static_cast<http::status>(status), message.version());
        set_headers(*response);
        response->keep_alive(message.keep_alive() && parser_->is_done()); // a body may not have been read
        return response;
    }

    /// file: what the body is a view of, if it is one.
    template <class Content>
    void send(std::shared_ptr<http::response<Content>> response, std::shared_ptr<const Asset> file = {}) {
        beast::get_lowest_layer(stream_).expires_after(kIdle);
        const auto serializer = std::make_shared<http::serializer<false, Content>>(*response);
        auto sent = [self = this->shared_from_this(), response, serializer, file](error_code error,
                                                                                  std::size_t) {
            if (error) return;
            if (response->keep_alive()) return self->read();
            self->finish();
        };
        if (parser_->get().method() == http::verb::head)
            http::async_write_header(stream_, *serializer, std::move(sent));
        else
            http::async_write(stream_, *serializer, std::move(sent));
    }

    void finish() {
        if constexpr (requires { stream_.async_shutdown([](error_code) {}); }) { // TLS says good-bye
            beast::get_lowest_layer(stream_).expires_after(kHandshake);
            stream_.async_shutdown([self = this->shared_from_this()](error_code) {});
        } else {
            error_code ignored;
            stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
        }
    }

    Stream stream_;
    House& house_;
    const std::string address_;
    std::unique_ptr<Lobby::Place> place_;
    beast::flat_buffer buffer_;
    std::optional<http::request_parser<Body>> parser_;
};

/// A connection that has just come.
template <class Stream>
void open_connection(Stream stream, House& house, const std::string& address) {
    std::make_shared<Connection<Stream>>(std::move(stream), house, address, house.enter(address))->begin();
}

} // namespace windlass::gateway
