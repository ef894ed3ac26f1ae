// What goes first under --realtime. Needs the right to SCHED_FIFO, and is left out without it.

#include "server/host/realtime.hpp"
#include "server/host/task_pool.hpp"

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <sys/resource.h>

#include <cstdint>
#include <fstream>
#include <functional>
#include <future>
#include <sstream>
#include <string>
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

/// kB of that kind (a name in /proc/self/smaps) in the mapping that begins there.
int kilobytes(const void* begin, const std::string& kind) {
    std::ostringstream address;
    address << std::hex << reinterpret_cast<std::uintptr_t>(begin) << '-';
    std::ifstream maps("/proc/self/smaps");
    bool found = false;
    for (std::string line; std::getline(maps, line);) {
        found = found || line.starts_with(address.str());
        if (found && line.starts_with(kind + ':')) return std::stoi(line.substr(kind.size() + 1));
    }
    return -1;
}

TEST_F(Realtime, MemoryIsThereFromItsFirstUseOnAndStays) {
    in_realtime([] {
        for (const std::string& refused : enter_realtime())
            if (refused.starts_with("memory")) GTEST_SKIP() << refused;
        constexpr std::size_t kRoom = 16UL << 20;
        // Shared, so that it is a mapping of its own.
        void* room = mmap(nullptr, kRoom, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        ASSERT_NE(room, MAP_FAILED);
        EXPECT_EQ(kilobytes(room, "Rss"), 0) << "room for a storm that does not come";
        *static_cast<volatile char*>(room) = 1;
        EXPECT_GT(kilobytes(room, "Rss"), 0);
        EXPECT_EQ(kilobytes(room, "Locked"), kilobytes(room, "Pss")) << "what is used is not taken away";
        munmap(room, kRoom);
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
