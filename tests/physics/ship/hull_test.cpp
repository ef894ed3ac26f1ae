// The hull as the chain meets it: closed, clear of the lip, and solid.

#include "server/physics/ship/hull_surface.hpp"
#include "tests/physics/chain/winding.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

namespace windlass::physics {
namespace {

TEST(Hull, IsClosedAndFacesOutwards) {
    const ShipDef ship;
    const ObstacleMesh mesh = hull_mesh(ship, 0.28);
    for (const double x : {-110.0, 0.0, 60.0, 90.0, 105.0})
        EXPECT_NEAR(winding(mesh, {x, 0.3, -5}), 1, 1e-9) << x;
    for (const Vec3& outside :
         {Vec3(0, 17, 0), Vec3(114, 0, 0), Vec3(0, 0, -13), Vec3(105, 9, 5), Vec3(0, 0, 9)})
        EXPECT_NEAR(winding(mesh, outside), 0, 1e-9) << outside.transpose();
}

TEST(Hull, ClearsTheLipByALinksWidth) {
    const ShipDef ship;
    for (const double side : {-1.0, 1.0}) {
        const ObstacleMesh mesh = hull_mesh(ship, 0.28);
        const Vec3 lip(ship.hawse_forward, side * ship.hawse_outboard, ship.hawse_height);
        EXPECT_NEAR(winding(mesh, lip), 0, 1e-9);
        EXPECT_NEAR(winding(mesh, lip - Vec3(0, side * 0.30, 0)), 1, 1e-9);
    }
}

TEST(Hull, CableLeadingAcrossTheStemLiesAgainstTheBow) {
    // From the port lip the cable leads to starboard, ahead: it bears on the stem, none of it inside the
    // ship, and the hull takes a force the other way.
    const ShipDef ship;
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    const ObstacleMesh mesh = hull_mesh(ship, def.contact_diameter);
    const Vec3 lip(ship.hawse_forward, ship.hawse_outboard, ship.hawse_height);
    // Frame of the ship and of the world are the same here. Laid clear ahead of the stem, then hauled across.
    Vec3 foot(125, 8, 2);
    ChainRig rig(def, in_air(), foot, lip, (lip - foot).norm(), Foot::fixed);
    rig.environment.depth = 1e6;
    ContactSet set(256, 0);
    ObstacleContacts finder(4096);
    Vec3 load = Vec3::Zero();
    ChainTail tail;
    const double dt = 1.0 / 300;
    for (int k = 0; k < 300 * 30; ++k) {
        set.clear();
        finder.find(def, rig.state, dt, mesh, {}, {}, set);
        if (k % 3 == 0) { // what it passed over must hold nothing: a finder without a past finds the same
            ContactSet expected(256, 0);
            ObstacleContacts(rig.state.links).find(def, rig.state, dt, mesh, {}, {}, expected);
            ASSERT_EQ(expected.node_contacts().size(), set.node_contacts().size()) << k;
            for (std::size_t c = 0; c < expected.node_contacts().size(); ++c) {
                ASSERT_EQ(expected.node_contacts()[c].node, set.node_contacts()[c].node) << k;
                ASSERT_EQ(expected.node_contacts()[c].penetration, set.node_contacts()[c].penetration) << k;
            }
        }
        const Vec3 to = foot + Vec3(0, -std::min(30.0, 1.5 * k * dt), 0); // the foot goes over to starboard
        const Vec3 way = to - rig.state.position.at(0);
        tail.velocity = tail.velocity_before = way / dt;
        rig.state.top_length = std::max(0.3, rig.state.top_length);
        rigs::step_chain(rig.solver, rig.state, rig.environment, dt, tail, rig.locked, lip, nullptr, &set);
        // Cable is given as the foot goes, at the lip's link.
        const double wanted = (to - lip).norm() * 1.02;
        rig.state.top_length += std::clamp(wanted - chain_length(def, rig.state), -0.01, 0.01);
        load = set.settle(rig.state).impulse / dt;
        for (int i = 1; i < rig.state.links; ++i)
            ASSERT_LT(winding(mesh, rig.state.position.at(i)), 0.5) << k << " " << i;
    }
    EXPECT_GT(set.node_contacts().size() + set.wraps().all().size(), 0u);
    EXPECT_GT(load.x(), 1e3); // the stem holds it ahead
    EXPECT_TRUE(std::isfinite(rig.top_tension()));
}

} // namespace
} // namespace windlass::physics
