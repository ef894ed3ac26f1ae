// What the elements ask of a ship at rest: that which, held against, leaves her at rest.

#include "server/physics/ship/ship_dynamics.hpp"

#include <gtest/gtest.h>

namespace windlass::physics {
namespace {

TEST(ForceAtRest, HeldAgainstLeavesHerWhereSheIs) {
    const ShipDef def;
    EnvironmentDef sea;
    sea.wind_speed = 20, sea.wind_from = 1;
    sea.current_speed = 1.5, sea.current_towards = 2;
    const Helm helm{.engine = -0.6, .rudder = 0.2, .bow_thruster = 0.5, .stern_thruster = -0.1};
    ShipState ship;
    ship.heading = 0.3, ship.surge = 2, ship.sway = -1, ship.engine = -0.6, ship.rudder = 0.2;
    ship.waves.drift_ahead = -4e4, ship.waves.drift_abeam = 9e4;
    ShipDynamics dynamics(def);
    const Vec3 force = dynamics.force_at_rest(sea, helm, {}, ship);
    EXPECT_GT(force.norm(), 3e5);

    ship.surge = ship.sway = 0;
    ShipState free = ship;
    constexpr double kStep = 0.01; // s
    for (int k = 0; k < 20; ++k) { // so short that her turning does not count
        dynamics.step(sea, helm, {}, {.force = -force}, kStep, ship);
        dynamics.step(sea, helm, {}, {}, kStep, free);
    }
    EXPECT_LT(std::hypot(ship.surge, ship.sway), 2e-3 * std::hypot(free.surge, free.sway));
}

TEST(ForceAtRest, IsNothingInStillAirAndWater) {
    EnvironmentDef sea;
    sea.wind_speed = sea.current_speed = 0;
    ShipState ship;
    ship.surge = 3, ship.yaw_rate = 0.01;
    EXPECT_LT(ShipDynamics(ShipDef{}).force_at_rest(sea, {}, {}, ship).norm(),
              1); // of hundreds of kilonewtons
}

} // namespace
} // namespace windlass::physics
