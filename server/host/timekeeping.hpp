#pragma once
// How late ticks begin.

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>

namespace windlass::host {

/// Counts, over all exercises of a host, by how much each beat began after it was due. Any thread counts; one
/// thread asks.
class Timekeeping {
public:
    void began(std::chrono::nanoseconds late);

    struct Figures {
        std::uint64_t beats = 0;
        double half = 0, most = 0, all = 0; ///< s, within which half of them began, 99 %, and every one
    };
    /// Of the beats since it was asked last. Half and 99 % are rounded up to 0.05 ms; from 20 ms on, the
    /// latest stands for them.
    Figures collect();

private:
    static constexpr std::chrono::nanoseconds kStep{50'000};
    static constexpr std::size_t kSteps = 400;
    std::array<std::atomic<std::uint64_t>, kSteps + 1> count_{}; // the last: of all that is later
    std::atomic<std::int64_t> latest_{0};                        // ns
};

} // namespace windlass::host
