#pragma once
// Shared memory that killed programs leave behind.

#include <chrono>
#include <filesystem>

namespace windlass::wire {

/// Removes the Fast DDS segments in the folder (fastrtps_<16 hex digits>, 4 MB each) whose program is gone.
/// Fast DDS keeps the file fastrtps_..._el under an exclusive flock() for as long as the program lives; the
/// kernel lets it go with the program. So does `fastdds shm clean` tell them; beyond that, only segments of
/// our own user are touched, and none younger than `age`: between making the file and locking it a program
/// has nothing to show for it. Who has such a segment mapped keeps it. Ports, which are small and which Fast
/// DDS takes over by itself, are left alone. Returns the number of segments removed; what cannot be looked
/// at stays.
int remove_abandoned_segments(const std::filesystem::path& folder = "/dev/shm",
                              std::chrono::seconds age = std::chrono::seconds(60));

} // namespace windlass::wire
