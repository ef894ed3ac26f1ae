// An exercise that starts moored to two anchors: she lies as she turned, and it stays so.

#include "server/assess/hawse.hpp"
#include "server/config/config.hpp"
#include "server/exercise/exercise.hpp"
#include "server/exercise/prelude.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::exercise {

namespace {

struct Lies {
    int half_turns, after_a_minute;
    double between; ///< half turns of the line between her lips against that between her anchors
    Snapshot seen;
};

/// The shipped exercise's ship, heading north after so many degrees clockwise since she moored.
Lies turned(double degrees) {
    ExerciseDef def = config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/moored_cross_18m.json");
    def.ship_start.turned = degrees * std::numbers::pi / 180;
    Exercise exercise(def);
    Lies lies;
    const auto look = [&] {
        exercise.view(lies.seen);
        const auto &port = lies.seen.tackle[0].chain.nodes, &starboard = lies.seen.tackle[1].chain.nodes;
        lies.between = assess::half_turns_between(port, starboard);
        return assess::turns_in_hawse(port, starboard);
    };
    lies.half_turns = look();
    for (int k = 0; k < 60 * def.tick_rate_hz; ++k)
        if (!exercise.step(1.0 / def.tick_rate_hz)) ADD_FAILURE() << "not finite";
    lies.after_a_minute = look();
    return lies;
}

} // namespace

// In line with a stream she rides half a half turn from the middle, on either side: an open hawse.
TEST(Moored, HasAnOpenHawseWhereSheHasNotTurned) {
    const Lies lies = turned(0);
    EXPECT_EQ(lies.half_turns, 0);
    EXPECT_NEAR(lies.between, -0.5, 0.1);
    for (const TackleView& tackle : lies.seen.tackle) {
        EXPECT_NEAR(tackle.chain.cable_out, 96.25, 1); // 3.5 shackles
        EXPECT_EQ(tackle.anchor.phase, AnchorPhase::holding);
        EXPECT_LT(tackle.windlass.hawse_tension, 30e3);
        EXPECT_TRUE(tackle.windlass.stopper_closed);
        EXPECT_EQ(tackle.windlass.brake_position, 1);
        EXPECT_EQ(tackle.windlass.clutch, ClutchState::out);
    }
    const auto apart = lies.seen.tackle[0].anchor.position - lies.seen.tackle[1].anchor.position;
    EXPECT_NEAR(apart.y(), 140, 15) << "port's ahead";
    EXPECT_NEAR(apart.x(), 0, 10);
}

// Through the model: the cables themselves are wound about each other, and stay so.
TEST(Moored, OnceRoundIsACrossToStarboardAndAnElbowToPort) {
    for (const auto& [degrees, half_turns] :
         {std::pair(360.0, 1), std::pair(-360.0, -2), std::pair(-180.0, -1)}) {
        SCOPED_TRACE(degrees);
        const Lies lies = turned(degrees);
        EXPECT_EQ(lies.half_turns, half_turns);
        EXPECT_EQ(lies.after_a_minute, half_turns);
        for (const TackleView& tackle : lies.seen.tackle)
            EXPECT_EQ(tackle.anchor.phase, AnchorPhase::holding);
    }
}

} // namespace windlass::exercise
