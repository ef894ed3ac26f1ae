#include "server/dds/publishing_pool.hpp"

#include <algorithm>
#include <cassert>

namespace windlass::server {

PublishingPool::PublishingPool(unsigned threads) {
    assert(threads > 0 && "somebody has to write");
    for (unsigned i = 0; i < threads; ++i)
        threads_.emplace_back([this] { work(); });
}

PublishingPool::~PublishingPool() {
    assert(outboxes_.empty() && "who has an outbox here would go on ringing");
    stop_ = true;
    bell_.release(static_cast<std::ptrdiff_t>(threads_.size()));
    for (std::thread& thread : threads_)
        thread.join();
}

void PublishingPool::add(Outbox& outbox) {
    const std::lock_guard lock(mutex_);
    outboxes_.push_back(&outbox);
}

void PublishingPool::remove(Outbox& outbox) {
    std::unique_lock lock(mutex_);
    std::erase(outboxes_, &outbox);
    down_.wait(lock, [&] { return !outbox.taken_; });
}

void PublishingPool::ring(Outbox& outbox) {
    State state = outbox.state_.load();
    while (state == State::idle || state == State::written) {
        const State next = state == State::idle ? State::waiting : State::written_again;
        if (!outbox.state_.compare_exchange_weak(state, next)) continue;
        if (next == State::waiting) bell_.release();
        return;
    }
}

/// The next one that waits; null: none does.
Outbox* PublishingPool::take() {
    const std::lock_guard lock(mutex_);
    for (std::size_t k = 0; k < outboxes_.size(); ++k) {
        Outbox& outbox = *outboxes_[(next_ + k) % outboxes_.size()];
        State waiting = State::waiting;
        if (!outbox.state_.compare_exchange_strong(waiting, State::written)) continue;
        next_ = (next_ + k + 1) % outboxes_.size();
        outbox.taken_ = true;
        return &outbox;
    }
    return nullptr;
}

/// False when it was rung for again meanwhile.
bool PublishingPool::put_down(Outbox& outbox) {
    {
        const std::lock_guard lock(mutex_);
        State state = State::written;
        if (!outbox.state_.compare_exchange_strong(state, State::idle)) return false;
        outbox.taken_ = false;
    }
    down_.notify_all();
    return true;
}

void PublishingPool::work() {
    for (;;) {
        bell_.acquire();
        if (stop_) return;
        while (Outbox* outbox = take()) {
            do {
                outbox->state_.store(State::written);
                outbox->write_waiting();
            } while (!put_down(*outbox));
        }
    }
}

} // namespace windlass::server
