#pragma once
// The clock of every cost in the lab.

#include <ctime>

namespace windlass::lab {

/// Seconds that this thread has had a processor for: wall time on an idle core, since every method is one
/// thread, and the same on a busy one.
inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

} // namespace windlass::lab
