// Friction of the chain in its hawse pipe: a belt on a drum, bent as the cable's lead asks.

#include "rigs/grip_in_proportion.hpp"
#include "rigs/gypsy_bench.hpp"
#include "rigs/tackle_rig.hpp"
#include "server/physics/tackle/hawse_pipe_fit.hpp"
#include "tests/physics/tackle/laid_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace windlass::physics {
using namespace rigs;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Pull at the gypsy over pull outboard.
double share(const DeckResult& deck) {
    return deck.gypsy_load / deck.pipe_pull;
}

/// The same of a bench on which the cable is bent by so much (rad), while the motor heaves or walks back.
double share(double bend, double lever) {
    GypsyBench bench;
    bench.cable.bend = bend;
    bench.drive(lever);
    bench.run(5, 1e5);
    EXPECT_GT(-bench.speed() * lever, 0.02);
    return share(bench.windlass.loads().deck);
}

TEST(HawseFriction, IsThatOfABeltOnADrumAndURA3sWithTheAnchorHanging) {
    EXPECT_NEAR(share(90 * kDegree, -0.5), 0.7, 1e-9);
    EXPECT_NEAR(share(90 * kDegree, 0.5), 1 / 0.7, 1e-9);
    EXPECT_NEAR(share(0, -0.5), 1, 1e-9);
    EXPECT_NEAR(share(0, 0.5), 1, 1e-9);
    // One bend after the other takes its share of what the first has left.
    EXPECT_NEAR(share(180 * kDegree, -0.5), 0.49, 1e-9);
    EXPECT_NEAR(share(30 * kDegree, 0.5) * share(70 * kDegree, 0.5), share(100 * kDegree, 0.5), 1e-9);
}

/// A bench on which the cable was hove in against a pull (N) and is held by brake and shaft brake.
GypsyBench held_after_heaving(double pull) {
    GypsyBench bench;
    bench.drive(0.3);
    bench.run(3, pull);
    EXPECT_LT(bench.speed(), -0.05);
    bench.levers.speed = 0;
    bench.levers.brake = 1;
    bench.run(8, pull);
    EXPECT_EQ(bench.speed(), 0);
    return bench;
}

TEST(HawseFriction, HelpsTheBrakeWhenThePullRisesWhicheverWayTheChainMovedLast) {
    GypsyBench bench = held_after_heaving(7e4);
    const auto deck = [&]() -> const DeckResult& { return bench.windlass.loads().deck; };
    EXPECT_GT(share(deck()), 1.3); // against the motor, up to here
    const double stood = deck().gypsy_load;
    bench.run(1, 1e5);
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_NEAR(deck().gypsy_load, stood, 1e-6); // the pipe bears what has come
    bench.run(1, 4e5);
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_NEAR(share(deck()), 0.7, 1e-9);
    EXPECT_NEAR(bench.windlass.loads().brake, deck().gypsy_load - bench.windlass.locker_weight(), 1e-3);
    // As the pull falls the pipe bears it inboard: what stands on deck is held until there is half of it.
    const double most = deck().gypsy_load;
    bench.run(1, 3e5);
    EXPECT_NEAR(deck().gypsy_load, most, 1e-6);
    bench.run(1, 1e5);
    EXPECT_NEAR(share(deck()), 1 / 0.7, 1e-9);
}

TEST(HawseFriction, TurnsWithAMoveThatStretchesTheChainOnDeckAndNotWithLess) {
    // Claws that are not in line fall in while the drive turns them over, and it stops at once.
    GypsyBench bench;
    bench.run(1, 5e4);
    ASSERT_NEAR(share(bench.windlass.loads().deck), 0.7, 1e-9);
    bench.windlass.state().clutch.claw_offset = 0.5 * claw_pitch(bench.def);
    bench.levers.clutch_in = true;
    ASSERT_TRUE(bench.run_until([&] { return bench.state().clutch.position == Clutch::in; }, 5e4, 20));
    bench.run(1, 5e4);
    const double hove_in = 100 - bench.state().cable_out;
    EXPECT_GT(hove_in, 0);
    EXPECT_LT(hove_in, 1e-4);
    const DeckResult& deck = bench.windlass.loads().deck;
    const double stretch = hove_in * bench.chain.stiffness / bench.def.hawse_pipe_length;
    EXPECT_NEAR(deck.gypsy_load, 0.7 * deck.pipe_pull + stretch, 0.01 * stretch);
}

HawsePipe port_pipe(const TackleSetup& setup) {
    const ShipDef ship;
    const ObstacleMesh mesh = hull_mesh(ship, setup.chain.contact_diameter);
    return fit_hawse_pipe(ship, setup.windlass, setup.chain, setup.anchor, mesh, -1);
}

TEST(HawseFriction, ChainIsBentByAQuarterTurnFromDeckToPlumbHoweverSteepThePipe) {
    for (const double steep : {30.0, 48.6, 75.0}) {
        const double slope = steep * kDegree;
        const HawsePipe pipe{.bore = {0, std::cos(slope), std::sin(slope)}};
        EXPECT_NEAR(pipe.bent({0, 0, -1}), 90 * kDegree, 1e-9) << steep;
        EXPECT_NEAR(pipe.bent(-pipe.bore), slope, 1e-6) << steep;     // straight on
        EXPECT_NEAR(pipe.bent({0, -1, 0}), 2 * slope, 1e-9) << steep; // level again
        // Inboard under the ship by 20 degrees from plumb.
        EXPECT_NEAR(pipe.bent({0, std::sin(20 * kDegree), -std::cos(20 * kDegree)}), 110 * kDegree, 1e-9)
            << steep;
    }
}

TEST(HawseFriction, AnchorHangingCostsWhatURA3Says) {
    TackleSetup setup;
    setup.pipe = port_pipe(setup);
    setup.cable_out = 30;
    setup.clutch_in = true;
    setup.brake = 0;
    TackleRig rig(setup, quiet_water(100));
    rig.levers.speed = 0.5;
    rig.run(20);
    EXPECT_LT(rig.windlass().cable_speed, -0.05);
    EXPECT_NEAR(share(rig.deck()) * 0.7, 1, 2e-3); // it swings by some tenths of a degree
    rig.levers.speed = -0.5;
    rig.run(20);
    EXPECT_GT(rig.windlass().cable_speed, 0.05);
    EXPECT_NEAR(share(rig.deck()) / 0.7, 1, 2e-3);
}

/// A cable laid out over the bottom by a lip that goes this way at 1 m/s, then hove in slowly: what the pipe
/// makes of its pull, and what a belt would that is bent from level into the bore, and into that pull.
struct LongStay {
    double share, belt;
    double wavering; ///< largest change of the share from one step to the next
};

LongStay heave_at_long_stay(const Vec3& way) {
    TackleSetup setup;
    setup.pipe = port_pipe(setup);
    setup.cable_out = 10;
    setup.brake = 0;
    grip_in_proportion(setup.windlass);
    TackleRig rig(setup, quiet_water(25));
    EXPECT_TRUE(lay_out_and_gear_in(rig, way));
    rig.levers.speed = 0.4;
    rig.run(3);
    EXPECT_LT(rig.windlass().cable_speed, -0.05);

    LongStay result{};
    double before = share(rig.deck());
    for (int k = 0; k < 3000; ++k) {
        rig.step();
        result.share = share(rig.deck());
        result.wavering = std::max(result.wavering, std::abs(result.share / before - 1));
        before = result.share;
    }
    const Vec3 pull = rig.tackle.pull_on_ship().normalized(), bore = setup.pipe->bore;
    const double bend = std::asin(bore.z()) + std::acos(-bore.dot(pull));
    result.belt = std::exp(0.22706 * bend); // ln(1/0.7) over a quarter turn
    return result;
}

TEST(HawseFriction, LongStayCostsByItsLeadAndDoesNotWaver) {
    const LongStay ahead = heave_at_long_stay({-1, 0, 0}), abeam = heave_at_long_stay({0, -1, 0}),
                   astern = heave_at_long_stay({1, 0, 0});
    for (const LongStay& stay : {ahead, abeam, astern}) {
        EXPECT_NEAR(stay.share / stay.belt, 1, 1e-3); // the pull of the step before
        EXPECT_LT(stay.wavering, 1e-3);               // nodes that go at the lip, waves in the cable
    }
    // The port pipe points to port and ahead. A cable that leads aft is bent back over its lip.
    EXPECT_GT(astern.share, 1.1 * ahead.share);
    EXPECT_GT(astern.share, 1.1 * abeam.share);
}

} // namespace
} // namespace windlass::physics
