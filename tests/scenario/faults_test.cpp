// The instructor's faults are causes in the model: what the trainee sees follows from them.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::exercise {

using namespace rigs;

namespace {

/// Anchor hanging in deep water on the brake, clutch out.
Drill hanging(double cable_out = 25) {
    Drill drill(quiet_def(60, cable_out));
    drill.run(1);
    return drill;
}

/// The same, but heaving at full lever, brake off.
Drill heaving() {
    Drill drill = hanging();
    drill.clutch(true);
    drill.brake(0);
    drill.run(3);
    drill.speed_lever(1);
    drill.run(3);
    return drill;
}

} // namespace

TEST(Faults, FadedLiningHoldsLess) {
    Drill drill = hanging();
    const double sound = drill.windlass().brake_capacity;
    double before = sound;
    for (const double severity : {0.2, 0.5, 0.8}) {
        drill.fault(FaultCode::brake_lining_faded, severity);
        drill.run(0.1);
        EXPECT_LT(drill.windlass().brake_capacity, before) << severity;
        before = drill.windlass().brake_capacity;
    }
    EXPECT_EQ(drill.windlass().cable_speed, 0); // what is left still holds this anchor
    drill.clear(FaultCode::brake_lining_faded);
    drill.run(0.1);
    EXPECT_EQ(drill.windlass().brake_capacity, sound);
}

TEST(Faults, CableRunsAwayUnderAClosedBrakeWithoutLining) {
    Drill drill = hanging();
    drill.fault(FaultCode::brake_lining_faded, 1);
    drill.run(3);
    EXPECT_EQ(drill.count("brake.slipping"), 1);
    EXPECT_EQ(drill.windlass().brake_position, 1);
    EXPECT_EQ(drill.windlass().brake_capacity, 0);
    EXPECT_GT(drill.windlass().cable_speed, 3);

    drill.clear(FaultCode::brake_lining_faded);
    drill.run(5);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
}

TEST(Faults, HalfFadedBrakeStopsTheCableLater) {
    const auto run_out = [](double severity) {
        Drill drill = hanging(10);
        drill.fault(FaultCode::brake_lining_faded, severity);
        drill.brake(0);
        drill.run(4);
        drill.grip(0.3);
        drill.run(6);
        return drill.chain().cable_out;
    };
    EXPECT_GT(run_out(0.7), run_out(0) + 0.5);
}

TEST(Faults, ShaftBrakeHoldsTheCableWhenTheMotorLosesPower) {
    Drill drill = heaving();
    ASSERT_LT(drill.windlass().cable_speed, -0.3);
    drill.fault(FaultCode::motor_power_lost);
    drill.run(1);
    const double held_at = drill.chain().cable_out;
    EXPECT_FALSE(drill.windlass().power);
    drill.run(10);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    EXPECT_EQ(drill.chain().cable_out, held_at);
    EXPECT_EQ(drill.windlass().motor_torque, 0);   // not the motor,
    EXPECT_GT(drill.windlass().motor_load, 5e4);   // but the brake on its shaft
    EXPECT_EQ(drill.windlass().brake_capacity, 0); // and not the band brake

    // Power that comes back starts nothing: the lever must have been at zero.
    drill.clear(FaultCode::motor_power_lost);
    drill.run(3);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    drill.speed_lever(0);
    drill.run(0.1);
    drill.speed_lever(1);
    drill.run(3);
    EXPECT_LT(drill.windlass().cable_speed, -0.3);
}

TEST(Faults, CableRunsOutWhenTheClutchJumpsOutWhileHeaving) {
    Drill drill = heaving();
    drill.fault(FaultCode::clutch_jumps_out);
    drill.run(2);
    EXPECT_NE(drill.windlass().clutch, ClutchState::in);
    EXPECT_GT(drill.windlass().cable_speed, 3);
    EXPECT_EQ(drill.windlass().motor_load, 0);
}

TEST(Faults, BandBrakeCatchesTheCableWhenTheClutchJumpsOut) {
    Drill drill = heaving();
    drill.grip(0.15); // a careful hand keeps the brake touching while heaving
    drill.run(4);
    ASSERT_LT(drill.windlass().cable_speed, 0);
    const double before = drill.chain().cable_out;
    drill.fault(FaultCode::clutch_jumps_out);
    drill.run(2);
    EXPECT_NE(drill.windlass().clutch, ClutchState::in);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    EXPECT_NEAR(drill.chain().cable_out, before, 0.1);
}

TEST(Faults, WornClutchStaysInUnderALightLoad) {
    // It jumps out above half the rated pull of 433 kN; heaving this anchor takes about 160 kN.
    Drill drill = heaving();
    drill.fault(FaultCode::clutch_jumps_out, 0.5);
    drill.run(5);
    EXPECT_EQ(drill.windlass().clutch, ClutchState::in);
    EXPECT_LT(drill.windlass().cable_speed, -0.3);
}

TEST(Faults, DeadLoadCellShowsNothingWhileTheLoadIsThere) {
    Drill drill = hanging();
    const double load = drill.windlass().gypsy_load;
    ASSERT_EQ(drill.windlass().gypsy_load_indicated, load);
    drill.fault(FaultCode::load_cell_dead);
    drill.run(1);
    EXPECT_EQ(drill.windlass().gypsy_load_indicated, 0);
    EXPECT_NEAR(drill.windlass().gypsy_load, load, 1);
    drill.clear(FaultCode::load_cell_dead);
    drill.run(1);
    EXPECT_EQ(drill.windlass().gypsy_load_indicated, drill.windlass().gypsy_load);
}

TEST(Faults, ChainCounterDriftsWhileTheCableRunsAndTheMarksDoNot) {
    Drill drill = hanging();
    ASSERT_EQ(drill.windlass().cable_out_indicated, drill.windlass().cable_out);
    drill.fault(FaultCode::chain_counter_drift, 0.5);
    drill.brake(0);
    ASSERT_TRUE(drill.run_until([&] { return drill.chain().cable_out > 55; }, 20));
    EXPECT_NEAR(drill.windlass().cable_out_indicated, 25 + 0.5 * (drill.windlass().cable_out - 25), 1);
    EXPECT_EQ(drill.windlass().cable_out, drill.chain().cable_out);
    const MarkView& second = drill.chain().marks[1]; // two white links on either side: 55 m from the anchor
    EXPECT_EQ(second.white_links, 2);
    EXPECT_NEAR(second.outboard, drill.chain().cable_out - 55, 1e-9);
    EXPECT_NEAR(second.position.z(), drill.chain().nodes[0].z() - second.outboard, 0.02);
}

TEST(Triggers, FaultComesAtItsTime) {
    Drill drill = hanging();
    drill.fault(FaultCode::load_cell_dead, 1, FaultTrigger::at_time, 2.5);
    ASSERT_TRUE(drill.run_until_event("fault.active", 5));
    EXPECT_EQ(drill.count("fault.armed"), 1);
    EXPECT_NEAR(drill.first("fault.active")->time, 2.5, 0.004);
}

TEST(Triggers, FaultComesAtItsCableOut) {
    Drill drill = hanging();
    drill.fault(FaultCode::brake_lining_faded, 0.5, FaultTrigger::at_cable_out, 30);
    drill.brake(0);
    ASSERT_TRUE(drill.run_until_event("fault.active", 20));
    EXPECT_NEAR(drill.chain().cable_out, 30, 0.05); // 10 m/s times two ticks, at the most
}

TEST(Triggers, FaultComesAtItsLoad) {
    Drill drill = hanging();
    drill.fault(FaultCode::load_cell_dead, 1, FaultTrigger::at_load, 1.4e5); // hanging it is 85 kN
    drill.run(2);
    EXPECT_EQ(drill.count("fault.active"), 0);
    drill.clutch(true);
    drill.brake(0);
    drill.run(3);
    drill.speed_lever(1); // heaving, the hawse pipe's friction comes on top
    ASSERT_TRUE(drill.run_until_event("fault.active", 5));
    EXPECT_GE(drill.windlass().gypsy_load, 1.4e5);
}

TEST(Triggers, ClearedFaultNoLongerComes) {
    Drill drill = hanging();
    drill.fault(FaultCode::load_cell_dead, 1, FaultTrigger::at_time, 3);
    drill.run(0.5);
    drill.clear(FaultCode::load_cell_dead);
    drill.run(4);
    EXPECT_EQ(drill.count("fault.active"), 0);
    EXPECT_EQ(drill.count("fault.cleared"), 1);
    ASSERT_EQ(drill.now().faults.size(), 1u);
    EXPECT_EQ(drill.now().faults[0].phase, FaultPhase::cleared);
}

TEST(Triggers, FaultOfOneSideLeavesTheOtherAlone) {
    ExerciseDef def = quiet_def(60, 25);
    def.tackle.push_back(def.tackle[0]);
    def.tackle[1].side = Side::starboard;
    Drill drill(def);
    drill.run(1);
    drill.fault(FaultCode::load_cell_dead); // port
    drill.run(1);
    EXPECT_EQ(drill.now().tackle[0].windlass.gypsy_load_indicated, 0);
    EXPECT_GT(drill.now().tackle[1].windlass.gypsy_load_indicated, 5e4);
}

} // namespace windlass::exercise
