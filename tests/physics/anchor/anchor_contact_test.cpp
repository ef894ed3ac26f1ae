// Chain against its own anchor: it lies on it, and neither makes momentum nor energy.

#include "rigs/tackle_rig.hpp"
#include "server/physics/anchor/anchor_contact.hpp"
#include "server/physics/base/closest.hpp"
#include "tests/physics/exercise_step.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <random>

namespace windlass::physics {
namespace {

/// A cable with its anchor in air, far above the ground, its upper end held.
struct HangingAnchor {
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    EnvironmentDef environment = in_air();
    ChainState chain;
    ChainSolver solver;
    Anchor anchor;
    ContactSet set{64, 1024};
    LockedEnd top;
    Vec3 hawse;
    EnergyLedger ledger;
    ChainStepResult last;

    HangingAnchor(double length, const Vec3& up)
        : chain(straight_chain(def, Vec3::Zero(), length * up, length, 256)),
          solver(def, 256),
          anchor({}, 0.5 * def.node_spacing * def.mass_per_metre, environment, {}),
          hawse(length * up) {
        anchor.set_pose({.position = -Vec3(anchor.shackle())});
    }

    void step() {
        set.clear();
        find_anchor_contacts(def, environment, chain, kStep, anchor, {}, set.ties());
        const StepTime time{kStep, step_kick(chain, kStep)};
        const ChainTail tail = anchor.begin(environment, time, {}, {});
        const AnchorEnd end = anchor.end();
        solver.predict(chain, environment, kStep, tail, top, hawse);
        last = solver.solve(chain, environment, top, &ledger, &set, &end);
        anchor.push(set.pushed_anchor());
        const Vector7 moved = anchor.finish(environment, time, chain.velocity.at(0), &ledger);
        chain.position.set(0, anchor.shackle());
        chain.velocity.set(0, anchor.shackle_velocity());
        ledger.contact += set.settle(chain, moved).work;
    }
    double energy() const {
        return chain_energy(def, environment, chain).total() + anchor.kinetic_energy() +
               anchor.potential_energy(environment);
    }
    Vec3 momentum() const {
        Vec3 sum = anchor.mass() * anchor.motion().head<3>();
        for (int i = 1; i < chain.links; ++i)
            sum += def.mass_per_metre * node_length(def, chain, i) * chain.velocity.at(i);
        return sum;
    }
    double weight() const {
        double mass = anchor.mass();
        for (int i = 1; i < chain.links; ++i)
            mass += def.mass_per_metre * node_length(def, chain, i);
        return mass * kGravity;
    }
};

/// Deepest that any link is pressed into a box of the anchor, m, beyond its own half width.
double deepest(const ChainDef& def, const ChainState& chain, const Anchor& anchor) {
    double deepest = 0;
    for (int i = 1; i < chain.links; ++i) {
        const Vec3 lower = chain.position.at(i), along = chain.position.at(i + 1) - lower;
        for (int k = 0; k < anchor.boxes(); ++k) {
            const AnchorBox box = anchor.box(k);
            const OnBox on = closest_on_box(box.axes.transpose() * (lower - box.centre),
                                            box.axes.transpose() * along, box.half);
            deepest = std::max(deepest, 0.5 * def.contact_diameter - on.distance);
        }
    }
    return deepest;
}

TEST(ClosestOnBox, AgreesWithSamplesOfTheSegment) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> pick(-2, 2);
    const auto vector = [&] { return Vec3(pick(random), pick(random), pick(random)); };
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec3 a = vector(), u = vector(), half = vector().cwiseAbs() * 0.5;
        double min = 1e9;
        for (int s = 0; s <= 400; ++s) {
            const Vec3 p = a + s / 400.0 * u;
            min = std::min(min, (p - p.cwiseMax(-half).cwiseMin(half)).norm());
        }
        const OnBox on = closest_on_box(a, u, half);
        ASSERT_NEAR(std::max(0.0, on.distance), min, 2e-2) << trial; // u / 400 between samples
        ASSERT_LE(std::max(0.0, on.distance), min + 1e-9) << trial;
        ASSERT_NEAR(on.normal.norm(), 1, 1e-12);
        ASSERT_LE((on.point.cwiseAbs() - half).maxCoeff(), 1e-9);
    }
}

/// Along a face the nearest point of a segment jumps from end to end as it tilts by a hair, and a link that
/// lay there shook its anchor for minutes.
TEST(BearingOnBox, OfASegmentAlongAFaceStaysInItsMiddle) {
    const Vec3 half(1, 0.2, 0.3);
    constexpr double kSpread = 0.05;
    for (const double tilt : {-1e-3, -1e-6, 0.0, 1e-6, 1e-3}) { // m, of one end against the other
        const Vec3 a(-0.5, 0, 0.4 - tilt / 2), u(1, 0, tilt);
        const OnBox nearest = closest_on_box(a, u, half), on = bearing_on_box(a, u, half, kSpread);
        if (tilt != 0) {
            EXPECT_NEAR(std::abs(nearest.share - 0.5), 0.5, 1e-6) << tilt;
        }
        // Pressed in as a bed of springs is, the resultant is u^2 tilt / 12 spread from the middle.
        EXPECT_NEAR(on.share, 0.5, 1.1 * std::abs(tilt) / (12 * kSpread) + 1e-9) << tilt;
        EXPECT_NEAR(on.distance, 0.1, 1e-9 + std::abs(tilt) * 0.01) << tilt;
        EXPECT_NEAR(on.normal.z(), 1, 1e-9) << tilt;
    }
}

TEST(BearingOnBox, GoesWithTheSegmentAndStaysNearTheNearest) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> pick(-2, 2);
    const auto vector = [&] { return Vec3(pick(random), pick(random), pick(random)); };
    constexpr double kSpread = 0.05, kMoved = 1e-6;
    int outside = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec3 a = vector(), u = vector(), half = vector().cwiseAbs() * 0.5;
        const OnBox nearest = closest_on_box(a, u, half), on = bearing_on_box(a, u, half, kSpread);
        if (nearest.distance <= kSpread) continue;
        ++outside;
        ASSERT_GE(on.distance, nearest.distance - 1e-12) << trial;
        ASSERT_LE(on.distance, nearest.distance + kSpread) << trial;
        ASSERT_LE((on.point.cwiseAbs() - half).maxCoeff(), 1e-9) << trial;
        ASSERT_NEAR((a + on.share * u - on.point).norm(), on.distance, 1e-12) << trial;
        // A segment of some metres that moves by a micrometre bears within a hundred of them.
        const OnBox moved = bearing_on_box(a + kMoved * vector().normalized(), u, half, kSpread);
        ASSERT_NEAR(moved.share * u.norm(), on.share * u.norm(), 100 * kMoved) << trial;
    }
    EXPECT_GT(outside, 1000);
}

/// A cable thrown at its anchor from above: it doubles over and falls past it, hitting shank, crown and
/// flukes.
HangingAnchor thrown(int seed) {
    HangingAnchor rig(14, Vec3(0.3, 0.2, 1).normalized());
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> pick(-1, 1);
    const Vec3 aside = 2 * Vec3(pick(random), pick(random), 0);
    // The upper half leads down again, beside the anchor.
    for (int i = 5; i <= rig.chain.links; ++i)
        rig.chain.position.set(i, rig.chain.position.at(4) + (i - 4) * Vec3(0.3 * pick(random), 0.2, -0.9));
    rig.hawse = rig.chain.position.at(rig.chain.links);
    for (int i = 1; i < rig.chain.links; ++i)
        rig.chain.velocity.set(i, aside + Vec3(-3 * std::sin(0.5 * i), -2, 0));
    return rig;
}

TEST(AnchorContact, KeepsMomentum) {
    int touched = 0;
    double worst = 0;
    for (int seed = 1; seed <= 5; ++seed) {
        HangingAnchor rig = thrown(seed);
        for (int k = 0; k < 600; ++k) {
            const Vec3 before = rig.momentum();
            const double kick = step_kick(rig.chain, kStep);
            rig.step();
            bool free = true; // of contacts with the held end, which takes momentum
            for (const PairContact& pair : rig.set.pair_contacts())
                free = free && pair.link_a < rig.chain.links - 1;
            // A step that Newton's method leaves to the implicit one ends 1e-8 of a link short of balance.
            if (!free || rig.last.implicit) continue;
            touched += static_cast<int>(rig.set.pair_contacts().size());
            const Vec3 given = -rig.last.hawse_impulse - Vec3(0, 0, kick * rig.weight());
            worst = std::max(worst, (rig.momentum() - before - given).norm() / (rig.weight() * kStep));
        }
    }
    EXPECT_GT(touched, 100);
    EXPECT_LT(worst, 1e-9); // as wanted, in each step
}

TEST(AnchorContact, NeverMakesEnergyAndBooksWhatItTakes) {
    double contact = 0; // J, of all: a loop may fly past
    for (int seed = 1; seed <= 5; ++seed) {
        HangingAnchor rig = thrown(seed);
        const double start = rig.energy();
        const double scale = rig.chain.links * rig.def.mass_per_metre * kGravity * 5; // J, of its fall
        double max = -1e300;
        for (int k = 0; k < 900; ++k) {
            rig.step();
            max = std::max(max, rig.energy() - start);
            ASSERT_TRUE(std::isfinite(max)) << seed << " " << k;
        }
        EXPECT_LT(max, 5e-3 * scale) << seed; // leapfrog's own wobble in the jerks of the loop
        EXPECT_GE(rig.ledger.contact, 0) << seed;
        contact += rig.ledger.contact;
        const double booked = rig.ledger.contact + rig.ledger.internal + rig.ledger.drag;
        EXPECT_NEAR((rig.energy() - start + booked) / booked, 0, 0.03) << seed;
    }
    EXPECT_GT(contact, 0);
}

TEST(AnchorContact, SlackCablePilesUpOnTheAnchor) {
    // Anchor let down on the bottom, 15 m of cable after it.
    TackleSetup setup;
    setup.cable_out = 5;
    setup.clutch_in = true;
    rigs::TackleRig rig(setup, rigs::quiet_water(20));
    rig.levers.brake = 0;
    rig.levers.clutch_in = true;
    rig.levers.speed = -1;
    double worst = 0;
    std::size_t max = 0;
    const auto deep = [&] { return rig.windlass().cable_out > 41; };
    while (!deep()) {
        rig.step();
        const ChainState& chain = rig.tackle.chain();
        worst = std::max(worst, deepest(setup.chain, chain, rig.tackle.anchor()));
        ContactSet set(0, 256);
        find_anchor_contacts(setup.chain, rig.environment, chain, rig.dt, rig.tackle.anchor(), {},
                             set.ties());
        max = std::max(max, set.pair_contacts().size());
        ASSERT_TRUE(rig.tackle.finite());
    }
    EXPECT_GT(max, 3u);
    EXPECT_LT(worst, 0.5 * setup.chain.contact_diameter); // no link's middle line in the anchor
}

} // namespace
} // namespace windlass::physics
