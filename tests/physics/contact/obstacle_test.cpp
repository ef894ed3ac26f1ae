// Chain against solid bodies: nothing passes through, a lip carries what it should, friction round it.

#include "server/physics/contact/obstacle_contact.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace windlass::physics {
namespace {

const ChainDef kCable = stud_link_chain(0.078, Grade::k3, 330);

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
    ChainDef def = kCable;
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

/// Pull above the edge over the pull below it, of a load of 20 t. What lies on the box rubs, too: that is not
/// the edge's.
double ratio_over_edge(const BodyRig& rig, double friction, double heaving) {
    const ChainState& chain = rig.rig.state;
    const double weight = weight_in_air(rig.rig.def), lying = -rig.rig.hawse.x();
    return (rig.rig.top_tension() - heaving * friction * weight * lying) /
           (20000 * kGravity + weight * -chain.position.z[0]);
}

TEST(Lip, CarriesTheWeightBelowItWhereverTheLinkLies) {
    // Without friction, at rest. Half a link's weight lumped above or below the edge is 0.3 % of these 20 t
    // for each metre of link.
    for (const double spacing : {0.5, 1.0, 2.0}) {
        for (const double overhang : {5.0, 5.2, 5.5, 5.77}) {
            BodyRig rig = over_lip(0, 20000, overhang, spacing);
            for (int k = 0; k < 300 * 20; ++k) {
                rig.step(1.0 / 300);
                for (int i = 0; i <= rig.rig.state.links; ++i) // brought to rest
                    rig.rig.state.velocity.set(i, 0.99 * rig.rig.state.velocity.at(i));
            }
            EXPECT_NEAR(ratio_over_edge(rig, 0, 0), 1, 0.01) << spacing << " " << overhang; // the bar
            // The body bears across what turns the chain.
            EXPECT_NEAR(rig.load.impulse.x() * 300 / rig.rig.top_tension(), 1, 0.01);
        }
    }
}

TEST(Lip, LoadFollowsTheCapstanEquationAtEachInstantWhileChainRuns) {
    // 20 t heaved up and lowered over an edge of 90 degrees at 0.2 m/s, while nodes come to it, go round it
    // and leave it.
    for (const double friction : {0.0, 0.3}) {
        for (const double heaving : {1.0, -1.0}) {
            for (const double spacing : {0.5, 1.0, 2.0}) {
                BodyRig rig = over_lip(friction, 20000, 20, spacing);
                const double capstan = std::exp(heaving * friction * 0.5 * std::numbers::pi);
                double min = 1e9, max = 0, sum = 0;
                int count = 0;
                for (int k = 0; k < 300 * 24; ++k) {
                    rig.rig.hawse.x() -= heaving * 0.2 / 300;
                    rig.step(1.0 / 300);
                    if (k < 300 * 9) continue;
                    const double ratio = ratio_over_edge(rig, friction, heaving) / capstan;
                    min = std::min(min, ratio), max = std::max(max, ratio);
                    sum += ratio, ++count;
                }
                EXPECT_GT(min, 0.97) << friction << " " << heaving << " " << spacing; // the bar
                EXPECT_LT(max, 1.03) << friction << " " << heaving << " " << spacing;
                EXPECT_NEAR(sum / count, 1, 0.007) << friction << " " << heaving << " " << spacing;
            }
        }
    }
}

TEST(Lip, NothingRingsOnInChainThatCreepsOverTheEdge) {
    // Hauled in and lowered over the edge at 0.03 m/s in steps of a calm cable, every other node drawn along
    // by a millimetre: two seconds later hardly anything turns round from step to step. It was 0.04 of a
    // link's tension heaving, and without end lowering, while no step took what it could not resolve.
    for (const double heaving : {1.0, -1.0}) {
        BodyRig rig = over_lip(0.3, 9000, 16);
        ChainState& chain = rig.rig.state;
        const double dt = 0.01;
        const auto haul =
            [&](double seconds) { // share of a link's tension that turns round in a step, at most
                double rattle = 0;
                std::vector<double> last = chain.tension, before = chain.tension;
                for (int k = 0; k < seconds / dt; ++k) {
                    rig.rig.hawse.x() -= heaving * 0.03 * dt;
                    rig.step(dt);
                    for (int i = 0; i < chain.links; ++i) {
                        const double turned = std::abs(chain.tension[i] - 2 * last[i] + before[i]) / 4;
                        if (k > 2) rattle = std::max(rattle, turned / std::max(chain.tension[i], 1e3));
                        before[i] = last[i], last[i] = chain.tension[i];
                    }
                }
                return rattle;
            };
        haul(6);
        for (int i = 1; i < chain.links; i += 2)
            (chain.position.z[i] < 0 ? chain.position.z[i] : chain.position.x[i]) -= 1e-3;
        haul(2);
        EXPECT_LT(haul(2), 0.01) << heaving;
    }
}

TEST(Lip, ALinkStretchedOverTheEdgeKeepsNoMoreThanFrictionHolds) {
    // Both ends of the link at the edge are drawn 3 mm away from it, as by a jerk, which is some 4 MN; their
    // neighbours are slack then. The edge holds what the capstan equation has, half of it on either side of
    // the link: in the mean of what rings on, e^(0.3 pi/4) over its neighbours. A damper that held either end
    // by the mean of their speeds, which is none, kept MN for seconds, and parted a cable led round a stem.
    BodyRig rig = over_lip(0.3, 20000, 8.5);
    ChainState& chain = rig.rig.state;
    const auto rest = [&](int steps) {
        for (int k = 0; k < steps; ++k) {
            rig.step(1.0 / 300);
            for (int i = 0; i <= chain.links; ++i)
                chain.velocity.set(i, 0.99 * chain.velocity.at(i));
        }
    };
    rest(300 * 10);
    int link = 0;
    while (chain.position.z[link + 1] < 0)
        ++link;
    ASSERT_LT(chain.position.x[link + 1], 0); // one end below the edge, one on top
    chain.position.z[link] -= 3e-3, chain.position.x[link + 1] -= 3e-3;
    double at_edge = 0, above = 0, below = 0;
    for (int k = 0; k < 300; ++k) {
        rest(1);
        at_edge += chain.tension[link], below += chain.tension[link - 1], above += chain.tension[link + 1];
    }
    EXPECT_LT(at_edge, 1.1 * std::exp(0.3 * 0.25 * std::numbers::pi) * std::max(above, below));
}

TEST(Lip, FrictionOnTheEdgeHoldsALoadThatTheHawseGivesWayTo) {
    // After heaving, the hawse gives 1 mm: the pull above falls by a third, less than friction can hold
    // (1 - e^(-2 x 0.3 pi/2) = 61 %), and the load stays where it is.
    BodyRig rig = over_lip(0.3, 20000, 8);
    for (int k = 0; k < 300 * 12; ++k) { // heave, then stand
        if (k < 300 * 6) rig.rig.hawse.x() -= 0.1 / 300;
        rig.step(1.0 / 300);
    }
    const double height = rig.rig.state.position.z[0], taut = rig.rig.top_tension();
    rig.rig.hawse.x() += 1e-3;
    for (int k = 0; k < 300 * 10; ++k)
        rig.step(1.0 / 300);
    EXPECT_LT(rig.rig.top_tension(), 0.95 * taut);
    EXPECT_GT(rig.rig.state.position.z[0], height - 1e-3);
    EXPECT_NEAR(rig.rig.state.velocity.z[0], 0, 2e-4); // it creeps
}

TEST(Lip, BooksTheWorkOfFriction) {
    // What the hawse puts in, the load's height takes out, and the rest is booked: in contact and in the
    // links.
    BodyRig rig = over_lip(0.3, 20000, 20);
    ChainState& chain = rig.rig.state;
    double given = 0, taken = 0;
    const auto heave = [&](int steps) {
        for (int k = 0; k < steps; ++k) {
            rig.rig.hawse.x() -= 0.2 / 300;
            rig.step(1.0 / 300);
            given += 0.2 * rig.rig.last.hawse_impulse.x(); // the chain pulls on, the lip goes back
            taken += rig.load.work;
        }
    };
    const auto energy = [&] {
        return chain_energy(rig.rig.def, rig.rig.environment, chain).total() +
               0.5 * rig.rig.tail_mass * chain.velocity.at(0).squaredNorm() +
               rig.rig.tail_weight * chain.position.z[0];
    };
    heave(300 * 9);
    const double before = energy(), internal = rig.rig.ledger.internal;
    given = taken = 0;
    heave(300 * 10);
    const double booked = taken + rig.rig.ledger.internal - internal;
    EXPECT_GT(booked, 0.2 * given);
    EXPECT_NEAR((energy() - before + booked) / given, 1, 0.01);
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
                ChainRig(kCable, in_air(), start - 4 * along, start + 4 * along, 8, Foot::hanging, 100),
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
        ChainRig chain(kCable, in_air(), {-3, 0.3, height}, {3, 0.3, height}, 6.4, Foot::hanging, 100);
        chain.environment.depth = 1e6;
        ContactSet set(32, 0);
        ObstacleContacts finder(4096);
        for (int i = 0; i <= 6; ++i)
            chain.state.velocity.set(i, {0, 0, -10});
        for (int k = 0; k < 10; ++k) {
            set.clear();
            finder.find(kCable, chain.state, 1.0 / 30, sheet, {}, {}, set);
            ChainTail tail;
            chain.last = rigs::step_chain(chain.solver, chain.state, chain.environment, 1.0 / 30, tail,
                                          chain.locked, chain.hawse, nullptr, &set);
            for (int i = 1; i < 6; ++i)
                ASSERT_GT(chain.state.position.z[i], 0) << trial << " " << k;
        }
    }
}

} // namespace
} // namespace windlass::physics
