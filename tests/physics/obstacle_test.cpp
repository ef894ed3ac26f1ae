// Chain against solid bodies: nothing passes through, a lip carries what it should, friction round it.

#include "server/physics/obstacle_contact.hpp"
#include "tests/physics/chain_rig.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace windlass::physics {
namespace {

const ChainDef kChain = stud_link_chain(0.078, Grade::k3, 330);

/// A rig with a body that its chain may meet.
struct BodyRig {
    ChainRig rig;
    ObstacleMesh mesh;
    ContactMaterial material;
    BodyMotion body{};
    ContactSet set{512, 0};
    ObstacleContacts finder{4096};
    ContactLoad load{};

    void step(double dt) {
        set.clear();
        finder.find(rig.def, rig.state, dt, mesh, body, material, set);
        rig.step(dt, &set);
        load = set.settle(rig.state);
        body.position += dt * body.velocity;
    }
};

/// Chain that lies on a box from its far end to a lip and hangs over it: the box reaches from x = -30 to 0,
/// its top at z = 0. The top of the chain is held at hawse, the foot hangs free with a mass (kg) in it.
BodyRig over_lip(double friction, double mass, double overhang, double spacing = 1) {
    ChainDef def = kChain;
    def.node_spacing = spacing;
    const double half = 0.5 * def.contact_diameter;
    const Vec3 top(-12, 0, half);
    const double length = 12 + overhang;
    BodyRig rig{ChainRig(def, in_air(), {overhang, 0, half}, top, length, Foot::hanging, mass),
                box_mesh({-30, -5, -40}, {0, 5, 0}),
                {.friction = friction}};
    // From the lip on it goes down.
    ChainState& chain = rig.rig.state;
    for (int i = 0; i <= chain.links; ++i) {
        const double beyond = chain.position.x[i];
        if (beyond <= 0) continue;
        const double round = std::min(beyond, 0.5 * std::numbers::pi * half) / half; // rad
        chain.position.set(i, {half * std::sin(round), 0, half * std::cos(round) - (beyond - round * half)});
    }
    return rig;
}

/// Heaves a load of 20 t up over the edge at 0.2 m/s: the pull above the edge over the pull below it, mean
/// over a few links.
double heaving_ratio(double friction, double spacing) {
    BodyRig rig = over_lip(friction, 20000, 20, spacing);
    double sum = 0, below = 0;
    for (int k = 0; k < 300 * 24; ++k) {
        rig.rig.hawse.x() -= 0.2 / 300;
        rig.step(1.0 / 300);
        if (k < 300 * 9) continue;
        const ChainState& chain = rig.rig.state;
        const double lying = -rig.rig.hawse.x(), weight = weight_in_air(rig.rig.def);
        sum += rig.rig.top_tension() - friction * weight * lying; // what lies on the box rubs, too
        below += 20000 * kGravity + weight * (-chain.position.z[0]);
    }
    return sum / below;
}

TEST(Lip, LoadRatioLiesBetweenFrictionlessAndTheCapstanEquation) {
    const double friction = 0.3, capstan = std::exp(friction * 0.5 * std::numbers::pi);
    for (const double spacing : {0.5, 1.0}) {
        // A link over the edge is a lever: it gives and takes in turn, 3 % in the mean of a few links.
        EXPECT_NEAR(heaving_ratio(0, spacing), 1, 0.03) << spacing;
        const double ratio = heaving_ratio(friction, spacing);
        EXPECT_GT(ratio, 1.2) << spacing;
        EXPECT_LT(ratio, 1.03 * capstan) << spacing;
    }
}

TEST(Tunnelling, NothingPassesAtTenMetresASecond) {
    // Loose chain thrown at a block of 1 m from all sides, its top dragged on: no node goes through. Half a
    // link's width is 0.14 m; the jerk presses some nodes deeper for a moment, none as deep as 0.3 m.
    for (const double dt : {1.0 / 120, 1.0 / 300}) {
        for (unsigned seed = 1; seed <= 40; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> pick(-1, 1);
            const Vec3 aim = Vec3(pick(random), pick(random), pick(random)).normalized();
            const Vec3 along = aim.unitOrthogonal();
            const Vec3 start = -3 * aim + 0.3 * Vec3(pick(random), pick(random), pick(random));
            BodyRig rig{
                ChainRig(kChain, in_air(), start - 4 * along, start + 4 * along, 8, Foot::hanging, 100),
                box_mesh(Vec3::Constant(-0.5), Vec3::Constant(0.5)),
                {}};
            rig.rig.tail_weight = 0;
            for (int i = 0; i <= 8; ++i)
                rig.rig.state.velocity.set(i, 10 * aim);
            for (int k = 0; k < 0.6 / dt; ++k) {
                rig.rig.hawse += 10 * dt * aim;
                rig.step(dt);
                for (int i = 1; i < 8; ++i)
                    ASSERT_GT(rig.rig.state.position.at(i).cwiseAbs().maxCoeff(), 0.2)
                        << "seed " << seed << " node " << i << " step " << dt;
            }
        }
    }
}

TEST(Tunnelling, SheetOfTrianglesStopsANodeFromInFront) {
    // Two triangles of no thickness, hit at 10 m/s by nodes that cross it within one step of 1/30 s.
    const ObstacleMesh sheet({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2}, {0, 2, 3}});
    for (int trial = 0; trial < 10; ++trial) {
        const double height = 0.16 + 0.033 * trial;
        ChainRig chain(kChain, in_air(), {-3, 0.3, height}, {3, 0.3, height}, 6.4, Foot::hanging, 100);
        chain.environment.depth = 1e6;
        ContactSet set(32, 0);
        ObstacleContacts finder(4096);
        for (int i = 0; i <= 6; ++i)
            chain.state.velocity.set(i, {0, 0, -10});
        for (int k = 0; k < 10; ++k) {
            set.clear();
            finder.find(kChain, chain.state, 1.0 / 30, sheet, {}, {}, set);
            ChainTail tail;
            chain.last = chain.solver.step(chain.state, chain.environment, 1.0 / 30, tail, chain.locked,
                                           chain.hawse, nullptr, &set);
            for (int i = 1; i < 6; ++i)
                ASSERT_GT(chain.state.position.z[i], 0) << trial << " " << k;
        }
    }
}

} // namespace
} // namespace windlass::physics
