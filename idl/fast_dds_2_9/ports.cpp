#include "idl/fast_dds_2_9/ports.hpp"

#include <charconv>
#include <random>
#include <string>

namespace windlass::wire {

namespace {
constexpr std::string_view kName = "fastrtps_port";
}

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

} // namespace windlass::wire
