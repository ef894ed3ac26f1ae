// A keel that comes to the ground.

#include "server/physics/base/units.hpp"
#include "server/physics/sea/ground.hpp"
#include "server/physics/ship/grounding.hpp"
#include "server/physics/ship/ship_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::physics {
namespace {

/// A beach that rises to the north by one in a hundred, 14 m deep at the world's origin.
EnvironmentDef beach() {
    EnvironmentDef sea;
    sea.depth = 14, sea.wind_speed = sea.current_speed = 0;
    GroundDef ground;
    ground.slope = std::atan(0.01), ground.slope_towards = std::numbers::pi;
    lay_ground(sea, ground);
    return sea;
}

TEST(Grounding, AShipThatFloatsFeelsNothing) {
    const ShipDef ship;
    EnvironmentDef sea;
    sea.depth = 25;
    const KeelAndGround level = keel_and_ground(ship, sea, {}, 0.01);
    EXPECT_EQ(level.clearance, 25 - ship.draught);
    EXPECT_EQ(level.depth, 25);
    EXPECT_EQ(level.lift.bearing, 0);
    const KeelAndGround aslope = keel_and_ground(ship, beach(), {}, 0.01); // heading north
    EXPECT_NEAR(aslope.clearance, 14 - 0.01 * 0.5 * ship.length_pp - ship.draught, 1e-9);
    EXPECT_NEAR(aslope.depth, 14, 1e-9);
    EXPECT_EQ(aslope.force.x, 0);
}

TEST(Grounding, ByTheSternTouchesThereFirst) {
    ShipDef ship;
    ship.trim = 3;
    EnvironmentDef sea;
    sea.depth = ship.draught + 1;
    const KeelAndGround found = keel_and_ground(ship, sea, {}, 0.01);
    EXPECT_NEAR(found.clearance, -0.5, 1e-9);
    EXPECT_LT(found.lift.trimming, 0); // the ground lifts her stern
    sea.depth = ship.draught + 1.6;
    EXPECT_NEAR(keel_and_ground(ship, sea, {}, 0.01).clearance, 0.1, 1e-9);
}

// She runs on with her way until ground and friction have it: no farther than the forefoot alone, which
// bears ever more as she drives up, could take; and she lies there.
TEST(Grounding, ABeachTakesHerWayAndKeepsHer) {
    const ShipDef ship;
    const EnvironmentDef sea = beach();
    ShipDynamics dynamics(ship);
    ShipState state;
    state.surge = 2;
    constexpr double kStep = 1.0 / 300;
    double way = 0, before = state.surge, bearing = 0;
    for (int k = 0; k < 300 * 600; ++k) {
        dynamics.step(sea, {}, {}, {}, kStep, state);
        const KeelAndGround now = keel_and_ground(ship, sea, state, kStep);
        if (now.clearance < 0) {
            EXPECT_LE(state.surge, before + 1e-9); // nothing throws her back or on
            way += kStep * state.surge;
            bearing = now.lift.bearing;
        }
        before = state.surge;
    }
    EXPECT_NEAR(ship_velocity(state).norm(), 0, 0.02);
    EXPECT_GT(bearing, 0);
    EXPECT_GT(way, 5);
    // 0.41 of the bearing, which grows with the square of the way: kinetic energy = 0.41 K 0.01 way^2 / 2, K
    // that of a fifth of her waterplane at first.
    const HullCoefficients hull = in_depth(hull_coefficients(ship), ship.draught); // water goes with her
    const double energy = 0.5 * (hull.mass + hull.added_surge) * 4;
    const double stiffness = kSeaWaterDensity * kGravity * 0.85 * ship.length_pp * ship.beam / 5;
    EXPECT_LT(way, std::sqrt(2 * energy / (0.41 * stiffness * 0.01)));
    EXPECT_LT(bearing, ship.displacement * kGravity);
}

// Steel on sand at 0.4: 550 kN of thrust astern move what bears up to 1.4 MN, 12 cm of her forefoot, and not
// what bears 3.6 MN.
TEST(Grounding, FullAsternPullsHerOffWhereSheTouchesLightly) {
    const ShipDef ship;
    const EnvironmentDef sea = beach();
    const double touches = 100 * (14 - ship.draught) - 0.5 * ship.length_pp; // m north, midships
    for (const double sunk : {0.05, 0.30}) {
        ShipDynamics dynamics(ship);
        ShipState state;
        state.y = touches + 100 * sunk;
        ASSERT_NEAR(keel_and_ground(ship, sea, state, 0.01).clearance, -sunk, 1e-9);
        for (int k = 0; k < 300 * 300; ++k)
            dynamics.step(sea, {.engine = -1}, {}, {}, 1.0 / 300, state);
        EXPECT_EQ(keel_and_ground(ship, sea, state, 0.01).clearance > 0, sunk < 0.12) << sunk;
    }
}

} // namespace
} // namespace windlass::physics
