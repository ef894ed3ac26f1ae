// What goes first under --realtime. Needs the right to SCHED_FIFO, and is left out without it.

#include "server/host/realtime.hpp"
#include "server/host/task_pool.hpp"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <functional>
#include <future>
#include <thread>

namespace windlass::host {
namespace {

struct Scheduling {
    int policy = sched_getscheduler(0), priority = [] {
        sched_param parameters{};
        sched_getparam(0, &parameters);
        return parameters.sched_priority;
    }();
    bool operator==(const Scheduling&) const = default;
};

/// Tells once how the thread is scheduled that does it.
class Asked final : public Task {
public:
    Time due() const override { return {}; }
    bool run() noexcept override {
        told_.set_value({});
        return false;
    }
    Scheduling answer() { return told_.get_future().get(); }

private:
    std::promise<Scheduling> told_;
};

/// Each on a thread of its own, which is in real time and ends with it.
class Realtime : public testing::Test {
protected:
    static void in_realtime(const std::function<void()>& test) {
        std::thread([&] {
            for (const std::string& refused : enter_realtime())
                if (refused.starts_with("SCHED_FIFO")) GTEST_SKIP() << refused;
            test();
        }).join();
    }
};

TEST_F(Realtime, TicksGoBeforeTheRestOfTheirProcess) {
    in_realtime([] {
        const Scheduling others;
        Asked task;
        TaskPool pool(1);
        pool.add(task);
        const Scheduling ticks = task.answer();
        EXPECT_EQ(ticks.policy, SCHED_FIFO);
        EXPECT_GT(ticks.priority, others.priority);
    });
}

TEST_F(Realtime, WhatIsOpenedIsOpenedInOrdinaryTime) {
    in_realtime([] {
        const Scheduling before;
        {
            const SchedulingKept opening;
            leave_realtime();
            EXPECT_EQ(Scheduling().policy, SCHED_OTHER);
            {
                const SchedulingKept while_opening;
                enter_realtime();
                EXPECT_EQ(Scheduling(), before) << "what it starts now goes first";
            }
            EXPECT_EQ(Scheduling().policy, SCHED_OTHER);
        }
        EXPECT_EQ(Scheduling(), before);
    });
}

int niceness() {
    return getpriority(PRIO_PROCESS, 0); // of the calling thread
}

TEST_F(Realtime, TheNetworkHasOrdinaryTimeThatGoesBeforeOtherPrograms) {
    in_realtime([] {
        const Scheduling before;
        const int nice_before = niceness();
        {
            const SchedulingKept joining;
            go_before_other_programs();
            std::thread([] { // as those are that Fast DDS starts
                EXPECT_EQ(Scheduling().policy, SCHED_OTHER);
                EXPECT_LT(niceness(), 0);
            })
                .join();
        }
        EXPECT_EQ(Scheduling(), before);
        EXPECT_EQ(niceness(), nice_before);
    });
}

TEST(OrdinaryTime, HasNoTicksThatGoBeforeOthers) {
    Asked task;
    TaskPool pool(1);
    pool.add(task);
    EXPECT_EQ(task.answer(), Scheduling());
}

} // namespace
} // namespace windlass::host
