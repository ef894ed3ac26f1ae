#pragma once
// Waiting for the wire. The limit is far beyond what is needed, so that a slow machine does not fail.

#include <chrono>
#include <thread>

namespace windlass::rigs {

/// Asks every 10 ms until it holds; false after the limit.
template <class Condition>
bool eventually(Condition condition, std::chrono::seconds limit = std::chrono::seconds(60)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

/// A pause between two words of a sender, or before one looks again. Nothing is proved by it: that nothing
/// comes is shown by a marker that comes after it on the same way.
inline void pace(std::chrono::milliseconds pause) {
    std::this_thread::sleep_for(pause);
}

} // namespace windlass::rigs
