#pragma once
// The threads that write what exercises publish: a few for many, since each write is short and most of what a
// thread of its own would do is to be woken.

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace windlass::dds {

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

/// The threads. To wake one costs as much as a tick of an exercise: so who has something to write says so,
/// and one call, when those that were due have all had their ticks, wakes a thread for all of them.
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
    /// There is something to write: it is, at the next call at the latest. From any thread; neither waits nor
    /// allocates.
    void ring(Outbox& outbox);
    /// Sees to it that what was rung for is written. From any thread; waits for no write.
    void call();

private:
    using State = Outbox::State;
    void work();
    Outbox* next();
    bool put_down(Outbox& outbox);

    std::mutex mutex_;             // of the list and of sleep; never held while something is written
    std::condition_variable bell_; // something waits, or it is over
    std::condition_variable down_; // one was put down
    std::vector<Outbox*> outboxes_;
    std::size_t next_ = 0;                // where to look first: each has its turn
    unsigned asleep_ = 0;                 // threads
    bool stop_ = false;                   // guarded by mutex_, as all above
    std::atomic<std::size_t> waiting_{0}; // outboxes in that state
    std::vector<std::thread> threads_;    // last: they use all of the above
};

} // namespace windlass::dds
