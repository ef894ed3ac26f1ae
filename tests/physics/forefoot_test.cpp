// A ship that forges ahead over her anchor: the cable grows aft, under her forefoot and along her bottom.

#include "server/physics/hull_surface.hpp"
#include "tests/physics/tackle_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace windlass::physics {
namespace {

constexpr double kDepth = 25, kCable = 80; // m
constexpr double kUpAndDown = 31;          // m, from lip to bed

/// What the ship felt of her cable while she went ahead.
struct Felt {
    double swing = 0;    ///< N, largest within half a second, at the lip
    int lies_on_her = 0; ///< steps in which the cable lay on her
    int left_over = 0;   ///< steps that the direct solver could not do
};

/// Cable laid out astern and to port of her (m) and slack brought down on it again: she goes ahead at so many
/// m/s until the anchor drags after her.
Felt forge_ahead(double speed, double to_port) {
    TackleSetup setup;
    setup.chain.node_spacing = 0.84; // as in the exercises
    const ShipDef ship;
    const ObstacleMesh mesh = hull_mesh(ship, setup.chain.contact_diameter);
    TackleRig rig(setup, quiet_water(kDepth));
    rig.hull = {&mesh, {}, {}};
    rig.lip_on_board = {ship.hawse_forward, ship.hawse_outboard, ship.hawse_height};

    const Vec3 start = rig.lip;
    rig.levers.brake = 0;
    rig.run(5);
    rig.lip_velocity = 0.5 * Vec3(kUpAndDown - kCable, to_port, 0).normalized();
    const auto laid = [&] {
        rig.levers.brake = rig.windlass().cable_out > kUpAndDown + 2 + (start - rig.lip).norm() ? 0.15 : 0;
        return rig.windlass().cable_out > kCable;
    };
    EXPECT_TRUE(rig.run_until(laid, 200));
    rig.levers.brake = 1;
    rig.run(10);
    rig.lip_velocity.setZero();
    rig.run(10);

    rig.lip_velocity = {speed, 0, 0};
    constexpr int kWindow = 150; // ticks
    Felt felt;
    for (int window = 0; window < 2 * 125 / speed; ++window) { // 125 m
        double least = 1e300, most = 0;
        for (int k = 0; k < kWindow; ++k) {
            rig.step();
            const double load = rig.tackle.pull_on_ship().norm();
            least = std::min(least, load), most = std::max(most, load);
            felt.lies_on_her += rig.tackle.hull_load().borne > 0 ? 1 : 0;
            felt.left_over += rig.tackle.last_step().implicit ? 1 : 0;
        }
        felt.swing = std::max(felt.swing, most - least);
    }
    return felt;
}

/// N, by which the load at the lip rises where cable that moves at the ship's speed (m/s) is stopped all at
/// once and the gypsy stands: mu c v, c = sqrt(EA / mu), and the same reflected. What slack that comes taut
/// somewhere may do, and no more.
double snatch(double speed) {
    const ChainDef chain;
    return 2 * std::sqrt(chain.stiffness * chain.mass_per_metre) * speed;
}

/// 65 and 84 kN of 286 and 143. Until links that lay round a corner of her bottom's rim were kept on it, and
/// steps were solved in which many nodes on the bed began or ceased to slide, 821 and 575 kN.
TEST(Forefoot, CableThatGrowsAftUnderHerDoesNotJerk) {
    struct Case {
        double speed, to_port;
    };
    for (const Case& c : {Case{0.5, 5}, Case{0.25, -12}}) {
        const Felt felt = forge_ahead(c.speed, c.to_port);
        EXPECT_LT(felt.swing, snatch(c.speed)) << c.speed;
        EXPECT_GT(felt.lies_on_her, 1000);
        EXPECT_EQ(felt.left_over, 0) << c.speed;
    }
}

} // namespace
} // namespace windlass::physics
