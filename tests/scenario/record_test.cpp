// Accidents of the record without any fault on board: the weather as reported does it, and right handling
// keeps her. Those that need a worn brake are lessons (docs/lessons.md, "The record").

#include "rigs/drill.hpp"
#include "server/config/config.hpp"
#include "server/exercise/prelude.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::exercise {

namespace {

/// A hand at the wheel and the telegraph keeps her head to the wind, from the north, for so many seconds.
void hold_head_to_wind(Drill& drill, double engine, int seconds) {
    for (int k = 0; k < seconds; k += 2) {
        const auto& ship = drill.now().ship;
        const double off = std::remainder(ship.heading, 2 * std::numbers::pi);
        if (engine > 0)
            drill.give(HelmOrder{.engine = engine,
                                 .rudder = std::clamp(-1.5 * off - 60 * ship.yaw_rate, -0.6, 0.6)});
        drill.run(2);
    }
}

} // namespace

// ATSB 243: in ballast, 35 knots and a heavy swell on a lee shore; she yawed, dragged and grounded. Eight
// shackles, everything sound. A third of the engine before she drags keeps her: the anchor digs in by 50 m
// (cable laid in 15 m/s, now a gale), and stays.
TEST(Record, PashaBulkerDragsInTheWeatherReportedUnlessTheEngineIsUsed) {
    constexpr double kReported = 18; // m/s, 35 knots; gusts and swell are the exercise's
    const ExerciseDef laid =
        with_prelude_played(load_exercise(WINDLASS_CONFIG_DIR "/exercises/accident_pasha_bulker.json"));
    for (const double engine : {0.0, 0.35}) {
        SCOPED_TRACE(engine);
        Drill drill(laid);
        drill.wind(kReported);
        const double dragged = drill.anchor().dragged, out = drill.chain().cable_out;
        hold_head_to_wind(drill, engine, 1800);
        if (engine > 0)
            EXPECT_LT(drill.anchor().dragged - dragged, 100);
        else
            EXPECT_GT(drill.anchor().dragged - dragged, 400);
        EXPECT_NEAR(drill.chain().cable_out, out, 1); // brake and stopper hold
    }
}

} // namespace windlass::exercise
