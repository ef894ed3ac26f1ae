// Run aground: told once, on board as well, and she stops.

#include "rigs/drill.hpp"
#include "server/config/config.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::exercise {

TEST(Aground, IsToldOnceAndStopsHer) {
    Drill drill(parse_exercise(R"({"environment": {"depth": 14, "wind_speed": 0, "current_speed": 0,
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

} // namespace windlass::exercise
