// What cannot be an exercise, and an exercise whose numbers blow up.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace windlass::exercise {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST(Definition, WithoutCableIsRefused) {
    ExerciseDef def;
    def.tackle.clear();
    EXPECT_THROW(Exercise{def}, std::invalid_argument);
}

TEST(Definition, WithThreeCablesIsRefused) {
    ExerciseDef def;
    def.tackle.resize(3);
    def.tackle[1].side = Side::starboard;
    EXPECT_THROW(Exercise{def}, std::invalid_argument);
}

TEST(Definition, WithTwoCablesOnOneSideIsRefused) {
    ExerciseDef def;
    def.tackle.resize(2);
    EXPECT_THROW(Exercise{def}, std::invalid_argument);
    def.tackle[1].side = Side::starboard;
    EXPECT_NO_THROW(Exercise{def});
}

TEST(Definition, WithMoreCableOutThanOnBoardIsRefused) {
    ExerciseDef def;
    def.tackle[0].cable_out = def.tackle[0].chain.length + 1;
    EXPECT_THROW(Exercise{def}, std::invalid_argument);
    def.tackle[0].cable_out = -4; // beyond the anchor's seat
    EXPECT_THROW(Exercise{def}, std::invalid_argument);
}

TEST(UnboundedState, IsReportedByStepAndSurvived) {
    for (const double value : {kInfinity, -kInfinity, kNotANumber}) {
        ExerciseDef def = rigs::quiet_def(25, 5);
        Exercise exercise(def);
        Snapshot good;
        for (int k = 0; k < 30; ++k)
            ASSERT_TRUE(exercise.step(1.0 / def.tick_rate_hz));
        exercise.view(good);
        exercise.apply(EnvironmentOrder{.weather = {.wind_speed = value}});
        bool failed = false;
        for (int k = 0; k < 30; ++k) {
            const bool stepped = exercise.step(1.0 / def.tick_rate_hz);
            EXPECT_FALSE(failed && stepped) << "it cannot recover by itself";
            failed = failed || !stepped;
        }
        EXPECT_TRUE(failed) << value;
        EXPECT_EQ(good.tick, 30u); // what was seen last stays good
        EXPECT_TRUE(std::isfinite(good.ship.surge));
        Snapshot after;
        exercise.view(after); // the wreck can be looked at for the fault report
    }
}

TEST(UnboundedState, IsReportedWhenTheCurrentIsInfinite) {
    ExerciseDef def = rigs::quiet_def(25, 20);
    def.weather.current_speed = kInfinity;
    Exercise exercise(def);
    EXPECT_FALSE(exercise.step(1.0 / def.tick_rate_hz));
}

TEST(Step, CountsTicksAsTime) {
    ExerciseDef def = rigs::quiet_def(25, 5);
    Exercise exercise(def);
    EXPECT_EQ(exercise.time(), 0);
    for (int k = 0; k < 300; ++k)
        ASSERT_TRUE(exercise.step(1.0 / def.tick_rate_hz));
    EXPECT_EQ(exercise.tick(), 300u);
    EXPECT_EQ(exercise.time(), 1);
}

} // namespace windlass::exercise
