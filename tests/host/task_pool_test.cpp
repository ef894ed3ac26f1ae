// The task pool: many tasks on few threads.

#include "server/host/task_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <set>

namespace windlass::host {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// Counts its runs, in plain memory that only the pool's order protects, until it has had enough.
class Counter : public Task {
public:
    explicit Counter(Clock::duration every, int enough = 1 << 30, Time first = Clock::now())
        : every_(every), enough_(enough), due_(first) {}

    Time due() const override { return due_; }
    bool run() noexcept override {
        if (busy_.exchange(true)) twice_at_once_ = true;
        ++runs_;
        seen_by_.insert(std::this_thread::get_id());
        if (runs_ == enough_) done_ = true;
        due_ = every_ > 0s ? due_ + every_ : Clock::now();
        seen_ = runs_;
        busy_ = false;
        return runs_ < enough_;
    }

    int seen() const { return seen_; }
    bool done() const { return done_; }
    bool twice_at_once() const { return twice_at_once_; }
    /// To be asked when no thread has it.
    int runs() const { return runs_; }
    std::size_t threads() const { return seen_by_.size(); }

private:
    const Clock::duration every_;
    const int enough_;
    Time due_;
    int runs_ = 0;
    std::set<std::thread::id> seen_by_;
    std::atomic<bool> busy_{false}, done_{false}, twice_at_once_{false};
    std::atomic<int> seen_{0};
};

template <class Condition>
bool soon(Condition condition) {
    for (const auto end = Clock::now() + 20s; !condition(); std::this_thread::sleep_for(1ms))
        if (Clock::now() > end) return false;
    return true;
}

TEST(TaskPool, EachTaskIsRunUntilItHasEnoughAndNoOftener) {
    std::deque<Counter> tasks;
    for (int i = 0; i < 20; ++i)
        tasks.emplace_back(i % 2 == 0 ? 0ms : 1ms, 50 + i);
    {
        TaskPool pool(3);
        for (auto& task : tasks)
            pool.add(task);
        for (auto& task : tasks)
            EXPECT_TRUE(soon([&] { return task.done(); }));
    }
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(tasks[static_cast<std::size_t>(i)].runs(), 50 + i);
        EXPECT_FALSE(tasks[static_cast<std::size_t>(i)].twice_at_once());
    }
}

TEST(TaskPool, TaskThatIsAlwaysDueDoesNotStarveOneThatIsDueNowAndThen) {
    Counter always(0ms), now_and_then(5ms, 20);
    TaskPool pool(1);
    pool.add(always);
    pool.add(now_and_then);
    EXPECT_TRUE(soon([&] { return now_and_then.done(); }));
    EXPECT_GT(always.seen(), 20);
    pool.remove(always);
}

TEST(TaskPool, NoTaskIsRunBeforeItIsDue) {
    Counter task(10ms, 11);
    const auto begin = Clock::now();
    TaskPool pool(2);
    pool.add(task);
    EXPECT_TRUE(soon([&] { return task.done(); }));
    EXPECT_GE(Clock::now() - begin, 100ms); // ten periods lie between eleven runs
}

TEST(TaskPool, TaskDueSoonerThanTheOneWaitedForIsNotLate) {
    Counter far(1h), near(1ms, 10);
    TaskPool pool(2);
    pool.add(far);
    EXPECT_TRUE(soon([&] { return far.seen() == 1; })); // both threads wait for it now, an hour
    pool.add(near);
    EXPECT_TRUE(soon([&] { return near.done(); }));
}

/// Else what a task has to publish would lie until somebody else has something to do.
TEST(TaskPool, PausesAfterEveryTaskBeforeItWaits) {
    Counter task(1h);
    std::atomic<int> seen{-1};
    TaskPool pool(1, [&] { seen = task.seen(); });
    pool.add(task); // due now, and then in an hour
    EXPECT_TRUE(soon([&] { return seen == 1; }));
}

TEST(TaskPool, PausesThoughSomebodyIsAlwaysDue) {
    Counter always(0ms);
    std::atomic<int> pauses{0};
    TaskPool pool(1, [&] { ++pauses; });
    pool.add(always);
    EXPECT_TRUE(soon([&] { return pauses > 10; }));
    EXPECT_GT(always.seen(), 10);
    pool.remove(always);
}

/// 100 tasks fall due one after the other in half a millisecond; were each woken for, there would be as many
/// pauses.
TEST(TaskPool, WhatFallsDueInOneGrainIsDoneTogether) {
    const auto soon_enough = std::chrono::ceil<Clock::duration>(Clock::now().time_since_epoch() + 200ms);
    const Clock::time_point begin(soon_enough - soon_enough % TaskPool::kGrain + 1us);
    std::deque<Counter> tasks;
    std::atomic<int> pauses{0};
    {
        TaskPool pool(1, [&] { ++pauses; });
        for (int i = 0; i < 100; ++i)
            pool.add(tasks.emplace_back(1h, 1, begin + 4us * i));
        for (Counter& task : tasks)
            EXPECT_TRUE(soon([&] { return task.done(); }));
    }
    EXPECT_LT(pauses, 50); // one or two; more when the thread is held up between them
}

/// Is always due, and takes as long as the flag says.
class Hurried : public Counter {
public:
    explicit Hurried(const std::atomic<bool>& enough) : Counter(0ms), enough_(enough) {}
    bool gives_way() const override { return true; }
    bool run() noexcept override {
        while (!enough_)
            std::this_thread::sleep_for(1ms);
        return Counter::run();
    }

private:
    const std::atomic<bool>& enough_;
};

TEST(TaskPool, WhoGivesWayLeavesAThreadToTheOthers) {
    std::atomic<bool> enough{false};
    Hurried one(enough), other(enough);
    Counter calm(1ms, 200);
    TaskPool pool(2);
    pool.add(calm);
    EXPECT_TRUE(soon([&] { return calm.seen() > 0; }));
    pool.add(one);
    pool.add(other);
    EXPECT_TRUE(soon([&] { return calm.done(); }));
    enough = true;
    EXPECT_TRUE(soon([&] { return one.seen() > 0 && other.seen() > 0; }));
    pool.remove(one);
    pool.remove(other);
}

TEST(TaskPool, WhoGivesWayGoesLastButGoes) {
    const std::atomic<bool> at_once{true};
    Counter always(0ms); // leaves nothing
    Hurried hurried(at_once);
    TaskPool pool(1);
    pool.add(always);
    pool.add(hurried);
    EXPECT_TRUE(soon([&] { return hurried.seen() >= 3; }));
    EXPECT_GT(always.seen(), 100 * hurried.seen()); // some thousands in each tenth of a second
    pool.remove(hurried);
    pool.remove(always);
}

TEST(TaskPool, RemovedTaskIsInNoHandAndNeverRunAgain) {
    Counter stays(0ms);
    TaskPool pool(2);
    pool.add(stays);
    for (int i = 0; i < 50; ++i) {
        Counter goes(0ms);
        pool.add(goes);
        ASSERT_TRUE(soon([&] { return goes.seen() > 0; }));
        pool.remove(goes);
        const int runs = goes.runs();
        std::this_thread::sleep_for(1ms);
        EXPECT_EQ(goes.runs(), runs);
    }
    pool.remove(stays);
}

} // namespace
} // namespace windlass::host
