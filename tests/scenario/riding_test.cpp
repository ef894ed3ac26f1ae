// How she rides to her anchor, called as it truly is: brought up, holding, dragging; and dragging as the
// bridge sees it.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace windlass::exercise {
using namespace rigs;

namespace {

/// N, level, of both what the cable pulls now and its mean in what follows.
double level_pull(const Drill& drill) {
    return std::hypot(drill.now().cable_force.x(), drill.now().cable_force.y());
}

/// One way to anchor.
struct Way {
    const char* name;
    double wind = 8, depth = 25, surge = -0.5, swell = 0; ///< m/s, m, m/s, m
    int shackles = 6;
    double engine = 0.5;  ///< ahead, to take her way off once the cable grows
    double until = -0.15; ///< m/s, surge at which it is stopped
};

std::ostream& operator<<(std::ostream& out, const Way& way) {
    return out << way.name;
}

Drill anchored(const Way& way) {
    ExerciseDef def = let_go_def();
    def.environment.depth = way.depth;
    def.weather.wind_speed = way.wind;
    def.weather.swell_height = way.swell;
    def.weather.swell_period = 11;
    def.ship_start.surge = way.surge;
    Drill drill(def);
    EXPECT_TRUE(let_go_and_pay_out(drill, way.shackles));
    if (way.engine == 0) return drill;
    EXPECT_TRUE(drill.run_until([&] { return drill.windlass().gypsy_load > 75e3; }, 600));
    drill.engine(way.engine);
    EXPECT_TRUE(drill.run_until([&] { return drill.now().ship.surge > way.until; }, 600));
    drill.engine(0);
    return drill;
}

class RidingAnchorings : public testing::TestWithParam<Way> {};

/// The load has risen and come down to what it stays at: of its rise above the mean of the ten minutes that
/// follow, a third is left at most (a quarter, and what she yaws meanwhile), and the anchor has stopped for
/// good.
TEST_P(RidingAnchorings, AreBroughtUpWhenTheLoadHasRisenAndFallenToWhatItStaysAt) {
    Drill drill = anchored(GetParam());
    double peak = 0;
    const bool brought_up = drill.run_until(
        [&] {
            peak = std::max(peak, level_pull(drill));
            return drill.count("anchor.brought_up") > 0;
        },
        1200);
    ASSERT_TRUE(brought_up);
    // Over two periods of the swell.
    double called = 0;
    constexpr int kTicks = 22 * 300;
    for (int k = 0; k < kTicks; ++k) {
        called += level_pull(drill) / kTicks;
        drill.tick();
    }
    const double dragged = drill.anchor().dragged;
    double mean = 0;
    constexpr int kMeanTicks = 600 * 300;
    for (int k = 0; k < kMeanTicks; ++k) {
        drill.tick();
        mean += level_pull(drill) / kMeanTicks;
    }
    EXPECT_LT(called - mean, (peak - mean) / 3) << peak << " " << called << " " << mean;
    EXPECT_GT(drill.anchor().embedment, 0.2);
    EXPECT_LT(drill.anchor().dragged - dragged, 0.5);
    EXPECT_EQ(drill.count("anchor.brought_up"), 1);
    EXPECT_EQ(drill.anchor().phase, AnchorPhase::holding);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, RidingAnchorings,
    testing::Values(Way{.name = "Breeze"}, Way{.name = "SlowShip", .surge = -0.25},
                    Way{.name = "FreshWind", .wind = 15, .surge = -0.25, .engine = 0.3},
                    Way{.name = "NearGale", .wind = 17, .surge = -0.25, .shackles = 7, .engine = 0.4},
                    Way{.name = "Swell", .wind = 5, .surge = -0.25, .swell = 1.5},
                    Way{.name = "Shoal", .depth = 18, .surge = -0.3, .shackles = 5}),
    [](const auto& info) { return std::string(info.param.name); });

// A rule that looked at tension and speed alone called it at 325 kN, where wind and stream ask 21 kN. A man
// at the window waits until most of what her way put into the cable is out of it: 321 kN at the peak, 100
// now.
TEST(Riding, IsNotBroughtUpWhileTheCableStillCarriesTenTimesTheSteadyForce) {
    Drill drill = anchored({.name = "Breeze"});
    double peak = 0;
    ASSERT_TRUE(drill.run_until(
        [&] {
            peak = std::max(peak, level_pull(drill));
            return drill.count("anchor.brought_up") > 0;
        },
        300));
    constexpr double kAsked = 21e3; // N, by wind and stream
    EXPECT_GT(peak, 10 * kAsked);
    EXPECT_LT(level_pull(drill), 5 * kAsked);
    EXPECT_LT(level_pull(drill) - kAsked, (peak - kAsked) / 3);
}

// The engine takes her way off before the cable grows: the anchor never digs in, and she lies to the weight
// of her cable. (At 0.3 ahead, slower, it digs in by 0.22 and holds.)
TEST(Riding, IsNotBroughtUpByAnAnchorThatDoesNotDigIn) {
    Drill drill = anchored({.name = "TooSlow", .depth = 40, .shackles = 8, .engine = 0});
    drill.engine(0.4);
    ASSERT_TRUE(drill.run_until([&] { return drill.now().ship.surge > 0.1; }, 600));
    drill.engine(0);
    drill.run(1200);
    EXPECT_LT(drill.anchor().embedment, 0.2);
    EXPECT_EQ(drill.count("anchor.brought_up"), 0);
}

// The bridge tests the anchor: while she pulls astern it holds but she is not brought up, when she stops she
// is.
TEST(Riding, IsBroughtUpWhenTheEngineThatTestedTheAnchorHasStopped) {
    Drill drill = anchored({.name = "Slow", .surge = -0.25});
    drill.engine(-0.4); // 220 kN
    drill.run(600);
    EXPECT_EQ(drill.count("anchor.brought_up"), 0);
    EXPECT_GT(level_pull(drill), 170e3); // the race throws her stern to port: she does not pull in one line
    drill.engine(0);
    EXPECT_TRUE(drill.run_until_event("anchor.brought_up", 300));
    EXPECT_GT(drill.anchor().embedment, 0.5);
}

/// Brought up to six shackles and lying for so long (s) in a wind of so many m/s, which goes round by half a
/// radian so that she sheers about.
Drill yawing(double wind, double seconds) {
    Drill drill = anchored({.name = "Slow", .surge = -0.25});
    EXPECT_TRUE(drill.run_until_event("anchor.brought_up", 600));
    drill.wind(wind);
    drill.tick();
    drill.wind_shifts(0.5);
    drill.run(seconds);
    return drill;
}

// The anchor's speed, looked at in every step, called it digging in and holding 52 times as she yawed.
TEST(Riding, YawDoesNotMakeEventsChatter) {
    Drill drill = yawing(20, 1800);
    EXPECT_EQ(drill.count("anchor.dragging"), 0);
    EXPECT_EQ(drill.count("anchor.brought_up"), 1);
    // Once for each metre and more that it is truly dug in further at most.
    EXPECT_LE(drill.count("anchor.digging_in"), 1 + static_cast<int>(drill.anchor().dragged));
    EXPECT_LE(drill.count("anchor.digging_in"), 4);
}

// Truth and bridge: the anchor is called at once, the circle later, and neither over and over.
TEST(Riding, GaleDragsHerAndTheBridgeSeesItLaterByPosition) {
    Drill drill = yawing(12, 300);
    EXPECT_EQ(drill.count("anchor.dragging"), 0);
    const auto& anchor = drill.anchor().position;
    const double swing = drill.chain().cable_out + drill.exercise().def().ship.length_overall;
    drill.give(WatchCircleOrder{true, anchor.x(), anchor.y(), swing + 20});
    drill.run(60);
    EXPECT_EQ(drill.count("watch.circle"), 0);
    const double before = drill.anchor().dragged;
    drill.wind(32);
    ASSERT_TRUE(drill.run_until_event("anchor.dragging", 900));
    EXPECT_LT(drill.anchor().dragged - before,
              12); // flukes that are half in go in first, 8 m; and 2 m beyond
    EXPECT_EQ(drill.count("watch.dragging"), 0);
    ASSERT_TRUE(drill.run_until_event("watch.dragging", 900));
    EXPECT_EQ(drill.count("watch.circle"), 1);
    EXPECT_GT(drill.anchor().dragged - before, 20);
    drill.run(300);
    EXPECT_EQ(drill.count("anchor.dragging"), 1);
    EXPECT_EQ(drill.count("watch.dragging"), 1);
}

} // namespace
} // namespace windlass::exercise
