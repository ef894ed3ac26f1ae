#pragma once

#include <string>
#include <vector>

namespace windlass::host {

/// Locks the memory of the process and puts the calling thread, and every thread it starts from now on,
/// under SCHED_FIFO. Returns what was refused, and what to do about it; the program runs without it.
std::vector<std::string> enter_realtime();

} // namespace windlass::host
