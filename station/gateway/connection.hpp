#pragma once
// One HTTP connection: files, until it asks for a WebSocket.

#include "common/text.hpp"
#include "station/gateway/socket.hpp"

namespace windlass::gateway {

/// Counts itself as long as it lives.
class Counted {
public:
    explicit Counted(int& count) : count_{count} { ++count_; }
    ~Counted() { --count_; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;

private:
    int& count_;
};

/// Stream as with Socket.
template <class Stream>
class Connection : public std::enable_shared_from_this<Connection<Stream>> {
public:
    Connection(Stream stream, House& house, std::string address)
        : stream_{std::move(stream)},
          house_{house},
          address_{std::move(address)},
          counted_{house.connections} {}

    void read() {
        parser_.emplace();
        parser_->header_limit(kHeader);
        beast::get_lowest_layer(stream_).expires_after(kHandshake);
        http::async_read_header(stream_, buffer_, *parser_,
                                [self = this->shared_from_this()](error_code error, std::size_t) {
                                    if (error) return self->no_request(error);
                                    self->answer();
                                });
    }

private:
    static constexpr std::size_t kHeader = 8 * 1024;

    static std::string text(beast::string_view view) { return {view.data(), view.size()}; }

    void no_request(error_code error) const {
        if (error != http::error::end_of_stream && error != beast::error::timeout)
            house_.gateway.log(fmt::format("{}: no request: {}", address_, error.message()));
    }

    void answer() {
        const auto& message = parser_->get();
        const Verdict verdict =
            house_.admission->judge({.method = text(message.method_string()),
                                     .target = text(message.target()),
                                     .host = text(message[http::field::host]),
                                     .origin = text(message[http::field::origin]),
                                     .upgrade = websocket::is_upgrade(message),
                                     .subprotocols = text(message[http::field::sec_websocket_protocol]),
                                     .address = address_},
                                    Clock::now());
        if (verdict.kind == Verdict::Kind::refused) return refuse(verdict.status, verdict.reason);
        if (verdict.kind == Verdict::Kind::file) return give(verdict.file);
        if (house_.sockets.size() >= Server::kSessions)
            return refuse(503, "there are as many pages as this station takes");
        std::make_shared<Socket<Stream>>(std::move(stream_), house_, verdict, address_)
            ->run(parser_->release());
    }

    void refuse(int status, const std::string& reason) {
        const auto& message = parser_->get();
        const std::string target = text(message.target());
        const std::string path = printable(target.substr(0, std::min<std::size_t>(target.find('?'), 100)));
        house_.gateway.log(fmt::format("{}: {} {}: {} {}", address_, printable(text(message.method_string())),
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

    template <class Body>
    std::shared_ptr<http::response<Body>> make_response(int status) const {
        const auto& message = parser_->get();
        auto response =
            std::make_shared<http::response<Body>>(static_cast<http::status>(status), message.version());
        set_headers(*response);
        const bool with_body = message.has_content_length() || message.chunked(); // which is not read
        response->keep_alive(message.keep_alive() && !with_body);
        return response;
    }

    /// file: what the body is a view of, if it is one.
    template <class Body>
    void send(std::shared_ptr<http::response<Body>> response, std::shared_ptr<const Asset> file = {}) {
        beast::get_lowest_layer(stream_).expires_after(kIdle);
        const auto serializer = std::make_shared<http::serializer<false, Body>>(*response);
        auto sent = [self = this->shared_from_this(), response, serializer, file](error_code error,
                                                                                  std::size_t) {
            if (error) return;
            if (response->keep_alive()) return self->read();
            error_code ignored;
            beast::get_lowest_layer(self->stream_).socket().shutdown(tcp::socket::shutdown_send, ignored);
        };
        if (parser_->get().method() == http::verb::head)
            http::async_write_header(stream_, *serializer, std::move(sent));
        else
            http::async_write(stream_, *serializer, std::move(sent));
    }

    Stream stream_;
    House& house_;
    const std::string address_;
    const Counted counted_;
    beast::flat_buffer buffer_;
    std::optional<http::request_parser<http::empty_body>> parser_;
};

} // namespace windlass::gateway
