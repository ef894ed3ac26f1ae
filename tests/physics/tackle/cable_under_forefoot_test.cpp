// A ship that forges ahead over her anchor: the cable grows aft, under her forefoot and along her bottom.

#include "rigs/tackle_rig.hpp"
#include "server/physics/ship/hull_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace windlass::physics {
namespace {

constexpr double kForefootDepth = 25, kCable = 80; // m
constexpr double kLipToBed = 31;                   // m, from lip to bed

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
    setup.chain.node_spacing = 1.25; // as in the exercises
    const ShipDef ship;
    const ObstacleMesh mesh = hull_mesh(ship, setup.chain.contact_diameter);
    rigs::TackleRig rig(setup, rigs::quiet_water(kForefootDepth));
    rig.hull = {&mesh, {}, {}};
    rig.lip_on_board = {ship.hawse_forward, ship.hawse_outboard, ship.hawse_height};

    const Vec3 start = rig.lip;
    rig.levers.brake = 0;
    rig.run(5);
    rig.lip_velocity = 0.5 * Vec3(kLipToBed - kCable, to_port, 0).normalized();
    const auto laid = [&] {
        rig.grip(rig.windlass().cable_out > kLipToBed + 2 + (start - rig.lip).norm() ? 0.15 : 0);
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
        double min = 1e300, max = 0;
        for (int k = 0; k < kWindow; ++k) {
            rig.step();
            const double load = rig.tackle.pull_on_ship().norm();
            min = std::min(min, load), max = std::max(max, load);
            felt.lies_on_her += rig.tackle.hull_load().borne > 0 ? 1 : 0;
            felt.left_over += rig.tackle.last_step().implicit ? 1 : 0;
        }
        felt.swing = std::max(felt.swing, max - min);
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

/// 47 and 38 kN of 286 and 143 (65 and 84 with links of 0.84 m). Until links that lay round a corner of her
/// bottom's rim were kept on it, and steps were solved in which many nodes on the bed began or ceased to
/// slide, 821 and 575 kN.
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

/// m, corners of the flat bottom's rim in a box, from forward aft.
std::vector<Vec3> bottom_rim(const ObstacleMesh& mesh, const Vec3& low, const Vec3& high) {
    std::vector<int> found(256);
    found.resize(mesh.near(low, high, found));
    std::vector<Vec3> rim;
    for (const int t : found) {
        if (mesh.triangle(t).normal.z() > -0.99) continue;
        for (const Vec3& corner : mesh.triangle(t).corner)
            if ((corner.array() >= low.array()).all() && (corner.array() <= high.array()).all())
                rim.push_back(corner);
    }
    std::sort(rim.begin(), rim.end(), [](const Vec3& a, const Vec3& b) { return a.x() > b.x(); });
    rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    return rim;
}

/// One link from under her bottom to outside her bow's plating, round the rim between them, drawn along it
/// past one of its corners. Between two edges it lay round neither, and was straight within a step.
TEST(Forefoot, LinkStaysRoundTheRimPastItsCorners) {
    const ShipDef ship;
    ChainDef def;
    def.node_spacing = 0.84;
    const ObstacleMesh mesh = hull_mesh(ship, def.contact_diameter);
    const std::vector<Vec3> rim = bottom_rim(mesh, {90, 0, -ship.draught}, {105, 20, -ship.draught});
    ASSERT_GE(rim.size(), 3U);
    const Vec3 &before = rim[0], &corner = rim[1], &after = rim[2];
    const Vec3 below(-0.11, 0.06, -0.455), above(0.18, 0.04, 0.255); // m, from the rim
    ObstacleContacts finder(4);
    ContactSet set(16, 0);
    double length = 0;
    for (int mm = -200; mm < 200; ++mm) {
        const double past = 1e-3 * mm;
        const Vec3 at = corner + past * (past < 0 ? corner - before : after - corner).normalized();
        const ChainState chain = straight_chain(def, at + below, at + above, def.node_spacing, 4);
        set.clear();
        finder.find(def, chain, 1e-3, mesh, {}, {}, set, true);
        ASSERT_EQ(set.wraps().size(), 1) << past;
        const double was = length;
        length = way_round(set.wraps().all()[0].edge, at + below, at + above).length;
        if (was > 0) { // a tenth of a millimetre is a kilonewton in 60 m of cable
            EXPECT_NEAR(length, was, 1e-4) << past;
        }
    }
}

} // namespace
} // namespace windlass::physics
