#pragma once
// Shared memory that killed programs leave behind.

#include <chrono>
#include <filesystem>

namespace windlass::wire {

/// Removes what killed programs left in the folder: their segments (fastrtps_<16 hex digits>, 4 MB each), and
/// the ports at which they heard samples (fastrtps_port<number>, 52 kB each; the numbers of ports.hpp only)
/// that nobody has mapped any more. Fast DDS keeps the file <segment>_el under an exclusive flock() for as
/// long as the program lives; the kernel lets it go with the program. So does `fastdds shm clean` tell
/// segments; beyond that, only files of our own user are touched, and none younger than `age`: between making
/// the file and locking it a program has nothing to show for it. Who has a segment mapped keeps it. Returns
/// the number of segments and ports removed; what cannot be looked at stays.
int remove_abandoned_memory(const std::filesystem::path& folder = "/dev/shm",
                            std::chrono::seconds age = std::chrono::seconds(60));

} // namespace windlass::wire
