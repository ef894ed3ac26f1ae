// How deep she goes by her own speed, and how she lies on ground that bears a part of her.

#include "server/physics/base/units.hpp"
#include "server/physics/sea/ground.hpp"
#include "server/physics/ship/flotation.hpp"
#include "server/physics/ship/grounding.hpp"
#include "server/physics/ship/ship_dynamics.hpp"
#include "tests/physics/exercise_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::physics {
namespace {

/// Still air and water, so deep (m).
EnvironmentDef still(double depth) {
    EnvironmentDef sea;
    sea.depth = depth, sea.wind_speed = sea.current_speed = 0;
    return sea;
}

/// A bed that is shallowest to starboard of a ship that heads north: slope in rad, so deep (m) under her keel
/// line.
EnvironmentDef athwart(double depth, double slope) {
    EnvironmentDef sea = still(depth);
    GroundDef ground;
    ground.slope = slope, ground.slope_towards = 1.5 * std::numbers::pi;
    lay_ground(sea, ground);
    return sea;
}

/// Lets the water fall to a level (m) at 2 cm/s, and her come to rest.
ShipState left_by_the_tide(const ShipDef& ship, EnvironmentDef& sea, double level) {
    ShipDynamics dynamics(ship);
    ShipState state;
    for (int k = 0; k < 300 * 300; ++k) {
        sea.level = std::max(level, sea.level - 0.02 * kStep);
        state.level = sea.level;
        dynamics.step(sea, {}, {}, {}, kStep, state);
    }
    return state;
}

GroundLift lift(const ShipDef& ship, const EnvironmentDef& sea, const ShipState& state) {
    return keel_and_ground(ship, sea, state, kStep).lift;
}

} // namespace

// A laden Panamax: some 66 t for a centimetre, 1000 t m to trim her by one, KM 13 m (stability booklets of
// the class, as recalled).
TEST(Flotation, HydrostaticsAreThoseOfHerClass) {
    const Hydrostatics hull{ShipDef{}};
    EXPECT_NEAR(hull.waterplane * 1.025 / 100, 66, 2);
    EXPECT_NEAR(hull.metacentre, 13, 0.5);
    EXPECT_NEAR(hull.trim_stiffness / kGravity / 1e5 / ShipDef{}.length_pp, 1000, 60);
}

// Barrass's rule for open water of 1.1 to 1.4 draughts is C_B V^2 / 100 (V in kn), for full ships: 0.14 m at
// 4 kn, 0.55 at 8. His general formula, which is used, has a seventh less in the middle of it.
TEST(Flotation, SquatIsBarrasssInShallowWaterAndLessInDeep) {
    const ShipDef ship;
    for (const double knots : {4.0, 8.0}) {
        const double rule = 0.86 * knots * knots / 100;
        EXPECT_NEAR(squat(ship, 1.1 * ship.draught, mps_from_knots(knots)), rule, 0.05 * rule);
        EXPECT_NEAR(squat(ship, 1.25 * ship.draught, mps_from_knots(-knots)), rule, 0.15 * rule);
    }
    EXPECT_LT(squat(ship, 4 * ship.draught, 4), 0.5 * squat(ship, 1.2 * ship.draught, 4));
    EXPECT_EQ(squat(ship, 14, 0.9), 0);
}

TEST(Flotation, ShipUnderWayHasSquatLessUnderHer) {
    const ShipDef ship;
    const EnvironmentDef sea = still(15);
    ShipDynamics dynamics(ship);
    ShipState state;
    state.surge = 4.5;
    for (int k = 0; k < 300 * 60; ++k)
        dynamics.step(sea, {.engine = 0.5}, {}, {}, kStep, state);
    const double sunk = squat(ship, 15, state.surge);
    EXPECT_GT(sunk, 0.3);
    const double clearance = keel_and_ground(ship, sea, state, kStep).clearance;
    EXPECT_NEAR(clearance, 15 - ship.draught - sunk, 0.02); // she slows down meanwhile
    EXPECT_NEAR(midships(state).z(), -sunk, 0.02);
    state.surge = 0.5;
    for (int k = 0; k < 300 * 120; ++k) // and comes to lie as she lay, to the bit
        dynamics.step(sea, {}, {}, {}, kStep, state);
    EXPECT_EQ(keel_and_ground(ship, sea, state, kStep).clearance, 15 - ship.draught);
}

// 0.1 m under her keel is enough for three knots, and not for five (0.08 and 0.22 m by the rule).
TEST(Flotation, SquatSetsHerOnTheGround) {
    const ShipDef ship;
    const EnvironmentDef sea = still(ship.draught + 0.1);
    for (const double knots : {3.0, 5.0}) {
        ShipDynamics dynamics(ship);
        ShipState state;
        state.surge = mps_from_knots(knots);
        double least = 1;
        for (int k = 0; k < 300 * 30; ++k) {
            dynamics.step(sea, {}, {}, {}, kStep, state);
            least = std::min(least, keel_and_ground(ship, sea, state, kStep).clearance);
        }
        EXPECT_EQ(least<0, knots> 4) << knots;
    }
}

// Flat ground takes what the water does no longer: tonnes per centimetre of lost draught. She stays upright.
TEST(Flotation, FallingTideSetsHerDownUpright) {
    const ShipDef ship;
    EnvironmentDef sea = still(13);
    const ShipState state = left_by_the_tide(ship, sea, -1.5);
    EXPECT_EQ(state.floats.heel, 0);
    const KeelAndGround ground = keel_and_ground(ship, sea, state, kStep);
    EXPECT_LT(ground.clearance, 0);
    EXPECT_GT(ground.clearance, -0.1);
    const double lost = ship.draught - 11.5 + ground.clearance; // m: what she is not in the ground
    EXPECT_NEAR(ground.lift.bearing / kGravity / 1e5, 66 * lost, 2);
    EXPECT_NEAR(state.floats.heave, lost, 1e-3);
}

// What touches first is the bilge on the high side. A moment balance about the keel, with the loss of
// metacentric height that the ground's share of her weight is (P KM / W: Derrett).
TEST(Flotation, GroundUnderOneBilgeHeelsHerAwayFromIt) {
    const ShipDef ship;
    const double slope = 0.06, bilge = 0.4 * ship.beam; // as her bottom is taken to be
    EnvironmentDef sea = athwart(ship.draught + bilge * slope + 0.5, slope);
    const ShipState state = left_by_the_tide(ship, sea, -0.7); // 0.2 m into the starboard bilge, upright
    const GroundLift ground = lift(ship, sea, state);
    EXPECT_LT(state.floats.heel, -0.005); // to port
    EXPECT_GT(state.floats.heel, -slope);
    const double weight = ship.displacement * kGravity, share = ground.bearing / weight;
    EXPECT_GT(share, 0);
    EXPECT_NEAR(-ground.heeling, 0 - -ground.bearing * bilge,
                1e-6 * ground.bearing * bilge); // that bilge alone
    const double left = ship.metacentric_height - share * Hydrostatics(ship).metacentre;
    EXPECT_NEAR(std::tan(-state.floats.heel), share * bilge / left, 0.02 * slope);
}

// With nearly no water left under her bilges she lies as the ground does.
TEST(Flotation, FallingTideLaysHerOnTheSlope) {
    const ShipDef ship;
    const double slope = 0.06;
    EnvironmentDef sea = athwart(14, slope);
    const ShipState state = left_by_the_tide(ship, sea, -4.5);
    EXPECT_GT(lift(ship, sea, state).bearing, 0.2 * ship.displacement * kGravity);
    // Either bilge is in the ground by some cm of the 26 m between them.
    EXPECT_NEAR(roll(state), -slope, 0.006);
    // And so do her hawse pipes: the starboard one stands higher.
    const double higher = hawse_position(ship, state, 1).z() - hawse_position(ship, state, -1).z();
    EXPECT_NEAR(higher, 2 * ship.hawse_outboard * std::sin(slope), 0.1);
}

// And floats again as she was.
TEST(Flotation, RisingTideRightsHer) {
    const ShipDef ship;
    EnvironmentDef sea = athwart(14, 0.06);
    ShipState state = left_by_the_tide(ship, sea, -4);
    ASSERT_LT(roll(state), -0.03);
    ShipDynamics dynamics(ship);
    for (int k = 0; k < 300 * 900; ++k) {
        sea.level = std::min(0.0, sea.level + 0.02 * kStep);
        state.level = sea.level;
        dynamics.step(sea, {}, {}, {}, kStep, state);
    }
    EXPECT_EQ(roll(state), 0);
    EXPECT_EQ(state.floats.heave, 0);
}

// A forefoot on a beach trims her by the stern: the ground's moment about midships over that to trim her,
// 1000 t m for a centimetre of her length.
TEST(Flotation, GroundUnderTheForefootTrimsHerByTheStern) {
    const ShipDef ship;
    EnvironmentDef sea = still(ship.draught + 1.585);
    GroundDef ground;
    ground.slope = std::atan(0.01), ground.slope_towards = std::numbers::pi;
    lay_ground(sea, ground); // 0.5 m under the forefoot
    const ShipState state = left_by_the_tide(ship, sea, -0.9);
    const GroundLift lifted = lift(ship, sea, state);
    EXPECT_GT(lifted.bearing, 0);
    EXPECT_NEAR(lifted.trimming, lifted.bearing * 0.5 * ship.length_pp, 1e-6 * lifted.trimming);
    const double trimmed = lifted.trimming / kGravity / 1e5 / 1000 / ship.length_pp;
    EXPECT_NEAR(pitch(state), trimmed, 0.06 * trimmed);
    EXPECT_EQ(roll(state), 0);
}

} // namespace windlass::physics
