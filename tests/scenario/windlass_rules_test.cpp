// What the machine does and refuses, whatever the hand on the levers wants.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace windlass::exercise {

using namespace rigs;

namespace {

/// Cable running out, brake off, clutch out.
Drill running() {
    Drill drill(quiet_def(60, 5));
    drill.run(1);
    drill.brake(0);
    drill.run(3.5);
    return drill;
}

/// Anchor hanging on the motor, brake off. depth: m.
Drill in_gear(double depth) {
    Drill drill(quiet_def(depth, 5));
    drill.run(1);
    drill.clutch(true);
    drill.brake(0);
    drill.run(3);
    return drill;
}

} // namespace

TEST(DogClutch, DoesNotGoInWhileTheGypsyTurns) {
    Drill drill = running();
    ASSERT_GT(drill.windlass().cable_speed, 1);
    drill.clutch(true);
    drill.run(1);
    EXPECT_EQ(drill.count("clutch.refused"), 1);
    EXPECT_EQ(drill.windlass().clutch, ClutchState::engaging);
    EXPECT_GT(drill.windlass().cable_speed, 1);
    // Held by the brake, the chain stands. Claws that are not in line then go in as the motor turns them on,
    // slowly: a pitch of the claws at 0.012 m/s is less than a minute.
    drill.brake(1);
    drill.run(6);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    drill.speed_lever(0.03);
    EXPECT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60));
}

TEST(DogClutch, DoesNotComeOutUnderLoad) {
    Drill drill = in_gear(60);
    drill.clutch(false);
    drill.run(1);
    EXPECT_EQ(drill.count("clutch.refused"), 1);
    EXPECT_EQ(drill.windlass().clutch, ClutchState::in);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    // The band brake takes the load, and the teeth are free.
    drill.brake(1);
    drill.run(3);
    EXPECT_EQ(drill.windlass().clutch, ClutchState::out);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
}

TEST(ChainStopper, DoesNotCloseOnRunningChain) {
    Drill drill = running();
    drill.stopper(true);
    drill.run(0.5);
    EXPECT_EQ(drill.count("stopper.refused"), 1);
    EXPECT_FALSE(drill.windlass().stopper_closed);
    EXPECT_GT(drill.windlass().cable_speed, 1);
}

TEST(ChainStopper, TakesTheLoadWhenTheBrakeIsEased) {
    Drill drill(quiet_def(60, 25));
    drill.run(1);
    drill.stopper(true);
    drill.run(0.5);
    ASSERT_TRUE(drill.windlass().stopper_closed);
    const double out = drill.chain().cable_out;
    EXPECT_EQ(drill.windlass().stopper_load, 0); // loose behind the set brake
    drill.brake(0);
    drill.run(4);
    EXPECT_GT(drill.windlass().stopper_load, 5e4);
    EXPECT_EQ(drill.chain().cable_out, out);
    // Loaded, its bar cannot be lifted.
    drill.stopper(false);
    drill.run(1);
    EXPECT_TRUE(drill.windlass().stopper_closed);
    EXPECT_EQ(drill.count("stopper.refused"), 1);
}

// "Take the weight, stopper off": also when the bar is thought of after the motor has drawn the cable up to
// it.
TEST(ChainStopper, LiftsWhileTheMotorHeavesAgainstIt) {
    Drill drill(quiet_def(60, 25));
    drill.run(1);
    drill.stopper(true);
    drill.clutch(true);
    drill.run(1);
    drill.brake(0);
    drill.run(3);
    drill.speed_lever(0.4);
    drill.run(3);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    EXPECT_LT(drill.windlass().stopper_load, -1e5); // up against it from outboard
    drill.stopper(false);
    drill.run(0.5);
    EXPECT_FALSE(drill.windlass().stopper_closed);
    EXPECT_EQ(drill.count("stopper.refused"), 0);
    EXPECT_LT(drill.windlass().cable_speed, -0.1);
}

TEST(Motor, WalksBackAtItsOwnSpeed) {
    Drill drill = in_gear(60);
    for (const double lever : {-0.25, -0.5, -1.0}) {
        drill.speed_lever(lever);
        drill.run(5);
        const double light_line = drill.exercise().def().tackle[0].windlass.light_line_speed;
        EXPECT_NEAR(drill.windlass().cable_speed, -lever * light_line, 0.03 * light_line) << lever;
    }
    drill.speed_lever(0);
    drill.run(3);
    EXPECT_EQ(drill.windlass().cable_speed, 0); // the shaft brake has it
}

TEST(Motor, WeighsTheAnchorAndBringsItHome) {
    Drill drill = in_gear(12);
    drill.speed_lever(-1);
    ASSERT_TRUE(drill.run_until_event("anchor.on_bottom", 60)); // the crown; the cable lowers the shank
    const ExerciseDef& def = drill.exercise().def();
    drill.run(def.tackle[0].anchor.shank_length / def.tackle[0].windlass.light_line_speed + 1);
    EXPECT_LT(drill.windlass().hawse_tension, 4e4); // the bottom carries the anchor
    drill.speed_lever(1);
    ASSERT_TRUE(drill.run_until_event("anchor.aweigh", 120));
    drill.run(2);                                   // the jerk of breaking out rings off
    EXPECT_GT(drill.windlass().hawse_tension, 9e4); // the cable does again
    // In still water it comes up as it lay, which may be with its flukes inboard: a stream from ahead turns
    // them aft.
    drill.current(0.3, drill.now().ship.heading + std::numbers::pi);
    drill.run(60);
    ASSERT_TRUE(bring_home(drill));
    EXPECT_EQ(drill.count("anchor.housed"), 1);
    EXPECT_LT(drill.chain().cable_out, 1);
}

TEST(Motor, TripsWhenItHeavesAgainstTheStopper) {
    Drill drill(quiet_def(60, 25));
    drill.run(1);
    drill.stopper(true);
    drill.clutch(true);
    drill.run(1);
    drill.brake(0);
    drill.run(3);
    drill.speed_lever(1);
    const double out = drill.chain().cable_out;
    ASSERT_TRUE(drill.run_until_event("motor.overload_trip", 120));
    // Twice the rated pull at standstill: UR A3 lets a motor trip no sooner than after 2 minutes at 1.5
    // times.
    EXPECT_GT(drill.now().time, 40);
    const double step = 0.35 * 0.01; // m, by which it overruns the bar: at 0.35 m/s in three ticks
    EXPECT_NEAR(drill.chain().cable_out, out - drill.exercise().def().tackle[0].chain.diameter, step);
    EXPECT_TRUE(drill.windlass().tripped);
    drill.run(0.1);
    EXPECT_EQ(drill.windlass().motor_torque, 0);
    // Lever to zero resets it, but only once relay and winding have cooled.
    drill.speed_lever(0);
    drill.run(1);
    EXPECT_TRUE(drill.windlass().tripped);
    drill.run(300);
    EXPECT_FALSE(drill.windlass().tripped);
}

TEST(Motor, TripsWhenItHeavesAgainstAClosedBrake) {
    // An old brake that holds the chain against the motor, too: with this motor a sound one gives way, since
    // a band grips heaving chain far less than chain that runs out.
    ExerciseDef def = quiet_def(60, 25);
    def.tackle[0].windlass.brake_rating = 6e6;
    Drill drill(def);
    drill.run(1);
    drill.clutch(true);
    drill.run(1);
    drill.speed_lever(1);
    ASSERT_TRUE(drill.run_until_event("motor.overload_trip", 120));
    EXPECT_NEAR(drill.chain().cable_out, 25, 0.01);
    EXPECT_TRUE(drill.windlass().tripped);
}

TEST(Motor, HeavesSlowlyThroughABrakeThatDrags) {
    const auto heave = [](double brake) {
        Drill drill = in_gear(60);
        drill.brake(brake);
        drill.run(3);
        drill.speed_lever(1);
        drill.run(2);
        return drill.windlass();
    };
    const WindlassView free = heave(0), dragging = heave(1);
    EXPECT_LT(std::abs(dragging.cable_speed), 0.5 * std::abs(free.cable_speed));
    EXPECT_GT(dragging.motor_load, free.motor_load);
    EXPECT_GT(dragging.brake_energy, free.brake_energy + 1e4); // lining wear
}

TEST(Windlass, EmergencyStopHoldsRunningCable) {
    Drill drill = running();
    drill.emergency_stop(true);
    drill.run(3);
    EXPECT_EQ(drill.windlass().brake_position, 1);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
}

TEST(Windlass, NothingMovesWhenTheEmergencyStopIsReleasedUntilItsLeversHaveBeenReset) {
    Drill drill = in_gear(60);
    drill.speed_lever(-1);
    drill.run(3);
    ASSERT_GT(drill.windlass().cable_speed, 0.1);
    drill.emergency_stop(true);
    drill.run(3);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    drill.emergency_stop(false); // with the brake's lever off and the motor's at full
    drill.run(5);
    EXPECT_EQ(drill.windlass().brake_position, 1);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    EXPECT_TRUE(drill.windlass().tripped);
    EXPECT_EQ(drill.count("brake.waits"), 1);
    drill.speed_lever(0);
    drill.brake(1);
    drill.run(0.1);
    EXPECT_FALSE(drill.windlass().tripped);
    drill.brake(0);
    drill.speed_lever(-1);
    drill.run(5);
    EXPECT_GT(drill.windlass().cable_speed, 0.1);
}

TEST(Windlass, BitterEndDoesNotStopTheCableThatNobodyBrakes) {
    // Gypsy and chain between locker and hawse pipe, 6 t at 7 m/s, on 10 m of chain: v sqrt(EA m / l) = 4 MN.
    Drill drill(quiet_def(60, 25));
    drill.run(1);
    drill.brake(0);
    ASSERT_TRUE(drill.run_until_event("cable.bitter_end_parted", 120));
    EXPECT_GT(drill.first("cable.bitter_end_parted")->value,
              drill.exercise().def().tackle[0].windlass.bitter_end_strength);
    ASSERT_TRUE(drill.run_until_event("cable.lost", 10));
    drill.run(1);
    EXPECT_EQ(drill.anchor().phase, AnchorPhase::lost);
    EXPECT_LT(drill.windlass().hawse_tension, 1e3); // the half link in the pipe
}

} // namespace windlass::exercise
