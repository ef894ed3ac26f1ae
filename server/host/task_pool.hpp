#pragma once
// A few threads that work for many: whoever is due is taken up by the next free thread.

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace windlass::host {

/// Work that comes back again and again.
class Task {
public:
    using Time = std::chrono::steady_clock::time_point;
    virtual ~Task() = default;

    /// When it is to be done next. Read while no thread has it.
    virtual Time due() const = 0;
    /// Does one piece of it; false: that was the last. Must not throw.
    virtual bool run() noexcept = 0;
    /// It is in no time of its own, and has what the others leave. Read while no thread has it.
    virtual bool gives_way() const { return false; }
};

/// The threads. A task is with one thread at a time, and sees all that it did before. What is due longest
/// goes first, so that none waits for ever behind one that is always due. Who gives way goes after all others
/// that are due, unless he has waited for kPatience, and leaves one thread free for them. To wake a thread
/// costs as much as a tick of an exercise: so what falls due within one grain of time is done at its end,
/// together.
class TaskPool {
public:
    using Grain = std::ratio<1, 2000>; // s
    static constexpr std::chrono::duration<std::int64_t, Grain> kGrain{1};
    /// Then he goes before any other: orders that wait for him are heard.
    static constexpr std::chrono::milliseconds kPatience{100};

    /// pause: called by each thread, with no task in its hand, before it waits for the next one, and between
    /// two of them when it has worked for a grain. Must not throw.
    explicit TaskPool(
        unsigned threads, std::function<void()> pause = [] {});
    /// Ends the threads, each after the piece of work that it has.
    ~TaskPool();
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    /// The task must be removed before it goes away, unless the pool goes first.
    void add(Task& task);
    /// Returns when no thread has the task, and none will take it.
    void remove(const Task& task);

private:
    struct Waiting {
        Task::Time due;
        Task* task;
    };
    static bool later(const Waiting& a, const Waiting& b) { return a.due > b.due; }

    using Queue = std::vector<Waiting>; // a heap, soonest first

    void work();
    void put(Task& task);
    Queue* next_queue(Task::Time now);
    bool has_room_for_who_gives_way() const;
    void call_watch();
    void keep_watch(std::unique_lock<std::mutex>& lock);
    void do_first(Queue& queue, std::unique_lock<std::mutex>& lock);

    const std::function<void()> pause_;
    std::mutex mutex_;
    std::condition_variable watch_; // the one thread that waits for the next task to fall due
    std::condition_variable idle_;  // the other threads with nothing to do
    std::condition_variable done_;  // a task was put down
    Queue queue_, giving_way_;
    std::vector<Task*> running_, running_giving_way_;
    std::vector<const Task*> leaving_; // running, and not to be queued again
    bool watched_ = false;
    Task::Time watched_until_; // when the watch will look again
    bool stop_ = false;
    std::vector<std::thread> threads_; // last: they use all of the above
};

} // namespace windlass::host
