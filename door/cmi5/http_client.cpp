#include "door/cmi5/http_client.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>

#include <stdexcept>

namespace windlass::cmi5 {

namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;
using net::ip::tcp;

/// One thing after the other, each within what is left of the patience.
class Exchange {
public:
    Exchange(const WebRequest& request, std::chrono::milliseconds patience)
        : request_{request}, until_{std::chrono::steady_clock::now() + patience} {}

    WebAnswer by_http() {
        beast::tcp_stream stream{io_};
        connect(stream);
        return asked(stream, stream);
    }

    WebAnswer by_tls(const std::filesystem::path& authority) {
        net::ssl::context context{net::ssl::context::tls_client};
        context.set_options(net::ssl::context::default_workarounds | net::ssl::context::no_tlsv1 |
                            net::ssl::context::no_tlsv1_1);
        context.set_default_verify_paths();
        if (!authority.empty()) context.load_verify_file(authority.string());
        context.set_verify_mode(net::ssl::verify_peer);
        beast::ssl_stream<beast::tcp_stream> stream{io_, context};
        stream.set_verify_callback(net::ssl::host_name_verification(request_.url.host));
        SSL_set_tlsext_host_name(stream.native_handle(), request_.url.host.c_str());
        connect(stream.next_layer());
        wait([&](auto done) { stream.async_handshake(net::ssl::stream_base::client, done); });
        return asked(stream, stream.next_layer());
    }

private:
    /// begin: begins what calls back once, with what went wrong first.
    template <class Begin>
    void wait(Begin begin) {
        error_code failed;
        bool over = false;
        begin([&](error_code error, auto&&...) {
            failed = error;
            over = true;
        });
        io_.restart();
        io_.run_until(until_);
        if (!over) {
            io_.stop();
            throw std::runtime_error("no answer in time");
        }
        if (failed) throw std::runtime_error(failed.message());
    }

    void connect(beast::tcp_stream& stream) {
        tcp::resolver resolver{io_};
        tcp::resolver::results_type found;
        wait([&](auto done) {
            resolver.async_resolve(request_.url.host, std::to_string(request_.url.port),
                                   [&found, done](error_code error, const auto& results) mutable {
                                       found = results;
                                       done(error);
                                   });
        });
        stream.expires_at(until_);
        wait([&](auto done) { stream.async_connect(found, done); });
    }

    template <class Stream>
    WebAnswer asked(Stream& stream, beast::tcp_stream& below) {
        http::request<http::string_body> message{http::string_to_verb(request_.method), request_.url.target,
                                                 11};
        const std::string origin = request_.url.origin();
        message.set(http::field::host, origin.substr(origin.find("://") + 3));
        message.set(http::field::user_agent, "windlass");
        message.set(http::field::connection, "close");
        for (const auto& [name, value] : request_.headers)
            message.set(name, value);
        message.body() = request_.body;
        message.content_length(request_.body.size()); // of a POST without a body, too
        below.expires_at(until_);
        wait([&](auto done) { http::async_write(stream, message, done); });
        beast::flat_buffer buffer;
        http::response_parser<http::string_body> parser;
        parser.body_limit(WebClient::kLongest);
        wait([&](auto done) { http::async_read(stream, buffer, parser, done); });
        return {.status = static_cast<int>(parser.get().result_int()), .body = parser.get().body()};
    }

    const WebRequest& request_;
    const std::chrono::steady_clock::time_point until_;
    net::io_context io_{1};
};

} // namespace

WebAnswer WebClient::ask(const WebRequest& request) const {
    try {
        Exchange exchange(request, patience_);
        return request.url.tls ? exchange.by_tls(authority_) : exchange.by_http();
    } catch (const std::exception& error) {
        throw std::runtime_error(request.url.origin() + ": " + error.what());
    }
}

} // namespace windlass::cmi5
