#pragma once
// One server as several processes: a worker that dies, hangs or grows takes no other's exercises along, and
// is started again.

#include "server/workers/pulse.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

namespace windlass::workers {

/// What a worker may do before it is killed and started again.
struct Limits {
    std::chrono::milliseconds starting{300'000}; ///< between two signs of life while it opens exercises
    std::chrono::milliseconds silence{10'000};   ///< while it serves
    std::chrono::milliseconds ending{60'000};    ///< from when it was told to end until it has
    std::uint64_t memory = 0;                    ///< bytes of it in the machine's memory; 0: any
    /// It comes back at once, but for one that ends again within `settled`: that one waits from `first_pause`
    /// on, twice as long each time; at most `last_pause`, and `served_pause` where it came to serve.
    std::chrono::milliseconds settled{10'000}, first_pause{500}, served_pause{1'000}, last_pause{30'000};
};

/// The whole work of worker 1, 2, ..., in its own process. Returns its exit code: 0 or 1, it has come to its
/// end; anything else, it could not begin or go on. A signal that is to end it is its own to catch.
using Work = std::function<int(unsigned number, Pulse pulse)>;

/// Keeps `count` workers at work until each has come to its end, or stop() gives a signal's number, which is
/// then handed on. One that could not begin the first time ends them all: it would not the next time. Returns
/// 0, or the first exit code that is not. Forks: call it while the process has one thread. A supervisor that
/// is killed takes its workers along. anew: true, once, when each worker is to end and to be started again,
/// by SIGUSR1 and one after the other: the next when all serve.
int supervise(
    unsigned count, const Limits& limits, const Work& work, const std::function<int()>& stop,
    const std::function<bool()>& anew = [] { return false; });

} // namespace windlass::workers
