// Who writes what waits.

#include "server/dds/publishing_pool.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace windlass::dds {
namespace {

/// Counts what was rung for and written, and whether two threads ever wrote at once.
class Counting final : public Outbox {
public:
    std::atomic<int> waiting{0}, written{0};
    std::atomic<bool> crowded{false};

private:
    void write_waiting() override {
        if (busy_.exchange(true)) crowded = true;
        written += waiting.exchange(0);
        busy_ = false;
    }
    std::atomic<bool> busy_{false};
};

TEST(PublishingPool, WritesAllThatWasRungForAndNothingByTwoThreadsAtOnce) {
    constexpr int kOutboxes = 100, kTimes = 2000;
    PublishingPool pool(3);
    std::deque<Counting> outboxes(kOutboxes);
    for (Counting& outbox : outboxes)
        pool.add(outbox);
    std::thread other; // two who ring, each for its half
    const auto ring = [&](int from) {
        for (int k = 0; k < kTimes; ++k)
            for (int i = from; i < kOutboxes; i += 2) {
                ++outboxes[static_cast<std::size_t>(i)].waiting;
                pool.ring(outboxes[static_cast<std::size_t>(i)]);
                if (k % 10 == 0) pool.call();
            }
        pool.call();
    };
    other = std::thread([&] { ring(1); });
    ring(0);
    other.join();
    for (Counting& outbox : outboxes) {
        while (outbox.written < kTimes) // else the test hangs: what was rung for is never written
            std::this_thread::yield();
        EXPECT_EQ(outbox.written, kTimes);
        EXPECT_FALSE(outbox.crowded);
        pool.remove(outbox);
    }
}

TEST(PublishingPool, HasLetGoOfWhatIsRemoved) {
    PublishingPool pool(2);
    for (int k = 0; k < 1000; ++k) {
        Counting outbox;
        pool.add(outbox);
        ++outbox.waiting;
        pool.ring(outbox);
        if (k % 2 == 0) pool.call();
        pool.remove(outbox); // it ends here, written or not
    }
}

/// Holds its thread until it is let go.
class Stuck final : public Outbox {
public:
    std::binary_semaphore entered{0}, leave{0};

private:
    void write_waiting() override {
        entered.release();
        leave.acquire();
    }
};

TEST(PublishingPool, OneThatWaitsForItsReadersHoldsUpNoOther) {
    PublishingPool pool(2);
    Stuck stuck;
    Counting outbox;
    pool.add(stuck);
    pool.add(outbox);
    pool.ring(stuck);
    pool.call();
    stuck.entered.acquire();
    ++outbox.waiting;
    pool.ring(outbox);
    pool.call();
    while (outbox.written == 0)
        std::this_thread::yield();
    stuck.leave.release();
    pool.remove(stuck);
    pool.remove(outbox);
}

} // namespace
} // namespace windlass::dds
