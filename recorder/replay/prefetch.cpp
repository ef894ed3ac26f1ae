#include "recorder/replay/prefetch.hpp"

namespace windlass::recorder {

namespace {
// Some seconds of an exercise at speed 10; a single larger message still passes.
constexpr std::size_t kMaxBytes = 16 << 20;
} // namespace

Prefetch::Prefetch(recording::Recording& recording, recording::Query query)
    : cursor_(recording.messages(std::move(query))),
      reader_([this](const std::stop_token& stop) { read(stop); }) {}

Prefetch::~Prefetch() {
    reader_.request_stop();
    change_.notify_all();
}

void Prefetch::read(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const auto message = cursor_.next();
        std::unique_lock lock(mutex_);
        if (!message) {
            at_end_ = true;
            change_.notify_all();
            return;
        }
        change_.wait(lock, stop, [this] { return bytes_ < kMaxBytes; });
        bytes_ += message->payload.size();
        messages_.emplace_back(*message);
        change_.notify_all();
    }
}

const recording::KeptMessage* Prefetch::front() {
    std::unique_lock lock(mutex_);
    change_.wait(lock, [this] { return !messages_.empty() || at_end_; });
    return messages_.empty() ? nullptr : &messages_.front();
}

void Prefetch::pop() {
    const std::lock_guard lock(mutex_);
    bytes_ -= messages_.front().payload.size();
    messages_.pop_front();
    change_.notify_all();
}

} // namespace windlass::recorder
