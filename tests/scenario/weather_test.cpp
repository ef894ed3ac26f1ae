// Weather that changes while an exercise runs: at once, or on a ramp, the same on every machine.

#include "server/exercise/checkpoint.hpp"

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::exercise {
using namespace rigs;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(Weather, RampIsAStraightLineAndEndsAtWhatWasOrdered) {
    WeatherInRamp weather(Weather{.wind_speed = 10, .current_speed = 0});
    weather.order({.wind_speed = 20, .current_speed = 1, .visibility = 500}, 100);
    EXPECT_EQ(weather.left(), 100);
    EXPECT_EQ(weather.after().wind_speed, 20);
    for (int k = 0; k < 25; ++k)
        EXPECT_TRUE(weather.advance(1));
    EXPECT_NEAR(weather.now().wind_speed, 12.5, 1e-9);
    EXPECT_NEAR(weather.now().current_speed, 0.25, 1e-9);
    EXPECT_NEAR(weather.now().visibility, 20000 - 0.25 * 19500, 1e-6);
    for (int k = 0; k < 75; ++k)
        weather.advance(1);
    EXPECT_EQ(weather.left(), 0);
    EXPECT_EQ(weather.now().wind_speed, 20);
    EXPECT_EQ(weather.now().visibility, 500);
    EXPECT_FALSE(weather.advance(1)); // nothing that the model knows changes any more
}

TEST(Weather, AnglesGoTheShortWayRound) {
    WeatherInRamp weather(Weather{.wind_from = 350 * kDegree, .current_towards = 10 * kDegree});
    weather.order({.wind_from = 20 * kDegree, .current_towards = 340 * kDegree}, 10);
    for (int k = 0; k < 5; ++k)
        weather.advance(1);
    EXPECT_NEAR(weather.now().wind_from, 5 * kDegree, 1e-9);
    EXPECT_NEAR(weather.now().current_towards, 355 * kDegree, 1e-9);
}

TEST(Weather, VeeringWindGoesOnTurningAlsoDuringARamp) {
    WeatherInRamp weather(Weather{.wind_from = 0, .veering = 0.01});
    EXPECT_TRUE(weather.advance(10));
    EXPECT_NEAR(weather.now().wind_from, 0.1, 1e-12);
    Weather stronger = weather.now();
    stronger.wind_speed = 20;
    weather.order(stronger, 10);
    for (int k = 0; k < 10; ++k)
        weather.advance(1);
    EXPECT_NEAR(weather.now().wind_from, 0.2, 1e-12);
    EXPECT_EQ(weather.now().wind_speed, 20);
}

TEST(Weather, ClockGoesOnWithExerciseTimeAndRoundMidnight) {
    WeatherInRamp weather(Weather{.time_of_day = kDay - 5});
    EXPECT_FALSE(weather.advance(15)); // of no concern to the model
    EXPECT_NEAR(weather.now().time_of_day, 10, 1e-9);
    Weather later = weather.now();
    later.wind_speed = 12;
    weather.order(later, 100);
    weather.advance(50);
    EXPECT_NEAR(weather.now().time_of_day, 60, 1e-9);
}

TEST(Weather, ProfileOfTheCurrentChangesLayerByLayer) {
    WeatherInRamp weather(Weather{});
    Weather layered;
    layered.current_profile = {{.depth = 0, .share = 1, .turn = 0}, {.depth = 20, .share = 0, .turn = 0}};
    weather.order(layered, 10);
    for (int k = 0; k < 5; ++k)
        weather.advance(1);
    ASSERT_EQ(weather.now().current_profile.size(), 2U);
    EXPECT_NEAR(weather.now().current_profile[0].share, 1, 1e-12);
    EXPECT_NEAR(weather.now().current_profile[1].share, 0.5, 1e-12);
    weather.order(Weather{}, 10);
    weather.advance(10);
    EXPECT_TRUE(weather.now().current_profile.empty());
}

TEST(Weather, RampedWindReachesTheShip) {
    const auto surge = [](double ramp) {
        Drill drill(quiet_def(25, 5));
        Weather gale = drill.now().environment.now;
        gale.wind_speed = 20;
        drill.give(EnvironmentOrder{gale, ramp});
        drill.run(20);
        return drill.now().ship.surge;
    };
    EXPECT_LT(surge(0), surge(10)); // set back less while it freshens
    EXPECT_LT(surge(10), surge(20));
    EXPECT_LT(surge(20), 0);
}

TEST(Weather, RampIsKeptInACheckpoint) {
    Drill drill(quiet_def(25, 5));
    Weather gale = drill.now().environment.now;
    gale.wind_speed = 20, gale.veering = 0.001;
    gale.current_speed = 1;
    gale.current_profile = {{.depth = 0}, {.depth = 10, .share = 0.5}};
    drill.give(EnvironmentOrder{gale, 30});
    drill.run(5);
    Exercise& live = drill.exercise();
    Exercise read = read_checkpoint(write_checkpoint(live));
    for (int k = 0; k < 600; ++k) {
        live.step(1.0 / live.def().tick_rate_hz);
        read.step(1.0 / read.def().tick_rate_hz);
    }
    const auto found = differences(live, read);
    EXPECT_TRUE(found.empty()) << found[0].field << ' ' << found[0].first << ' ' << found[0].second;
}

TEST(Weather, StartIsWhatTheDefinitionSays) {
    ExerciseDef def = quiet_def(25, 5);
    def.weather.wind_speed = 7, def.weather.visibility = 900, def.weather.time_of_day = 3600;
    def.environment.wind_speed = 99; // the weather has the say
    Drill drill(def);
    EXPECT_EQ(drill.now().environment.now.wind_speed, 7);
    EXPECT_EQ(drill.exercise().def().environment.wind_speed, 7);
    EXPECT_EQ(drill.now().environment.now.visibility, 900);
    drill.run(10);
    EXPECT_NEAR(drill.now().environment.now.time_of_day, 3610, 1e-6);
    EXPECT_EQ(drill.now().environment.ramp_left, 0);
    EXPECT_EQ(drill.now().environment.after.wind_speed, 7);
}

} // namespace
} // namespace windlass::exercise
