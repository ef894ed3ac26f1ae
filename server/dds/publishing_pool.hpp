#pragma once
// The threads that write what exercises publish: a few for many, since each write is short and most of what a
// thread of its own would do is to be woken.

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <semaphore>
#include <thread>
#include <vector>

namespace windlass::server {

/// Something that has samples to write now and then.
class Outbox {
public:
    virtual ~Outbox() = default;
    /// Writes all that waits. On a thread of the pool, on one at a time.
    virtual void write_waiting() = 0;

private:
    friend class PublishingPool;
    enum class State { idle, waiting, written, written_again }; // the last two: a thread has it
    std::atomic<State> state_{State::idle};
    bool taken_ = false; // guarded by the pool's mutex
};

/// The threads.
class PublishingPool {
public:
    explicit PublishingPool(unsigned threads);
    /// No outbox may be left.
    ~PublishingPool();
    PublishingPool(const PublishingPool&) = delete;
    PublishingPool& operator=(const PublishingPool&) = delete;

    void add(Outbox& outbox);
    /// Returns when no thread has it, and none will take it.
    void remove(Outbox& outbox);
    /// There is something to write. From any thread; neither waits nor allocates.
    void ring(Outbox& outbox);

private:
    using State = Outbox::State;
    void work();
    Outbox* take();
    bool put_down(Outbox& outbox);

    std::mutex mutex_;             // of the list; never held while something is written
    std::condition_variable down_; // one was put down
    std::vector<Outbox*> outboxes_;
    std::size_t next_ = 0; // where to look first: each has its turn
    std::counting_semaphore<> bell_{0};
    std::atomic<bool> stop_{false};
    std::vector<std::thread> threads_; // last: they use all of the above
};

} // namespace windlass::server
