#pragma once
// Between the DDS threads that hear and the thread that writes: bounded in bytes, drops counted.

#include "idl/topics.hpp"
#include "recorder/mcap/bytes.hpp"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace windlass::recorder {

using WriterId = std::array<std::uint8_t, 16>;

/// One sample as it was heard.
struct Sample {
    std::size_t topic = 0; ///< row of wire::topics::all
    WriterId writer{};
    std::uint32_t sequence = 0;    ///< the writer's
    std::int64_t log_time = 0;     ///< ns since 1970, when it was put into the queue
    std::int64_t publish_time = 0; ///< ns since 1970, when it was written, on the same clock
    mcap::Buffer payload;

    std::size_t size() const { return sizeof(Sample) + payload.size(); }
};

/// Samples dropped of each topic, by row of wire::topics::all.
using Drops = std::array<std::uint64_t, wire::topics::all.size()>;

/// What the time is.
struct QueueClock {
    std::function<std::int64_t()> wall;   ///< ns since 1970
    std::function<std::int64_t()> steady; ///< ns, and nobody sets it
};
/// That of the machine.
QueueClock machine_clock();

/// Any number of threads push, one takes.
class SampleQueue {
public:
    /// Holds that many bytes, what was taken last included.
    explicit SampleQueue(std::size_t max_bytes, QueueClock clock = machine_clock());

    /// Sets log_time and publish_time, and keeps the order of log_time. written_unix_ns is by the writer's
    /// clock. False, and counted, when there is no room.
    bool push(Sample&& sample, std::int64_t written_unix_ns);

    /// What has come since, waiting for the first at most so long. The samples taken before are done with.
    std::vector<Sample> pop_all(std::chrono::milliseconds wait);

    Drops drops() const;

private:
    const std::size_t max_bytes_;
    const QueueClock clock_;
    mutable std::mutex mutex_;
    std::condition_variable news_;
    std::vector<Sample> samples_;
    std::size_t bytes_ = 0;       // in the queue
    std::size_t bytes_taken_ = 0; // in the hands of who took them last
    Drops drops_{};
    // Recorded times run evenly: wall time of the start, carried on by a clock that nobody sets.
    const std::int64_t steady_start_, wall_start_;
};

} // namespace windlass::recorder
