// Run aground: told once, on board as well, and she stops.

#include "rigs/drill.hpp"
#include "server/config/config.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace windlass::exercise {

TEST(Aground, IsToldOnceAndStopsHer) {
    rigs::Drill drill(
        config::parse_exercise(R"({"environment": {"depth": 14, "wind_speed": 0, "current_speed": 0,
                                     "ground": {"slope_deg": 0.6, "slope_towards_deg": 180}},
                                   "ship_start": {"surge": 1.5, "y": -60}})",
                               "beach", WINDLASS_CONFIG_DIR));
    ASSERT_TRUE(drill.run_until_event("ship.aground", 300));
    const auto told = drill.first("ship.aground");
    EXPECT_EQ(told->severity, Severity::alarm);
    EXPECT_GT(told->value, 1); // m/s
    drill.run(120);
    EXPECT_EQ(drill.count("ship.aground"), 1);
    EXPECT_LT(std::hypot(drill.now().ship.surge, drill.now().ship.sway), 0.05);
    EXPECT_EQ(drill.count("ship.afloat"), 0);
}

// A bed that rises to starboard by 1 in 20, and the tide going out: she takes the ground with the starboard
// bilge and heels to port, and is told as she lies. In a swell, working on the ground, she is called aground
// once as well.
TEST(Aground, FallingTideHeelsHer) {
    for (const double swell : {0.0, 0.5}) {
        SCOPED_TRACE(swell);
        rigs::Drill drill(
            config::parse_exercise(fmt::format(R"({{"environment": {{"depth": 14, "wind_speed": 0,
                                     "current_speed": 0, "swell_height": {}, "swell_period": 12,
                                     "ground": {{"slope_deg": 2.86, "slope_towards_deg": 270}}}}}})",
                                               swell),
                                   "slope", WINDLASS_CONFIG_DIR));
        EnvironmentOrder falls{.weather = drill.now().environment.now};
        falls.weather.tide_height = -2.6;
        drill.give(falls);
        drill.run(400); // at 1 cm/s
        const auto axes = drill.now().ship.attitude.toRotationMatrix();
        const double to_port = -std::asin(axes(2, 1)); // her axes: forward, to port, up
        EXPECT_GT(to_port, 0.02);
        EXPECT_LT(to_port, 0.055); // no farther than the ground
        EXPECT_EQ(drill.count("ship.aground"), 1);
        EXPECT_EQ(drill.count("ship.afloat"), 0);
    }
}

} // namespace windlass::exercise
