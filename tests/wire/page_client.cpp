#include <utility> // std::exchange, which Boost.Asio 1.74 uses without it

#include "tests/wire/page_client.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <cstring>
#include <deque>
#include <mutex>
#include <thread>

namespace windlass::test {

namespace websocket = boost::beast::websocket;

struct PageClient::Impl {
    Impl(const PageAddress& address, const Options& wanted) : options_(wanted), ws_(io_) {
        namespace http = boost::beast::http;
        boost::beast::get_lowest_layer(ws_).connect(
            tcp::endpoint(boost::asio::ip::make_address("127.0.0.1"), address.port));
        std::string origin = options_.origin;
        if (const auto port = origin.find("PORT"); port != std::string::npos)
            origin.replace(port, 4, std::to_string(address.port));
        ws_.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
            if (!origin.empty()) request.set(http::field::origin, origin);
            request.set(http::field::sec_websocket_protocol, options_.subprotocol);
            if (!options_.cookie.empty()) request.set(http::field::cookie, options_.cookie);
        }));
        websocket::response_type response;
        boost::system::error_code error;
        const std::string target =
            options_.target.empty() ? "/ws?token=" + address.token +
                                          (options_.exercise.empty() ? "" : "&exercise=" + options_.exercise)
                                    : options_.target;
        ws_.handshake(response, "127.0.0.1:" + std::to_string(address.port), target, error);
        if (error) throw std::runtime_error(error.message());
        read();
        thread_ = std::thread([this] {
            const auto work = boost::asio::make_work_guard(io_);
            io_.run();
        });
    }
    ~Impl() { stop(); }
    void stop() {
        io_.stop();
        if (thread_.joinable()) thread_.join();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void say(const std::string& bytes, bool text) {
        boost::asio::post(io_, [this, bytes, text] {
            waiting_.push_back({bytes, text});
            if (waiting_.size() == 1) write();
        });
    }

    std::vector<Json> told(const std::string& op) const {
        const std::lock_guard lock(mutex_);
        std::vector<Json> found;
        for (const Json& message : texts_)
            if (message.value("op", "") == op) found.push_back(message);
        return found;
    }
    std::vector<Payload> samples(const std::string& topic) const {
        const std::lock_guard lock(mutex_);
        const auto found = samples_.find(topic);
        return found == samples_.end() ? std::vector<Payload>{} : found->second;
    }
    std::vector<std::uint64_t> stamps(const std::string& topic) const {
        const std::lock_guard lock(mutex_);
        const auto found = stamps_.find(topic);
        return found == stamps_.end() ? std::vector<std::uint64_t>{} : found->second;
    }
    std::vector<std::uint64_t> times() const {
        const std::lock_guard lock(mutex_);
        return times_;
    }
    std::map<std::uint32_t, std::string> channels() const {
        const std::lock_guard lock(mutex_);
        return channels_;
    }
    std::vector<std::string> heard() const {
        const std::lock_guard lock(mutex_);
        std::vector<std::string> names;
        for (const auto& [name, samples] : samples_)
            names.push_back(name);
        return names;
    }

    std::optional<int> closed() const {
        const std::lock_guard lock(mutex_);
        return closed_;
    }

    using tcp = boost::asio::ip::tcp;
    struct Out {
        std::string bytes;
        bool text;
    };

    void read() {
        ws_.async_read(buffer_, [this](boost::system::error_code error, std::size_t) {
            const std::lock_guard lock(mutex_);
            if (error) {
                closed_ = ws_.reason().code == websocket::close_code::none ? 1006 : int(ws_.reason().code);
                return;
            }
            const auto bytes = boost::beast::buffers_to_string(buffer_.data());
            buffer_.consume(buffer_.size());
            ws_.got_text() ? take_text(bytes) : take_sample(bytes);
            read();
        });
    }
    void take_text(const std::string& text) {
        texts_.push_back(Json::parse(text));
        if (texts_.back()["op"] != "advertise") return;
        Json subscriptions = Json::array();
        for (const Json& channel : texts_.back()["channels"]) {
            const auto number = channel["id"].get<std::uint32_t>();
            channels_[number] = channel["topic"].get<std::string>().substr(1);
            subscriptions.push_back({{"id", number}, {"channelId", number}});
        }
        if (options_.subscribes)
            say(Json{{"op", "subscribe"}, {"subscriptions", subscriptions}}.dump(), true);
    }
    void take_sample(const std::string& bytes) {
        std::uint32_t number = 0;
        std::uint64_t ns = 0;
        if (bytes.size() == 9 && bytes[0] == 2) {
            std::memcpy(&ns, &bytes[1], 8);
            times_.push_back(ns);
        }
        if (bytes.size() < 17 || bytes[0] != 1) return;
        std::memcpy(&number, &bytes[1], 4);
        std::memcpy(&ns, &bytes[5], 8);
        samples_[channels_[number]].emplace_back(bytes.begin() + 13, bytes.end());
        stamps_[channels_[number]].push_back(ns);
    }
    void write() {
        ws_.text(waiting_.front().text);
        ws_.async_write(boost::asio::buffer(waiting_.front().bytes),
                        [this](boost::system::error_code error, std::size_t) {
                            if (error) return;
                            waiting_.pop_front();
                            if (!waiting_.empty()) write();
                        });
    }

    using WebSocket = boost::beast::websocket::stream<boost::beast::tcp_stream>;
    const Options options_;
    boost::asio::io_context io_;
    WebSocket ws_;
    boost::beast::flat_buffer buffer_;
    std::deque<Out> waiting_;
    mutable std::mutex mutex_;
    std::vector<Json> texts_;
    std::map<std::uint32_t, std::string> channels_;
    std::map<std::string, std::vector<Payload>> samples_;
    std::map<std::string, std::vector<std::uint64_t>> stamps_;
    std::vector<std::uint64_t> times_;
    std::optional<int> closed_;
    std::thread thread_;
};

PageClient::PageClient(const PageAddress& address) : PageClient(address, Options{}) {}
PageClient::PageClient(const PageAddress& address, const Options& options)
    : impl_(std::make_unique<Impl>(address, options)) {}
PageClient::~PageClient() = default;

void PageClient::say(const std::string& bytes, bool text) {
    impl_->say(bytes, text);
}
std::vector<PageClient::Json> PageClient::told(const std::string& op) const {
    return impl_->told(op);
}
std::vector<PageClient::Payload> PageClient::samples(const std::string& topic) const {
    return impl_->samples(topic);
}
std::vector<std::uint64_t> PageClient::stamps(const std::string& topic) const {
    return impl_->stamps(topic);
}
std::vector<std::uint64_t> PageClient::times() const {
    return impl_->times();
}
std::map<std::uint32_t, std::string> PageClient::channels() const {
    return impl_->channels();
}
std::vector<std::string> PageClient::heard() const {
    return impl_->heard();
}
void PageClient::vanish() {
    impl_->stop();
}
std::optional<int> PageClient::closed() const {
    return impl_->closed();
}

PageClient::Json PageClient::wait_for(const std::string& op, const Json& fields) const {
    Json found;
    rigs::eventually([&] {
        for (const Json& message : told(op)) {
            bool fits = true;
            for (const auto& [name, value] : fields.items())
                fits = fits && message.contains(name) && message[name] == value;
            if (fits) found = message;
        }
        return !found.is_null();
    });
    return found;
}

} // namespace windlass::test
