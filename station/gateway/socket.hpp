#pragma once
// One WebSocket with its session.

#include "station/gateway/house.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <bit>
#include <cstring>

namespace windlass::gateway {

using Upgrade = http::request<http::string_body>;

/// Stream: a TCP stream of Beast, or TLS over one. Lives as long as something is under way on it.
template <class Stream>
class Socket final : public Transport, public std::enable_shared_from_this<Socket<Stream>> {
public:
    /// verdict: that opens a session; address: whence it comes.
    Socket(Stream stream, House& house, Verdict verdict, std::string address)
        : ws_{std::move(stream)},
          house_{house},
          verdict_{std::move(verdict)},
          address_{std::move(address)},
          last_resort_{house.io} {
        house_.sockets.emplace(this, nullptr);
    }
    ~Socket() override {
        if (session_) session_->close();
        house_.sockets.erase(this);
    }

    void run(Upgrade request) {
        request_ = std::move(request);
        beast::get_lowest_layer(ws_).expires_never(); // the WebSocket has limits of its own
        ws_.set_option(websocket::stream_base::timeout{kHandshake, kIdle, true});
        ws_.set_option(websocket::stream_base::decorator([this](websocket::response_type& response) {
            set_headers(response);
            response.set(http::field::sec_websocket_protocol, verdict_.subprotocol);
        }));
        ws_.read_message_max(house_.limits.message);
        ws_.async_accept(request_,
                         [self = this->shared_from_this()](error_code error) { self->accepted(error); });
    }

    void wake() override {
        if (woken_.exchange(true)) return;
        if (auto self = this->weak_from_this().lock())
            net::post(house_.io, [self] {
                self->woken_ = false;
                self->write();
            });
    }

    void close(int code, const std::string& reason) override {
        if (auto self = this->weak_from_this().lock())
            net::post(house_.io, [self, code, reason] { self->end(code, reason); });
    }

private:
    void accepted(error_code error) {
        if (error) return;
        try {
            session_ = verdict_.open(*this);
        } catch (const std::exception& problem) {
            house_.host.log(fmt::format("{}: {}", address_, problem.what()));
            return end(1011, "the exercise cannot be joined");
        }
        house_.sockets[this] = session_.get();
        session_->open();
        read();
    }

    void read() {
        ws_.async_read(buffer_, [self = this->shared_from_this()](error_code error, std::size_t) {
            if (error) return self->gone(error);
            self->pass_on_message();
            self->read();
        });
    }

    void pass_on_message() {
        const auto bytes = buffer_.data();
        if (ws_.got_text())
            session_->take_text({static_cast<const char*>(bytes.data()), bytes.size()}, Clock::now());
        else
            session_->take_binary();
        buffer_.consume(buffer_.size());
    }

    void write() {
        if (writing_ || ending_ || !session_) return;
        auto next = session_->next();
        if (!next) return;
        writing_ = true;
        sent_ = std::move(*next);
        std::array<net::const_buffer, 2> parts{net::buffer(sent_.text), {}};
        if (sent_.frame)
            parts = {sample_header(), net::buffer(sent_.frame->payload)};
        else if (sent_.is_time)
            parts = {time_message(), {}};
        ws_.binary(sent_.frame || sent_.is_time);
        ws_.async_write(parts, [self = this->shared_from_this()](error_code error, std::size_t) {
            self->writing_ = false;
            if (error) return self->gone(error);
            self->write();
        });
    }

    /// Message data of the Foxglove protocol: 0x01, subscription, ns, little-endian; the sample follows.
    net::const_buffer sample_header() {
        header_[0] = 1;
        std::memcpy(&header_[1], &sent_.subscription, 4);
        std::memcpy(&header_[5], &sent_.ns, 8);
        return net::buffer(header_, 13);
    }

    /// Time of the Foxglove protocol: 0x02, ns, little-endian.
    net::const_buffer time_message() {
        header_[0] = 2;
        std::memcpy(&header_[1], &sent_.ns, 8);
        return net::buffer(header_, 9);
    }

    void end(int code, const std::string& reason) {
        if (std::exchange(ending_, true)) return;
        house_.host.log(fmt::format("{}: session ended: {}", address_, reason));
        if (session_) session_->close();
        last_resort_.expires_after(kHandshake); // a peer that does not read lets no close through either
        last_resort_.async_wait([self = this->shared_from_this()](error_code error) {
            if (!error) beast::get_lowest_layer(self->ws_).close();
        });
        ws_.async_close({static_cast<websocket::close_code>(code), reason},
                        [self = this->shared_from_this()](error_code) { self->last_resort_.cancel(); });
    }

    void gone(error_code error) {
        if (error == websocket::error::message_too_big)
            house_.host.log(
                fmt::format("{}: session ended: a message above {} bytes", address_, house_.limits.message));
        if (session_) session_->close();
    }

    static_assert(std::endian::native == std::endian::little);

    websocket::stream<Stream> ws_;
    House& house_;
    const Verdict verdict_;
    const std::string address_;
    net::steady_timer last_resort_;
    Upgrade request_;
    std::shared_ptr<FoxgloveSession> session_;
    beast::flat_buffer buffer_;
    Outbox::Item sent_;
    std::array<std::uint8_t, 13> header_{};
    std::atomic<bool> woken_ = false;
    bool writing_ = false, ending_ = false;
};

} // namespace windlass::gateway
