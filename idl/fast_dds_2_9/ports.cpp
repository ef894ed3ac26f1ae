#include "idl/fast_dds_2_9/ports.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <charconv>
#include <random>
#include <string>

namespace windlass::wire {

namespace {
constexpr std::string_view kName = "fastrtps_port";

bool nobody_hears_udp_at(std::uint16_t number) {
    const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    sockaddr_in port{};
    port.sin_family = AF_INET;
    port.sin_addr.s_addr = htonl(INADDR_ANY);
    port.sin_port = htons(number);
    const bool free = bind(probe, reinterpret_cast<const sockaddr*>(&port), sizeof port) == 0;
    close(probe);
    return free;
}
} // namespace

std::filesystem::path port_memory(int port, const std::filesystem::path& folder) {
    return folder / (std::string(kName) + std::to_string(port));
}

bool is_sample_port(std::string_view name) {
    if (!name.starts_with(kName)) return false;
    int port = 0;
    const char* end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + kName.size(), end, port);
    return read.ec == std::errc() && read.ptr == end && port >= kFirstSamplePort &&
           port < kFirstSamplePort + kSamplePorts;
}

std::uint16_t fresh_port(const std::filesystem::path& folder) {
    // Anywhere in the range: others may remember a port whose memory has been tidied away.
    std::random_device chance;
    const int start = std::uniform_int_distribution(0, kSamplePorts - 1)(chance);
    const auto port = [start](int on) { return kFirstSamplePort + (start + on) % kSamplePorts; };
    int on = 0;
    while (on < kSamplePorts && std::filesystem::exists(port_memory(port(on), folder)))
        ++on;
    return static_cast<std::uint16_t>(port(on));
}

std::uint16_t fresh_udp_port() {
    constexpr int kTries = 100;
    for (int tries = 0; tries < kTries; ++tries)
        if (const std::uint16_t port = fresh_port(); nobody_hears_udp_at(port)) return port;
    return 0;
}

} // namespace windlass::wire
