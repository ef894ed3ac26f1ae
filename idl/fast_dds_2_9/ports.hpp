#pragma once
// Ports at which participants of ours hear samples, in shared memory too.

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace windlass::wire {

/// Numbers that are ours: below those that Linux gives out (32768 on), beyond those of domains 0 to 49.
constexpr int kFirstSamplePort = 20000, kSamplePorts = 12000;

/// File in shared memory of the port of that number, of Fast DDS 2.9.1; its lock's has "_el" behind it.
std::filesystem::path port_memory(int port, const std::filesystem::path& folder = "/dev/shm");

/// Whether the file of that name is the memory of a port of ours.
bool is_sample_port(std::string_view name);

/// Some port of ours that has no memory: nobody listens or listened there that is remembered by anybody.
/// Fast DDS 2.9.1 would have a program started again listen where the one that was killed did, or where
/// another was killed earlier. Those who wrote to the dead one may go on writing into its memory for as long
/// as they live (a listener killed while it takes a sample is never found out; whoever then opens the port
/// for the first time puts new memory in its place), and the new one never hears them.
std::uint16_t fresh_port(const std::filesystem::path& folder = "/dev/shm");

/// The same, at which nobody hears UDP either. 0: there is none.
std::uint16_t fresh_udp_port();

} // namespace windlass::wire
