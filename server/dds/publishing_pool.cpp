#include "server/dds/publishing_pool.hpp"

#include "common/thread_name.hpp"

#include <algorithm>
#include <cassert>

namespace windlass::dds {

PublishingPool::PublishingPool(unsigned threads) {
    assert(threads > 0 && "somebody has to write");
    const ThreadName name("publish");
    for (unsigned i = 0; i < threads; ++i)
        threads_.emplace_back([this] { work(); });
}

PublishingPool::~PublishingPool() {
    assert(outboxes_.empty() && "who has an outbox here would go on ringing");
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    bell_.notify_all();
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
    if (outbox.state_.exchange(State::idle) == State::waiting) --waiting_;
}

void PublishingPool::ring(Outbox& outbox) {
    State state = outbox.state_.load();
    while (state == State::idle || state == State::written) {
        const State next = state == State::idle ? State::waiting : State::written_again;
        if (next == State::waiting) ++waiting_; // first, so that it is never fewer than there are
        if (outbox.state_.compare_exchange_weak(state, next)) return;
        if (next == State::waiting) --waiting_;
    }
}

void PublishingPool::call() {
    if (waiting_ == 0) return;
    const std::lock_guard lock(mutex_);
    if (asleep_ > 0) bell_.notify_one();
}

/// The next one that waits; null: none does. The mutex is held.
Outbox* PublishingPool::next() {
    for (std::size_t k = 0; waiting_ > 0 && k < outboxes_.size(); ++k) {
        Outbox& outbox = *outboxes_[(next_ + k) % outboxes_.size()];
        if (outbox.state_ != State::waiting) continue; // none but who has the mutex changes that
        outbox.state_ = State::written;
        --waiting_;
        next_ = (next_ + k + 1) % outboxes_.size();
        outbox.taken_ = true;
        return &outbox;
    }
    return nullptr;
}

/// False when it was rung for again meanwhile.
bool PublishingPool::put_down(Outbox& outbox) {
    const std::lock_guard lock(mutex_);
    State state = State::written;
    if (!outbox.state_.compare_exchange_strong(state, State::idle)) return false;
    outbox.taken_ = false;
    down_.notify_all();
    return true;
}

void PublishingPool::work() {
    std::unique_lock lock(mutex_);
    while (!stop_) {
        Outbox* const outbox = next();
        if (outbox == nullptr) {
            ++asleep_;
            bell_.wait(lock, [&] { return stop_ || waiting_ > 0; });
            --asleep_;
            continue;
        }
        lock.unlock();
        do {
            outbox->state_.store(State::written);
            outbox->write_waiting();
        } while (!put_down(*outbox));
        lock.lock();
    }
}

} // namespace windlass::dds
