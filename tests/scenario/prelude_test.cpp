// An exercise that starts at anchor: how she lies then, and that it is the same bits however it is begun.

#include "server/config/config.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/exercise/moor.hpp"
#include "server/exercise/prelude.hpp"

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace windlass::exercise {
using namespace rigs;

namespace {

/// Six shackles on port in 25 m, stopper on, in so much wind (m/s) and swell (m).
ExerciseDef at_anchor_def(double wind, double swell = 0) {
    ExerciseDef def = let_go_def();
    def.weather.wind_speed = wind;
    def.weather.swell_height = swell;
    def.tackle[0].at_anchor = 6;
    def.tackle[0].stopper_closed = true;
    return def;
}

/// Played once, and looked at by every test below.
class Prelude : public testing::Test {
protected:
    static void SetUpTestSuite() {
        ExerciseDef def = at_anchor_def(15, 2);
        def.faults = {{.code = FaultCode::load_cell_dead, .severity = 0.5},
                      {.code = FaultCode::brake_wet,
                       .trigger = FaultTrigger::at_chance,
                       .trigger_value = 10,
                       .trigger_until = 20}};
        def_ = with_prelude_played(def);
        unplayed_ = def;
    }

    static ExerciseDef def_, unplayed_;
};

ExerciseDef Prelude::def_, Prelude::unplayed_;

TEST_F(Prelude, LeavesHerBroughtUpAndSecuredAtTickZero) {
    Drill drill(def_);
    EXPECT_EQ(drill.now().tick, 0U);
    EXPECT_TRUE(drill.exercise().brought_up(Side::port));
    EXPECT_FALSE(drill.exercise().brought_up(Side::starboard));
    EXPECT_NEAR(drill.shackles(), 6, 0.15);
    EXPECT_EQ(drill.anchor().phase, AnchorPhase::holding);
    EXPECT_GT(drill.anchor().embedment, 0.2);
    EXPECT_TRUE(drill.windlass().stopper_closed);
    EXPECT_EQ(drill.windlass().brake_position, 1);
    EXPECT_EQ(drill.windlass().clutch, ClutchState::out);
    EXPECT_LT(drill.windlass().lining_temperature, 330); // K: not hot from letting go
    EXPECT_NEAR(drill.now().ship.engine, 0, 1e-6);
    EXPECT_EQ(drill.now().environment.now.wind_speed, 15);
    EXPECT_EQ(drill.now().environment.ramp_left, 0);
    EXPECT_TRUE(drill.now().lights_and_shapes.anchor_ball); // it is noon
    EXPECT_FALSE(drill.now().lights_and_shapes.anchor_lights);
    // The cable lies out: the bow is nearly as far from the anchor as the cable reaches.
    const auto way = drill.now().tackle[0].hawse - drill.anchor().shackle;
    EXPECT_GT(std::hypot(way.x(), way.y()),
              0.9 * drill.chain().cable_out - drill.exercise().def().environment.depth);
}

TEST_F(Prelude, IsNotHeardInTheExerciseAndDoesNotDisturbIt) {
    Drill drill(def_);
    drill.run(120); // the swell comes up, she yaws
    EXPECT_EQ(drill.count("anchor.brought_up"), 0);
    EXPECT_EQ(drill.count("anchor.let_go"), 0);
    EXPECT_EQ(drill.count("anchor.dragging"), 0);
    EXPECT_LT(drill.largest_tension(),
              600e3); // no jerk: a third of the anchor's holding over that of a yaw's peak
    EXPECT_NEAR(drill.shackles(), 6, 0.15);
}

TEST_F(Prelude, GivesTheSameBitsPlayedAgainKeptOrReadFromACheckpoint) {
    Exercise kept(def_), played(unplayed_), read = read_checkpoint(write_checkpoint(kept));
    EXPECT_EQ(definition_hash(def_), definition_hash(unplayed_));
    for (int k = 0; k < 3000; ++k) {
        if (k == 1500) read = read_checkpoint(write_checkpoint(read));
        for (Exercise* exercise : {&kept, &played, &read})
            ASSERT_TRUE(exercise->step(1.0 / def_.tick_rate_hz));
    }
    EXPECT_TRUE(differences(kept, played).empty());
    EXPECT_TRUE(differences(kept, read).empty());
}

TEST_F(Prelude, FaultsOfTheFileAreThereAtTheStartOrComeInTheirWindow) {
    Drill drill(def_);
    EXPECT_EQ(drill.now().faults.at(0).phase, FaultPhase::active);
    EXPECT_EQ(drill.now().faults.at(1).phase, FaultPhase::armed);
    drill.run(1);
    EXPECT_NEAR(drill.windlass().gypsy_load_indicated, 0.5 * drill.windlass().gypsy_load,
                1e-6 * drill.windlass().gypsy_load);
    ASSERT_TRUE(drill.run_until_event("fault.active", 25));
    EXPECT_GE(drill.now().time, 10);
    EXPECT_LE(drill.now().time, 20);
}

// What an instructor loads begins, and stands a minute; accidents among it wait for who works the windlass.
TEST(PreludeAlone, EveryShippedExerciseThatStartsAtAnchorBegins) {
    int anchored = 0;
    for (const auto& entry : std::filesystem::directory_iterator(WINDLASS_CONFIG_DIR "/exercises")) {
        const ExerciseDef def = config::load_exercise(entry.path());
        if (anchored_by(def) == nullptr) continue;
        SCOPED_TRACE(def.name);
        ++anchored;
        Drill drill(def);
        // Moored she rides to neither anchor alone: each was tried with three times its weight.
        EXPECT_TRUE(moored(def) || drill.exercise().brought_up(Side::port));
        drill.run(60);
        EXPECT_EQ(drill.count("anchor.dragging"), 0);
        EXPECT_EQ(drill.count("cable.lost"), 0);
        EXPECT_NEAR(drill.shackles(), def.tackle[0].at_anchor, 0.3);
    }
    EXPECT_GE(anchored, 8);
}

TEST(PreludeAlone, OfCableThatDoesNotReachIsRefusedWithItsPlace) {
    ExerciseDef def = at_anchor_def(5);
    def.environment.depth = 70; // more than six shackles reach with the anchor dug in
    def.tackle[0].at_anchor = 2.8;
    try {
        const Exercise exercise(def);
        FAIL() << "she is brought up by cable that stands up and down";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("/tackle/0/at_anchor: 2.8"), std::string::npos)
            << error.what();
    }
}

} // namespace
} // namespace windlass::exercise
