// A runaway: what it is (docs/glossary.md), that it is called once, and that a state keeps that it was.

#include "rigs/drill.hpp"
#include "server/exercise/checkpoint.hpp"
#include "words/words.hpp"

#include <gtest/gtest.h>

namespace windlass::exercise {
using namespace rigs;

namespace {

constexpr const char* kRunaway = "cable.runaway";

/// Let go in water so deep that a brake which is left open loses the cable: 300 m of it.
Drill deep() {
    ExerciseDef def = quiet_def(200, 5);
    Drill drill(def);
    drill.brake(0);
    return drill;
}

TEST(Runaway, IsCalledOnceWhenTheCableRunsFasterThanItsLimit) {
    Drill drill = deep();
    ASSERT_TRUE(drill.run_until_event(kRunaway, 60)) << "fastest: " << drill.fastest_payout();
    const auto called = drill.first(kRunaway);
    EXPECT_EQ(called->side, 0);
    EXPECT_EQ(called->severity, Severity::alarm);
    EXPECT_GT(called->value, words::limits::cable_runaway);
    EXPECT_LT(called->value, words::limits::cable_runaway + 0.5);
    drill.run(3);
    EXPECT_EQ(drill.count(kRunaway), 1);
}

TEST(Runaway, IsNoneWhereTheCableRunsAsPracticeLetsIt) {
    Drill drill(let_go_def()); // 25 m
    drill.brake(0);
    drill.run(10);
    EXPECT_GT(drill.fastest_payout(), words::limits::cable_fast);
    EXPECT_EQ(drill.count(kRunaway), 0) << "fastest: " << drill.fastest_payout();
}

TEST(Runaway, IsKeptByACheckpoint) {
    Drill drill = deep();
    ASSERT_TRUE(drill.run_until_event(kRunaway, 60));
    Exercise again = read_checkpoint(write_checkpoint(drill.exercise()));
    for (int tick = 0; tick < 300; ++tick) {
        ASSERT_TRUE(drill.tick());
        ASSERT_TRUE(again.step(1.0 / again.def().tick_rate_hz));
    }
    EXPECT_EQ(drill.count(kRunaway), 1);
    EXPECT_EQ(write_checkpoint(again), write_checkpoint(drill.exercise())) << "it was called again, or not";
}

} // namespace
} // namespace windlass::exercise
