#pragma once
// A DDS domain that no other test on this machine has at the same time.

#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <thread>
#include <utility>

namespace windlass::rigs {

/// A domain held, by a name that the kernel gives to one socket at a time. The programs that this one starts
/// inherit the socket, so that the domain is free again when the last of them has ended, killed or not: a
/// server that outlives its test is not heard in the next one. Nothing stays behind on the disk.
class HeldDomain {
public:
    /// Nothing when somebody else has it.
    static std::optional<HeldDomain> hold(int number) {
        HeldDomain held(number, socket(AF_UNIX, SOCK_STREAM, 0)); // inherited, thus no SOCK_CLOEXEC
        sockaddr_un name{};
        name.sun_family = AF_UNIX;
        // The first character stays 0: a name, not a file; one for all users of the machine.
        const int length =
            std::snprintf(name.sun_path + 1, sizeof name.sun_path - 1, "windlass-test-domain-%d", number);
        const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
        if (bind(held.socket_, reinterpret_cast<const sockaddr*>(&name), size) != 0) return std::nullopt;
        return held;
    }
    HeldDomain(HeldDomain&& other) noexcept
        : number_(other.number_), socket_(std::exchange(other.socket_, -1)) {}
    HeldDomain& operator=(HeldDomain&&) = delete;
    ~HeldDomain() {
        if (socket_ >= 0) close(socket_);
    }
    int number() const { return number_; }

private:
    HeldDomain(int number, int socket) : number_(number), socket_(socket) {}

    int number_;
    int socket_;
};

/// Nobody listens at the domain's first ports for discovery (DDSI-RTPS 9.6.1.1): no server started by hand.
inline bool is_quiet(int domain) {
    bool quiet = true;
    for (int participant = 0; quiet && participant < 60; ++participant) {
        const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
        sockaddr_in port{};
        port.sin_family = AF_INET;
        port.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        port.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * domain + 10 + 2 * participant));
        quiet = bind(probe, reinterpret_cast<const sockaddr*>(&port), sizeof port) == 0;
        close(probe);
    }
    return quiet;
}

/// A domain from 1 to 49, waited for while all are taken. Of those the ports lie below the ones at which our
/// secure programs hear samples (20000 on) and those that Linux gives out (32768 on). Begun at another one
/// each time, so that a test seldom has the domain of the one before it.
inline HeldDomain hold_any_domain() {
    constexpr int kDomains = 49;
    for (int next = getpid();; ++next) {
        auto held = HeldDomain::hold(1 + next % kDomains);
        if (held && is_quiet(held->number())) return std::move(*held);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// The domain of this process.
inline int own_domain() {
    static const HeldDomain held = hold_any_domain();
    return held.number();
}

} // namespace windlass::rigs
