// The anchor in its hawse pipe, as the forecastle sees it.

#include "rigs/drill.hpp"
#include "server/physics/windlass/chain_counter.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace windlass::exercise {
using namespace rigs;

namespace {

TEST(AnchorHome, LiesThereOnTheBrakeAndLeavesWhenLetGo) {
    for (const double heading : {0.0, 1.2, 4.0}) {
        Drill drill(anchor_home_def(25, heading));
        drill.run(5);
        EXPECT_EQ(drill.anchor().phase, AnchorPhase::housed) << heading;
        EXPECT_LT(drill.chain().cable_out, -2) << heading;
        EXPECT_GT(drill.windlass().hawse_tension, 5e4)
            << heading; // part of its weight, and what is locked in
        drill.brake(0);
        EXPECT_TRUE(drill.run_until_event("anchor.let_go", 10)) << heading;
        EXPECT_TRUE(drill.run_until_event("anchor.on_bottom", 20)) << heading;
    }
}

TEST(AnchorHome, LiesStillFromTheFirstTickOnAShipUnderWay) {
    ExerciseDef def = anchor_home_def(25, 0.7);
    def.ship_start.surge = 2;
    def.ship_start.yaw_rate = 0.01;
    Drill drill(def);
    // Of its 97 kN the bore bears what is square to it, and friction holds what was drawn in tight: the cable
    // has at least the rest, 0.75 of it, and a push of the wedged crown, but no jerk (which made 360 kN).
    double min = 1e9, max = 0;
    for (int i = 0; i < 20; ++i) {
        drill.run(0.25);
        min = std::min(min, drill.windlass().hawse_tension);
        max = std::max(max, drill.windlass().hawse_tension);
    }
    EXPECT_GT(min, 0.7 * 97e3);
    EXPECT_LT(max, 1.5 * 97e3);
}

TEST(AnchorHome, WalkedBackIsACockbillAndHoveInIsHomeAgain) {
    Drill drill(anchor_home_def(25, 0.5));
    drill.brake(0);
    drill.clutch(true);
    drill.run(5); // the claws find their gaps
    drill.speed_lever(-0.5);
    ASSERT_TRUE(drill.run_until([&] { return drill.chain().cable_out > 3; }, 60));
    drill.speed_lever(0);
    drill.run(3);
    EXPECT_EQ(drill.anchor().phase, AnchorPhase::acockbill);
    EXPECT_EQ(drill.count("anchor.acockbill"), 1);
    EXPECT_GT(drill.windlass().hawse_tension, 9e4); // all of its 97 kN, and 5 of chain
    drill.speed_lever(0.5);
    EXPECT_TRUE(drill.run_until_event("anchor.housed", 60));
    EXPECT_LT(drill.chain().cable_out, -2.5);
    // The counter was set to the cable outboard of the lip: with the shackle up the pipe it is below zero.
    const double pulse = physics::counter_pulse(drill.exercise().def().tackle[0].chain.diameter);
    EXPECT_NEAR(drill.windlass().cable_out_indicated, drill.chain().cable_out, pulse);
}

} // namespace
} // namespace windlass::exercise
