// Turns in the cable: put in by the ship, or left in by the instructor, and what becomes of them.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::exercise {

using namespace rigs;

namespace {

/// Anchor on the bottom in 25 m, so much cable out (m), brake on, no wind or current. sternway: m/s, with
/// which the cable is laid out; without, it lies in a heap, which may foul the anchor.
Drill anchored(double cable_out, double sternway = 0) {
    ExerciseDef def = quiet_def(25, 5);
    def.ship_start.surge = -sternway;
    def.ship.bow_thruster = def.ship.stern_thruster = 150e3; // N, to turn her on the spot
    Drill drill(def);
    drill.run(1);
    drill.grip(0);
    drill.run_until([&] { return drill.chain().cable_out > cable_out; }, 60);
    drill.brake(1);
    drill.run(20);
    return drill;
}

/// Clutch in, brake off, heaving.
void heave(Drill& drill) {
    drill.clutch(true);
    drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60);
    drill.brake(0);
    drill.run(3);
    drill.speed_lever(1);
}

} // namespace

// She steams past her anchor, leaves it to port, turns and falls back on it. Turned to starboard the cable
// comes back the way it went; turned to port it goes on round her bow: a whole turn.
TEST(Turns, OneComesInWhenSheTurnsOnRoundTheAnchorThatShePassed) {
    for (const bool to_port : {true, false}) {
        Drill drill = anchored(70, 0.5);
        const auto ahead = [&] { // m that the anchor is ahead of the bow
            const Eigen::Vector3f way = drill.chain().nodes.back() - drill.chain().nodes.front();
            const double heading = drill.now().ship.heading;
            return way.x() * std::sin(heading) + way.y() * std::cos(heading);
        };
        drill.engine(-0.4);
        ASSERT_TRUE(drill.run_until([&] { return ahead() > 40; }, 300));
        const double lying = drill.chain().turns; // the anchor fell over and was turned into the pull
        drill.helm(0.4, 0.3, 0.3);                // the bow goes to starboard of the anchor
        ASSERT_TRUE(drill.run_until([&] { return drill.now().ship.surge > 0; }, 300));
        drill.helm(0.3, 0, 0);
        ASSERT_TRUE(drill.run_until([&] { return ahead() < -30; }, 300));
        EXPECT_NEAR(drill.chain().turns - lying, 0.43, 0.05); // it leads from ahead to a quarter to seven
        drill.helm(0, to_port ? -1 : 1, to_port ? 1 : -1);
        drill.run(400);
        drill.engine(-0.4);
        ASSERT_TRUE(drill.run_until([&] { return ahead() > 50; }, 900));
        drill.run(120);
        EXPECT_NEAR(drill.chain().turns - lying, to_port ? 1 : 0, 0.1);
    }
}

TEST(Turns, WedgeTheCableOfWhoHeavesOnAndNotOfWhoTakesThemOut) {
    for (const bool heave_on : {true, false}) {
        Drill drill = anchored(80);
        drill.fault(FaultCode::cable_twisted, 1);
        drill.run(1);
        EXPECT_EQ(drill.count("cable.turns"), 1); // 11 degrees a link
        heave(drill);
        ASSERT_TRUE(drill.run_until([&] { return drill.chain().cable_out < 50; }, 180));
        if (!heave_on) {
            drill.speed_lever(0);
            drill.run(5);
            drill.clear(FaultCode::cable_twisted);
            drill.speed_lever(1);
        }
        EXPECT_EQ(drill.run_until_event("motor.overload_trip", 120), heave_on);
        EXPECT_EQ(drill.count("cable.wedged"), heave_on);
        EXPECT_EQ(drill.count("anchor.aweigh"), !heave_on);
    }
}

TEST(Turns, ComeOutAtTheSwivelWhenTheAnchorIsAweigh) {
    Drill drill = anchored(45);
    drill.fault(FaultCode::cable_twisted, 0.25);
    heave(drill);
    EXPECT_EQ(drill.count("cable.turns"), 1); // two turns in less than 75 m
    ASSERT_TRUE(drill.run_until_event("anchor.aweigh", 120));
    // Called 5 s after she left the bottom, in which the swivel lets out 0.4 of the two.
    EXPECT_GT(drill.chain().turns, 1.1);
    drill.run(30);
    EXPECT_LT(drill.chain().turns, 0.2);
    EXPECT_EQ(drill.count("cable.wedged"), 0);
}

} // namespace windlass::exercise
