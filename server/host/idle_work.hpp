#pragma once
// What is done beside an exercise with the time that all others leave, a little at a turn.

#include <chrono>

#include <time.h>

namespace windlass::host {

class IdleWork {
public:
    /// Until the next one has its turn, and somebody is heard who wants an end.
    static constexpr std::chrono::milliseconds kTurn{1};

    virtual ~IdleWork() = default;
    /// Goes on a little. False: there is nothing to do.
    virtual bool go_on() = 0;
    /// Nobody wants anything of it any more. From any thread.
    virtual bool closed() const = 0;
};

/// s of processor time that this thread has had.
inline double thread_time() {
    timespec spent{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
    return static_cast<double>(spent.tv_sec) + 1e-9 * static_cast<double>(spent.tv_nsec);
}

} // namespace windlass::host
