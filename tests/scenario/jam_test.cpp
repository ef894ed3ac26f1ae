// A cable that jams in the spurling pipe, in pairs: the same jam, met by careless and by right handling.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

namespace windlass::exercise {

using namespace rigs;

namespace {

/// Deep water; one link has lost three quarters of its strength, and the cable jams at 40 m.
Drill jam_at_40_m() {
    Drill drill(quiet_def(200, 15));
    drill.run(1);
    drill.fault(FaultCode::chain_link_weak, 0.75);
    drill.fault(FaultCode::spurling_pipe_jammed, 1, FaultTrigger::at_cable_out, 40);
    return drill;
}

/// Clutch in, brake off, the lever where it is wanted.
void drive(Drill& drill, double lever) {
    drill.clutch(true);
    drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60);
    drill.brake(0);
    drill.run(3);
    drill.speed_lever(lever);
}

} // namespace

TEST(Jam, JerksACableThatRunsUntilItsWeakLinkParts) {
    Drill drill = jam_at_40_m();
    drill.brake(0);
    ASSERT_TRUE(drill.run_until_event("spurling_pipe.fast", 20));
    drill.run(5);
    EXPECT_EQ(drill.count("cable.parted"), 1) << drill.largest_tension();
    EXPECT_EQ(drill.anchor().phase, AnchorPhase::lost);
}

TEST(Jam, OnlyStopsACableThatIsWalkedBack) {
    Drill drill = jam_at_40_m();
    drive(drill, -0.5);
    ASSERT_TRUE(drill.run_until_event("spurling_pipe.fast", 300));
    drill.speed_lever(0);
    drill.run(10);
    EXPECT_EQ(drill.count("cable.parted"), 0) << drill.largest_tension();
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    EXPECT_NEAR(drill.chain().cable_out, 40, 0.1);

    // Cleared, it goes on.
    drill.clear(FaultCode::spurling_pipe_jammed);
    drill.speed_lever(-0.5);
    EXPECT_TRUE(drill.run_until([&] { return drill.chain().cable_out > 45; }, 60));
}

TEST(Jam, TripsTheMotorOfWhoHeavesOnAndNotOfWhoStopsAndClearsThePipe) {
    for (const bool heave_on : {true, false}) {
        Drill drill(quiet_def(60, 40));
        drill.run(1);
        drive(drill, 1);
        drill.fault(FaultCode::spurling_pipe_jammed, 1, FaultTrigger::at_time, 20);
        ASSERT_TRUE(drill.run_until_event("spurling_pipe.heaping", 60));
        if (!heave_on) {
            drill.speed_lever(0);
            drill.run(5);
            drill.clear(FaultCode::spurling_pipe_jammed);
            drill.speed_lever(1);
        }
        EXPECT_EQ(drill.run_until_event("motor.overload_trip", 75), heave_on);
        EXPECT_EQ(drill.chain().cable_out < 15, !heave_on) << drill.chain().cable_out;
    }
}

// A motor drags the cable out through a light jam, and nobody can tell; let go, it stands, once for each try.
TEST(Jam, IsToldWhereLetGoCableStandsAndNotWhereTheMotorDragsItOut) {
    Drill drill(quiet_def(60, 8));
    drill.run(1);
    drill.fault(FaultCode::spurling_pipe_jammed, 0.06);
    drive(drill, -0.5);
    ASSERT_TRUE(drill.run_until([&] { return drill.chain().cable_out > 12; }, 60));
    drill.speed_lever(0);
    drill.run(5);
    drill.brake(1);
    drill.run(6);
    drill.clutch(false);
    ASSERT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::out; }, 10));
    drill.run(10);
    EXPECT_EQ(drill.count("spurling_pipe.fast"), 0) << "it ran, and then it was held";
    for (const int tries : {1, 2}) {
        drill.brake(0);
        drill.run(4);
        EXPECT_EQ(drill.count("spurling_pipe.fast"), tries - 1) << "nobody can tell yet";
        drill.run(26);
        EXPECT_EQ(drill.count("spurling_pipe.fast"), tries);
        drill.brake(1);
        drill.run(6);
    }
    EXPECT_EQ(drill.count("anchor.let_go"), 0);
}

} // namespace windlass::exercise
