// Clutch, stopper and gypsy on the bench, and the windlass with its cable and anchor.

#include "rigs/gypsy_bench.hpp"
#include "rigs/tackle_rig.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace windlass::physics {
using namespace rigs;

namespace {

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
    EXPECT_FALSE(bench.windlass.state().stopper.closed);
    EXPECT_TRUE(bench.windlass.state().stopper.refused);
}

TEST(Stopper, LiftsOnceTheWindlassHasTheWeightAndBearsAgainADiameterFurther) {
    GypsyBench bench;
    const double pull = bench.pull_for(1e5);
    bench.levers.stopper_closed = true;
    bench.run(0.1, 0);
    bench.drive(0);
    bench.run(3, pull);
    EXPECT_NEAR(bench.windlass.loads().stopper, 1e5, 1e2);
    bench.levers.stopper_closed = false;
    bench.run(1, pull);
    EXPECT_TRUE(bench.state().stopper.refused);

    GypsyBench heaving = bench;
    heaving.levers.speed = 0.3;
    EXPECT_TRUE(heaving.run_until([&] { return !heaving.state().stopper.closed; }, pull, 1));

    bench.levers.stopper_closed = true;
    bench.levers.speed = 0.3;
    bench.run(4, pull);                 // it comes in as far as the bar lets it, and stalls there
    const double step = 0.2 * bench.dt; // m, by which the bar may be overrun: faster it does not come
    EXPECT_NEAR(100 - bench.state().cable_out, bench.chain.diameter, step);
    EXPECT_LT(bench.windlass.loads().stopper, -1e4);
    bench.levers.stopper_closed = false; // the motor has the weight still, and more
    bench.run(0.5, pull);
    EXPECT_FALSE(bench.state().stopper.closed);
    EXPECT_FALSE(bench.state().stopper.refused);
    EXPECT_LT(bench.speed(), -0.05);
}

TEST(Clutch, GoesInOnlyNearStandstill) {
    GypsyBench bench;
    bench.levers.brake = 0;
    bench.run(4, bench.pull_for(1e5));
    bench.levers.clutch_in = true;
    bench.run(0.1, bench.pull_for(1e5));
    EXPECT_EQ(bench.windlass.state().clutch.position, Clutch::engaging);
    bench.levers.brake = 1;
    bench.run(10, bench.pull_for(1e5));
    EXPECT_EQ(bench.speed(), 0);
    // The claws stop anywhere; the drive turns them over slowly until they fall in.
    const double longest = claw_pitch(bench.def) / kInchingSpeed;
    EXPECT_TRUE(bench.run_until([&] { return bench.state().clutch.position == Clutch::in; },
                                bench.pull_for(1e5), longest));
}

TEST(Clutch, StaysOutOfLineWhenNothingTurnsItOver) {
    GypsyBench bench;
    bench.windlass.state().clutch.claw_offset = 0.5 * claw_pitch(bench.def);
    bench.levers.clutch_in = true;
    bench.causes.power_lost = 1;
    bench.run(30, 0);
    EXPECT_EQ(bench.state().clutch.position, Clutch::engaging);
    bench.causes.power_lost = 0;
    bench.run(20, 0);
    EXPECT_EQ(bench.state().clutch.position, Clutch::in);
}

TEST(Clutch, ShearsAboveItsRatingAndNotBelow) {
    for (const double damaged :
         {0.75, 0.95}) { // 500 kN and 100 kN of strength left for a load of 300 kN, started gently
        GypsyBench bench;
        bench.drive(1);
        bench.run(2, bench.heaving_pull(3e5));
        bench.causes.shaft_damaged = damaged;
        bench.run(5, bench.heaving_pull(3e5));
        EXPECT_EQ(bench.state().clutch.sheared, damaged == 0.95);
        EXPECT_EQ(bench.speed() > 0, damaged == 0.95);
    }
}

TEST(Gypsy, ChainJumpsAboveTheGripOfItsPockets) {
    for (const double load : {0.95, 1.05}) {
        GypsyBench bench;
        bench.causes.pockets_worn = 0.9; // 900 kN left
        bench.run(5, bench.pull_for(load * gypsy_grip(bench.def, bench.causes)));
        EXPECT_EQ(bench.state().gypsy.jumping, load > 1) << load;
        EXPECT_EQ(bench.speed() > 1, load > 1) << load;
    }
}

TEST(Gypsy, LinksSeatAgainWhenTheLoadIsOff) {
    GypsyBench bench;
    bench.causes.pockets_worn = 0.9;
    bench.run(1, bench.pull_for(1.05 * gypsy_grip(bench.def, bench.causes)));
    ASSERT_TRUE(bench.state().gypsy.jumping);
    bench.run(10, bench.pull_for(0.1 * gypsy_grip(bench.def, bench.causes)));
    EXPECT_FALSE(bench.state().gypsy.jumping);
    EXPECT_EQ(bench.speed(), 0);
}

TEST(Gypsy, TakesFortyDiametersOfChainARevolution) {
    const WindlassDef def;
    EXPECT_NEAR(2 * std::numbers::pi * def.gypsy_radius / gypsy_revolution(0.078), 1, 0.01);
}

TEST(Stopper, PawlHoldsAgainstRunningOutOnly) {
    WindlassDef def;
    def.stopper = StopperKind::pawl;
    GypsyBench bench(def);
    bench.drive(1);
    bench.run(5, bench.heaving_pull(2e5));
    bench.levers.stopper_closed = true; // dropped on chain that comes in
    bench.run(2, bench.heaving_pull(2e5));
    EXPECT_TRUE(bench.state().stopper.closed);
    EXPECT_LT(bench.speed(), -0.1); // and it still comes in
    bench.causes.hose_burst = bench.causes.power_lost = 1;
    bench.levers.clutch_in = false;
    bench.run(3, bench.pull_for(1e6)); // more than the shaft brake: the pawl has it
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_GT(bench.windlass.loads().stopper, 3e5);
}

TEST(Stopper, SpringsOpenWhenItsPinIsOut) {
    for (const double out : {0.0, 0.8}) { // opens above 0.2 of its rating, 720 kN
        GypsyBench bench;
        bench.levers.stopper_closed = true;
        bench.run(0.1, 0);
        bench.levers.brake = 0;
        bench.causes.stopper_pin_out = out;
        bench.run(4, bench.pull_for(1e6));
        EXPECT_EQ(bench.state().stopper.sprung, out > 0);
        EXPECT_EQ(bench.speed() > 1, out > 0);
    }
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
    EXPECT_EQ(bench.windlass.state().clutch.position, Clutch::in);
    EXPECT_TRUE(bench.windlass.state().clutch.refused);
    bench.levers.brake = 1; // take the weight on the brake, and it comes
    bench.run(3, bench.pull_for(2e5));
    EXPECT_EQ(bench.windlass.state().clutch.position, Clutch::out);
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
    // The load drives the motor: it holds it at its speed but for its slip (2 cm/s at full pull).
    EXPECT_NEAR(rig.windlass().cable_speed, 0.5 * setup.windlass.light_line_speed, 0.01);
}

TEST(Tackle, StopsHardAtTheBitterEndAndStaysWhole) {
    TackleSetup setup;
    setup.brake = 0;
    setup.windlass.bitter_end_strength = 1e7; // holds whatever comes
    TackleRig rig(setup, quiet_water(40));
    rig.run(60);
    EXPECT_TRUE(rig.tackle.finite());
    // The chain below the gypsy is stretched by what hangs on it: 400 kN on 10 m of EA = 614 MN is 7 mm.
    EXPECT_NEAR(rig.windlass().cable_out, rig.tackle.bitter_end(), 0.02);
    EXPECT_NEAR(rig.windlass().cable_speed, 0, 0.01);
}

TEST(Tackle, LosesItsCableWhenTheBitterEndParts) {
    TackleSetup setup;
    setup.brake = 0;
    TackleRig rig(setup, quiet_water(40));
    ASSERT_TRUE(rig.run_until([&] { return rig.windlass().chain_gone; }, 60));
    EXPECT_TRUE(rig.windlass().bitter_end_parted);
    rig.run(10);
    EXPECT_TRUE(rig.tackle.finite());
    EXPECT_LT(rig.deck().hawse_tension, 1e3); // the half link in the pipe
    // Its upper end falls to the bottom with the rest.
    EXPECT_LT(rig.tackle.chain().position.z[rig.tackle.chain().links - 1], -30);
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
