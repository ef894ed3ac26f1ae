// Accidents of the record in the weather reported, with no fault on board but what the report names; right
// handling keeps her (docs/lessons.md, "The record").

#include "rigs/drill.hpp"
#include "server/config/config.hpp"
#include "server/exercise/prelude.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace windlass::exercise {

using namespace rigs;

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
    const ExerciseDef laid = with_prelude_played(
        config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/accident_pasha_bulker.json"));
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

// A box ship (Gard): 35 m, 8 shackles, 40 knots, the bars not across; the cable rendered through a brake that
// was tight. One that is worn to its rivets and wet (a tenth of its rating, 0.29 MN) does, before the anchor
// drags, while she swings to a side; the bar across holds it. One that is sound cannot: it carries seven
// times what drags her anchor, which drags.
TEST(Record, GardsBoxShipRendersAWornBrakeUnlessTheBarIsAcross) {
    constexpr double kReported = 20.6; // m/s, 40 knots
    ExerciseDef def = config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/accident_box_ship_gard.json");
    def.faults.clear();
    const ExerciseDef laid = with_prelude_played(def);
    for (const auto& [worn, bar] : {std::pair{true, false}, {true, true}, {false, false}}) {
        SCOPED_TRACE(worn ? bar ? "bar across" : "worn" : "sound");
        Drill drill(laid);
        if (worn) {
            drill.fault(FaultCode::brake_lining_worn);
            drill.fault(FaultCode::brake_wet);
        }
        if (bar) drill.stopper(true);
        drill.wind(kReported);
        const double out = drill.chain().cable_out, dragged = drill.anchor().dragged;
        drill.run(480);
        const double way = drill.anchor().dragged - dragged;
        if (worn && !bar) {
            EXPECT_GT(drill.chain().cable_out, out + 20);
            EXPECT_LT(way, 30);
        } else {
            EXPECT_NEAR(drill.chain().cable_out, out, 1);
            EXPECT_GT(way, 50);
        }
    }
}

// CHIRP 2017: in ballast, 34 m, 6 shackles, 30 to 35 knots with gusts of 40, a swell of 4 m; the cable crept
// through the brake. With a lining that is worn, glazed and wet it does; the stopper holds it, and so does a
// brake that is sound.
TEST(Record, Chirp2017RendersAWornBrakeInBallastUnlessTheStopperIsOn) {
    const ExerciseDef laid = with_prelude_played(
        config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/accident_tanker_chirp_2017.json"));
    for (const auto& [worn, stopper] : {std::pair{true, false}, {true, true}, {false, false}}) {
        SCOPED_TRACE(worn ? stopper ? "stopper on" : "worn" : "sound");
        Drill drill(laid);
        if (!worn)
            for (const FaultCode code :
                 {FaultCode::brake_lining_worn, FaultCode::brake_lining_glazed, FaultCode::brake_wet})
                drill.clear(code);
        if (stopper) drill.stopper(true);
        const double out = drill.chain().cable_out;
        drill.run(600);
        if (worn && !stopper) {
            EXPECT_GT(drill.chain().cable_out, out + 5);
            EXPECT_GT(drill.count("brake.slipping"), 0);
        } else {
            EXPECT_NEAR(drill.chain().cable_out, out, 1);
        }
    }
}

} // namespace windlass::exercise
