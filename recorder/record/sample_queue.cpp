#include "recorder/record/sample_queue.hpp"

#include <utility>

namespace windlass::recorder {

namespace {

/// ns of that clock.
template <class Clock>
std::int64_t ns_of() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch()).count();
}

} // namespace

QueueClock machine_clock() {
    return {.wall = ns_of<std::chrono::system_clock>, .steady = ns_of<std::chrono::steady_clock>};
}

SampleQueue::SampleQueue(std::size_t max_bytes, QueueClock clock)
    : max_bytes_(max_bytes),
      clock_(std::move(clock)),
      steady_start_(clock_.steady()),
      wall_start_(clock_.wall()) {}

bool SampleQueue::push(Sample&& sample, std::int64_t written_unix_ns) {
    const std::lock_guard lock(mutex_);
    if (bytes_ + bytes_taken_ + sample.size() > max_bytes_) {
        ++drops_[sample.topic];
        return false;
    }
    sample.log_time = wall_start_ + clock_.steady() - steady_start_;
    // How long the sample was under way is known by the wall clock now, and kept.
    sample.publish_time = sample.log_time - (clock_.wall() - written_unix_ns);
    bytes_ += sample.size();
    samples_.push_back(std::move(sample));
    news_.notify_one();
    return true;
}

std::vector<Sample> SampleQueue::pop_all(std::chrono::milliseconds wait) {
    std::unique_lock lock(mutex_);
    bytes_taken_ = 0;
    news_.wait_for(lock, wait, [this] { return !samples_.empty(); });
    bytes_taken_ = std::exchange(bytes_, 0);
    return std::exchange(samples_, {});
}

Drops SampleQueue::drops() const {
    const std::lock_guard lock(mutex_);
    return drops_;
}

} // namespace windlass::recorder
