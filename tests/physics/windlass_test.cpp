// The machine on deck: brake, clutch, stopper, motor; what holds, what slips, what it costs in heat.

#include "tests/physics/tackle_rig.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::physics {
namespace {

/// A gypsy alone on which the chain pulls with a constant force (N): the top link yields nothing.
struct GypsyBench {
    WindlassDef def;
    ChainDef chain = stud_link_chain(0.078, Grade::k3, 330);
    Windlass windlass{def, chain, {0, 1e6}, 100};
    WindlassLevers levers;
    WindlassCauses causes;
    double dt = 1.0 / 300;

    void run(double seconds, double pull) {
        for (int k = 0; k < seconds / dt; ++k) {
            const TopLink link{
                .dt = dt, .pull = pull, .yielding = 1e-3, .outboard_mass = 0, .outboard_pull = 0};
            const DriveLine drive(windlass.prepare(dt, levers, causes));
            windlass.settle(dt, drive.result(link), nullptr);
        }
    }
    double speed() const { return windlass.state().cable_speed; }
    /// Pull outboard (N) that loads the brake with the given force while the chain is about to run out.
    double pull_for(double brake_force) const {
        const double g = chain.mass_per_metre * kGravity;
        return (brake_force + g * def.locker_lift) / def.hawse_efficiency - g * def.hawse_pipe_height;
    }
};

TEST(Brake, HoldsBelowSlipTorqueAndSlipsAbove) {
    GypsyBench bench;
    bench.run(2, bench.pull_for(0.99 * bench.def.brake_rating));
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_NEAR(bench.windlass.loads().brake / bench.def.brake_rating, 0.99, 1e-6);
    bench.run(2, bench.pull_for(1.01 * bench.def.brake_rating));
    EXPECT_GT(bench.speed(), 0.01);
}

TEST(Brake, SlippingTurnsItsForceIntoHeat) {
    GypsyBench bench;
    const double pull = bench.pull_for(1.02 * bench.def.brake_rating);
    const double out = bench.windlass.state().cable_out;
    bench.run(0.3, pull);
    const double slipped = bench.windlass.state().cable_out - out;
    ASSERT_GT(slipped, 0.1);
    ASSERT_LT(bench.windlass.state().lining_temperature, bench.def.brake_fade_start);
    // The lining is still cold, so the force is the rating; 2 %: the first of 90 steps in a travel that grows
    // as t^2.
    EXPECT_NEAR(bench.windlass.state().brake_energy / (bench.def.brake_rating * slipped), 1, 0.02);
    const WindlassState& s = bench.windlass.state();
    const double stored =
        bench.def.lining_heat_capacity * (s.lining_temperature - bench.def.air_temperature) +
        bench.def.drum_heat_capacity * (s.drum_temperature - bench.def.air_temperature);
    EXPECT_NEAR(stored / s.brake_energy, 1, 1e-3); // what cools off in a second is less
}

TEST(Brake, FadesWhenItsLiningIsHot) {
    const GypsyBench bench;
    const Windlass& w = bench.windlass;
    EXPECT_DOUBLE_EQ(w.brake_capacity(1, 300, 0), bench.def.brake_rating);
    EXPECT_DOUBLE_EQ(w.brake_capacity(0.5, 300, 0), 0.5 * bench.def.brake_rating);
    // Capstan equation with what is left of the friction.
    const double left = bench.def.brake_friction * bench.def.brake_fade_residual;
    const double expected =
        std::expm1(left * bench.def.brake_wrap) / std::expm1(bench.def.brake_friction * bench.def.brake_wrap);
    EXPECT_NEAR(w.brake_capacity(1, 1000, 0) / bench.def.brake_rating, expected, 1e-12);
    EXPECT_LT(expected, 0.3);
    EXPECT_EQ(w.brake_capacity(1, 300, 1), 0); // no friction left: nothing holds
}

TEST(Brake, HandWheelTakesItsTime) {
    GypsyBench bench;
    bench.levers.brake = 0;
    bench.run(0.5 * bench.def.brake_travel_time, 0);
    EXPECT_NEAR(bench.windlass.state().brake_position, 0.5, 0.01);
}

TEST(Stopper, HoldsItsRatingBehindAnOpenBrake) {
    GypsyBench bench;
    bench.levers.stopper_closed = true;
    bench.run(0.1, 0);
    bench.levers.brake = 0;
    bench.run(3, bench.pull_for(0.99 * bench.def.stopper_rating));
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_NEAR(bench.windlass.loads().stopper / bench.def.stopper_rating, 0.99, 1e-3);
    bench.run(1, bench.pull_for(1.02 * bench.def.stopper_rating));
    EXPECT_GT(bench.speed(), 0);
}

TEST(Stopper, CannotBeClosedOnRunningChain) {
    GypsyBench bench;
    bench.levers.brake = 0;
    bench.run(4, bench.pull_for(1e5));
    ASSERT_GT(bench.speed(), 1);
    bench.levers.stopper_closed = true;
    bench.run(0.1, bench.pull_for(1e5));
    EXPECT_FALSE(bench.windlass.state().stopper_closed);
    EXPECT_TRUE(bench.windlass.state().stopper_refused);
}

TEST(Clutch, GoesInOnlyNearStandstill) {
    GypsyBench bench;
    bench.levers.brake = 0;
    bench.run(4, bench.pull_for(1e5));
    bench.levers.clutch_in = true;
    bench.run(0.1, bench.pull_for(1e5));
    EXPECT_EQ(bench.windlass.state().clutch, Clutch::engaging);
    bench.levers.brake = 1;
    bench.run(10, bench.pull_for(1e5));
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_EQ(bench.windlass.state().clutch, Clutch::in);
}

TEST(Clutch, DoesNotComeOutUnderLoad) {
    GypsyBench bench;
    bench.levers.clutch_in = true;
    bench.run(0.1, 0);
    bench.levers.brake = 0;
    bench.run(3, bench.pull_for(2e5)); // hangs on the shaft brake
    EXPECT_EQ(bench.speed(), 0);
    bench.levers.clutch_in = false;
    bench.run(0.1, bench.pull_for(2e5));
    EXPECT_EQ(bench.windlass.state().clutch, Clutch::in);
    EXPECT_TRUE(bench.windlass.state().clutch_refused);
    bench.levers.brake = 1; // take the weight on the brake, and it comes
    bench.run(3, bench.pull_for(2e5));
    EXPECT_EQ(bench.windlass.state().clutch, Clutch::out);
}

/// Heaving at full lever with the clutch in.
GypsyBench heaving() {
    GypsyBench bench;
    bench.levers.clutch_in = true;
    bench.run(0.1, 0);
    bench.levers.brake = 0;
    bench.levers.speed = 1;
    return bench;
}

/// Pull outboard (N) that loads the motor with the given pull at the gypsy while heaving.
double heaving_pull(const GypsyBench& bench, double motor_pull) {
    const double g = bench.chain.mass_per_metre * kGravity;
    return (motor_pull + g * bench.def.locker_lift) * bench.def.hawse_efficiency -
           g * bench.def.hawse_pipe_height;
}

TEST(Motor, HeavesRatedPullAtRatedSpeed) {
    GypsyBench bench = heaving();
    bench.run(10, heaving_pull(bench, bench.def.rated_pull));
    EXPECT_NEAR(-bench.speed() / bench.def.rated_speed, 1, 0.01);
}

TEST(Motor, RunsALightLineAtItsTopSpeed) {
    GypsyBench bench = heaving();
    bench.run(10, heaving_pull(bench, 0.05 * bench.def.rated_pull));
    EXPECT_NEAR(-bench.speed() / bench.def.light_line_speed, 1, 0.01);
}

TEST(Motor, StallsAndTripsAboveItsStallPull) {
    GypsyBench bench = heaving();
    bench.run(5, heaving_pull(bench, 0.98 * bench.def.stall_pull));
    EXPECT_LT(-bench.speed(), 0.1 * bench.def.rated_speed);
    EXPECT_FALSE(bench.windlass.state().tripped);
    bench.run(80, heaving_pull(bench, 0.98 * bench.def.stall_pull));
    EXPECT_TRUE(bench.windlass.state().tripped);
    bench.levers.speed = 0;
    bench.run(0.1, 0);
    EXPECT_FALSE(bench.windlass.state().tripped); // the lever at zero resets it
}

TEST(Motor, GivesShortTimePullForTwoMinutesWithoutTripping) {
    // IACS UR A3 3.1.3: 1.5 times the continuous pull for 2 minutes.
    GypsyBench bench = heaving();
    bench.run(120, heaving_pull(bench, 1.5 * bench.def.rated_pull));
    EXPECT_FALSE(bench.windlass.state().tripped);
    EXPECT_LT(bench.speed(), 0); // it still heaves
}

TEST(Motor, WithoutPowerItsShaftBrakeHolds) {
    GypsyBench bench = heaving();
    bench.run(5, heaving_pull(bench, 2e5));
    ASSERT_LT(bench.speed(), 0);
    bench.causes.power_lost = 1;
    bench.run(3, heaving_pull(bench, 2e5));
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_GT(bench.windlass.loads().shaft_brake, 1e5);
}

TEST(Tackle, HangsOnItsBrakeWithExactlyItsWeight) {
    TackleRig rig(TackleSetup{}, quiet_water(40));
    rig.run(2);
    const Anchor& anchor = rig.tackle.anchor();
    const double chain = 5 - 0.5 * rig.setup.chain.node_spacing; // the anchor carries the lowest half link
    const double expected = anchor.weight(rig.environment) + chain * weight_in_air(rig.setup.chain);
    // 1e-3: the lowest links are partly in the water.
    EXPECT_NEAR(rig.deck().hawse_tension / expected, 1, 5e-3);
    EXPECT_EQ(rig.windlass().cable_speed, 0);
}

TEST(Tackle, WalksBackAtTheMotorsSpeed) {
    TackleSetup setup;
    setup.clutch_in = true;
    setup.brake = 0;
    TackleRig rig(setup, quiet_water(40));
    rig.levers.speed = -0.5;
    rig.run(10);
    // The load drives the motor: it holds it at its speed but for its slip (kDroopSpeed at full pull).
    EXPECT_NEAR(rig.windlass().cable_speed, 0.5 * setup.windlass.light_line_speed, 0.01);
}

TEST(Tackle, StopsHardAtTheBitterEndAndStaysWhole) {
    TackleSetup setup;
    setup.brake = 0;
    TackleRig rig(setup, quiet_water(40));
    rig.run(90);
    EXPECT_TRUE(rig.tackle.finite());
    EXPECT_NEAR(rig.windlass().cable_out, rig.tackle.bitter_end(), 1e-9);
    EXPECT_EQ(rig.windlass().cable_speed, 0);
}

TEST(Tackle, HeavesTheAnchorHome) {
    TackleSetup setup;
    setup.clutch_in = true;
    setup.brake = 0;
    setup.cable_out = 20;
    TackleRig rig(setup, quiet_water(40));
    rig.levers.speed = 1;
    ASSERT_TRUE(
        rig.run_until([&] { return rig.windlass().cable_out <= home_length(setup.chain) + 1e-6; }, 120));
    rig.run(2);
    EXPECT_TRUE(rig.tackle.finite());
    EXPECT_EQ(rig.windlass().cable_speed, 0);
    EXPECT_LT(rig.deck().end_stop, 0); // the motor pulls against the seat
}

} // namespace
} // namespace windlass::physics
