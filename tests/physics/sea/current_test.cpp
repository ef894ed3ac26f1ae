// The current over depth: interpolation, and what it does to chain and ship.

#include "server/physics/sea/current.hpp"
#include "server/physics/ship/ship_dynamics.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::physics {
namespace {

EnvironmentDef tide_under_wind_drift(double depth) {
    EnvironmentDef sea = still_water(depth);
    sea.current_speed = 2;
    sea.current_towards = 0.5 * std::numbers::pi; // east
    sea.current_profile = {{0, 1, 0}, {20, 0.5, 0}, {40, 0.5, std::numbers::pi}};
    return sea;
}

TEST(Current, RunsAlongStraightLinesBetweenItsLayers) {
    const EnvironmentDef sea = tide_under_wind_drift(60);
    for (const auto& [z, east] : {std::pair{1.0, 2.0},
                                  {0.0, 2.0},
                                  {-10.0, 1.5},
                                  {-20.0, 1.0},
                                  {-30.0, 0.0},
                                  {-40.0, -1.0},
                                  {-55.0, -1.0}}) {
        EXPECT_NEAR(current_at(sea, z).x(), east, 1e-12) << z;
        EXPECT_NEAR(current_at(sea, z).y(), 0, 1e-12) << z;
    }
    EXPECT_NEAR(mean_current(sea, 10).x(), 1.75, 1e-12);
}

TEST(Current, ProfileOfEqualLayersIsTheUniformCurrent) {
    // Bit for bit the other path through the step: the same force to rounding.
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    EnvironmentDef uniform = still_water(60);
    uniform.current_speed = 1.5;
    EnvironmentDef layered = uniform;
    layered.current_profile = {{0, 1, 0}, {60, 1, 0}};
    ChainRig a(def, uniform, {0, 0, -50}, {0, 0, 0}, 50, Foot::hanging, 1000);
    ChainRig b(def, layered, {0, 0, -50}, {0, 0, 0}, 50, Foot::hanging, 1000);
    a.run(20, 1.0 / 300);
    b.run(20, 1.0 / 300);
    double apart = 0, moved = 0;
    for (int i = 0; i <= a.state.links; ++i) {
        apart = std::max(apart, (a.state.position.at(i) - b.state.position.at(i)).norm());
        moved = std::max(moved, a.state.position.at(i).head<2>().norm());
    }
    EXPECT_GT(moved, 0.5);
    EXPECT_LT(apart, 1e-9);
}

TEST(Current, SidePullOnAHangingChainIsTheIntegralOfItsDrag) {
    // A heavy foot keeps the chain nearly plumb: at rest the hawse and the foot carry the drag of the layers,
    // 1/2 rho C d u|u| over depth, against it; about the hawse they balance it.
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    def.node_spacing = 0.25;
    EnvironmentDef sea = still_water(60);
    sea.current_speed = 2;
    sea.current_towards = 0.5 * std::numbers::pi;
    sea.current_profile = {{0, 1, 0}, {20, 1, 0}, {20.001, 0, 0}}; // the upper 20 m only
    ChainRig rig(def, sea, {0, 0, -50}, {0, 0, 0}, 50, Foot::fixed);
    rig.state.top_length += 0.05;
    rig.run(60, 1.0 / 600);
    const double drag = 0.5 * sea.water_density * def.drag_normal * def.diameter * 4 * 20;
    const double side = (rig.last.hawse_impulse.x() + rig.last.tail_impulse.x()) * 600;
    // Half a link at the surface hangs on the hawse itself, and the layer's edge falls between nodes: 0.6 %
    // each; and the chain hangs a little aslant.
    EXPECT_NEAR(side / drag, 1, 0.02);
}

TEST(Current, ShipDriftsWithItsMeanOverTheDraught) {
    ShipDef def;
    ShipDynamics dynamics(def);
    EnvironmentDef sea = still_water(60);
    sea.current_speed = 1;
    sea.current_towards = 0; // north
    sea.current_profile = {{0, 1, 0}, {2 * def.draught, 0, 0}};
    for (const double speed : {0.5, 0.75, 1.0}) { // ahead, to the north; she feels no wind but her own
        ShipState ship;
        ship.surge = speed;
        for (int k = 0; k < 600; ++k)
            dynamics.step(sea, {}, {}, {}, 0.1, ship);
        if (speed == 0.75)
            EXPECT_NEAR(ship.surge, speed, 3e-4); // the air takes 2e-4 m/s in this minute
        else
            EXPECT_GT((ship.surge - speed) * (0.75 - speed), 1e-4 * std::abs(0.75 - speed)) << speed;
    }
}

} // namespace
} // namespace windlass::physics
