#pragma once
// Waiting for the wire. The limit is far beyond what is needed, so that a slow machine does not fail.

#include <chrono>
#include <thread>

namespace windlass::test {

/// Asks every 10 ms until it holds; false after the limit.
template <class Condition>
bool eventually(Condition condition, std::chrono::seconds limit = std::chrono::seconds(20)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

} // namespace windlass::test
