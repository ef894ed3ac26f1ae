// Slack chain: it piles up, with a height and a footprint, and neither makes energy nor loses momentum.

#include "server/physics/contact/bend_limit.hpp"
#include "server/physics/contact/chain_self_contact.hpp"
#include "tests/physics/base/bits.hpp"
#include "tests/physics/exercise_step.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace windlass::physics {
namespace {

/// A chain that feels itself.
struct HeapRig {
    ChainRig rig;
    ContactSet set{0, 4096};
    SelfContacts finder{4096};
    double work = 0; ///< J taken by contacts of chain with chain

    void step(double dt = kStep) {
        set.clear();
        finder.find(rig.def, rig.state, dt, set);
        rig.step(dt, &set);
        work += set.settle(rig.state).work;
    }
};

ChainDef chain_with(double spacing) {
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    def.node_spacing = spacing;
    return def;
}

/// The given length (m) of chain hung from a lip that comes straight down on the bottom at 1 m/s.
HeapRig lowered(double length, double spacing) {
    const EnvironmentDef sea = still_water(20);
    const double bottom = -sea.depth;
    HeapRig heap{ChainRig(chain_with(spacing), sea, {0, 0, bottom + 1}, {0, 0, bottom + 1 + length}, length,
                          Foot::hanging, 0)};
    // Its foot lies on the bottom as the anchor would, and is stopped there.
    while (heap.rig.hawse.z() > bottom + 1.5) {
        heap.rig.hawse.z() -= kStep;
        if (heap.rig.state.position.z[0] < bottom + 0.1) heap.rig.tail_mass = 0;
        heap.step();
    }
    for (int k = 0; k < 300 * 5; ++k)
        heap.step();
    return heap;
}

TEST(Heap, ChainLoweredOnTheBottomPilesUpLikeChainInALocker) {
    // Chain stows in 1.1 d^2 l / 1e5 m3 (d in mm, l in m; Germanischer Lloyd's rule for lockers): 2.0 m3 for
    // these 30 m. Loose on the bottom it has no walls: its heap takes more room than that, but far from what
    // a chain laid out takes.
    const double length = 30;
    for (const double spacing : {0.5, 1.0}) {
        const HeapRig heap = lowered(length, spacing);
        const ChainState& chain = heap.rig.state;
        double height = 0, radius2 = 0;
        int down = 0;
        Vec3 middle = Vec3::Zero();
        for (int i = 0; i <= chain.links - 3; ++i)
            middle += chain.position.at(i) / (chain.links - 2);
        for (int i = 0; i <= chain.links - 3; ++i) {
            const Vec3 p = chain.position.at(i);
            height =
                std::max(height, p.z() + heap.rig.environment.depth + 0.5 * heap.rig.def.contact_diameter);
            radius2 += ((p - middle).head<2>()).squaredNorm();
            ++down;
        }
        // A cone whose footprint spreads as the nodes do: r^2 = 10/3 of their mean square.
        const double footprint = std::numbers::pi * (10.0 / 3) * radius2 / down;
        const double volume = footprint * height / 3;
        const double stowed = 1.1 * 78 * 78 * length / 1e5;
        EXPECT_GT(height, 1.5 * heap.rig.def.contact_diameter);
        EXPECT_LT(height, 3);
        EXPECT_GT(volume, 0.3 * stowed); // rods of a metre bridge less than links do
        EXPECT_LT(volume, 5 * stowed);
        // No link has shrunk to a point, none folded beyond its limit by more than the springs give.
        for (int i = 0; i < chain.links - 1; ++i) {
            const double distance = (chain.position.at(i + 1) - chain.position.at(i)).norm();
            EXPECT_GT(distance, 0.9 * min_distance(heap.rig.def, spacing)) << i;
        }
    }
}

TEST(Heap, DropNeverMakesEnergy) {
    // A loop of chain let fall on the bottom in air: fast, no water to hide anything.
    EnvironmentDef ground = in_air();
    ground.depth = 15;
    for (const double spacing : {0.5, 1.0}) {
        HeapRig heap{ChainRig(chain_with(spacing), ground, {0.1, 0, -14}, {0, 0, 10}, 24, Foot::fixed)};
        const auto energy = [&] { return chain_energy(heap.rig.def, ground, heap.rig.state).total(); };
        const double start = energy();
        const double fall = 24 * weight_in_air(heap.rig.def) * 12;
        double max = -1e300, lip_work = 0;
        heap.rig.hawse = {0, 0, 10};
        for (int k = 0; k < 300 * 6; ++k) {
            // The lip lets go: it follows the fall of the top link, then stays a link above the ground.
            const double t = (k + 1) * kStep;
            heap.rig.hawse.z() = std::max(-13.0, 10 - 0.5 * kGravity * t * t);
            const Vec3 lip = heap.rig.state.position.at(heap.rig.state.links);
            heap.step();
            lip_work += heap.rig.last.hawse_impulse.dot(heap.rig.hawse - lip) / kStep;
            max = std::max(max, energy() - start);
            ASSERT_TRUE(std::isfinite(max)) << k;
        }
        EXPECT_LT(max, 1e-3 * fall) << spacing;
        // What it lost is booked: in the links, on the ground, between the links, at the lip.
        const EnergyLedger& ledger = heap.rig.ledger;
        const double booked = heap.work + ledger.bed + ledger.internal + lip_work;
        EXPECT_GT(heap.work, 0);
        EXPECT_NEAR(booked / (start - energy()), 1, 0.03) << spacing; // springs of the heap included
    }
}

TEST(SelfContact, KeepsMomentum) {
    // Chain hung in a loop over itself and let swing through: momentum changes by gravity and at the lip
    // only.
    const ChainDef def = chain_with(1);
    HeapRig heap{ChainRig(def, in_air(), {0, 0, 0}, {24, 0, 0}, 24, Foot::hanging, 200)};
    ChainState& chain = heap.rig.state;
    for (int i = 0; i <= chain.links; ++i) { // a helix of 0.6 m radius, closed up to 0.2 m a turn
        const double turn = i * def.node_spacing / 0.6;
        chain.position.set(i,
                           {0.6 * std::cos(turn), 0.6 * std::sin(turn), 0.2 * turn / (2 * std::numbers::pi)});
        chain.velocity.set(i, {0, 0, -0.5 * i / 24.0});
    }
    heap.rig.hawse = chain.position.at(chain.links);
    heap.rig.def = def;
    const auto momentum = [&] {
        Vec3 sum = heap.rig.tail_mass * chain.velocity.at(0);
        for (int i = 1; i < chain.links; ++i)
            sum += def.mass_per_metre * node_length(def, chain, i) * chain.velocity.at(i);
        return sum;
    };
    double weight = heap.rig.tail_weight;
    for (int i = 1; i < chain.links; ++i)
        weight += def.mass_per_metre * node_length(def, chain, i) * kGravity;
    int touched = 0;
    double worst = 0;
    for (int k = 0; k < 600; ++k) {
        const Vec3 before = momentum();
        heap.step();
        bool free = true; // of contacts with the held top, which takes momentum
        for (const PairContact& pair : heap.set.pair_contacts())
            free = free && pair.link_a < chain.links - 1 && pair.link_b < chain.links - 1;
        if (!free) continue;
        touched += static_cast<int>(heap.set.pair_contacts().size());
        const Vec3 given = -heap.rig.last.hawse_impulse - Vec3(0, 0, kStep * weight);
        worst = std::max(worst, (momentum() - before - given).norm());
    }
    EXPECT_GT(touched, 100);
    EXPECT_LT(worst / (weight * kStep), 1e-10); // as wanted, in each step
}

TEST(SelfContact, IsTheSameBitsTwice) {
    const auto run = [] { return lowered(12, 0.5).rig.state; };
    const ChainState a = run(), b = run();
    ASSERT_EQ(a.links, b.links);
    for (const auto& [x, y] : {std::pair{&a.position.x, &b.position.x}, {&a.velocity.z, &b.velocity.z}})
        EXPECT_EQ(bits(*x), bits(*y));
}

TEST(SelfContact, FindsTheSameHoweverLongAgoItLooked) {
    // What is passed over must hold nothing: beside a finder that remembers, a fresh one in every step.
    HeapRig heap{ChainRig(chain_with(0.5), still_water(20), {0, 0, -19}, {0, 0, 1}, 20, Foot::hanging, 0)};
    std::size_t found = 0;
    for (int k = 0; k < 300 * 12; ++k) {
        heap.rig.hawse.z() = std::max(-18.0, heap.rig.hawse.z() - 2 * kStep);
        heap.rig.hawse.x() += kStep * 0.5 * std::sin(0.01 * k);
        if (heap.rig.state.position.z[0] < -19.9) heap.rig.tail_mass = 0;
        SelfContacts fresh(heap.rig.state.links);
        ContactSet expected(0, 4096);
        fresh.find(heap.rig.def, heap.rig.state, kStep, expected);
        heap.step();
        const auto &a = expected.pair_contacts(), &b = heap.set.pair_contacts();
        ASSERT_EQ(a.size(), b.size()) << k;
        for (std::size_t p = 0; p < a.size(); ++p) {
            ASSERT_EQ(a[p].link_a, b[p].link_a) << k;
            ASSERT_EQ(a[p].link_b, b[p].link_b) << k;
            ASSERT_EQ(a[p].penetration, b[p].penetration) << k;
        }
        found += a.size();
    }
    EXPECT_GT(found, 1000u);
}

TEST(SelfContact, FindsWhatEveryPairOfLinksTriedFinds) {
    // The boxes must not lose a pair: compare with all against all.
    HeapRig heap = lowered(20, 0.5);
    heap.set.clear();
    heap.finder.find(heap.rig.def, heap.rig.state, kStep, heap.set);
    const ChainState& chain = heap.rig.state;
    ContactSet all(0, 4096);
    int expected = 0;
    for (int i = 0; i < chain.links; ++i) {
        for (int j = i + 1; j < chain.links; ++j) {
            // Sampled distance of the two links: never less than the true one.
            double min = 1e300;
            for (int p = 0; p <= 20; ++p)
                for (int q = 0; q <= 20; ++q)
                    min = std::min(
                        min,
                        (chain.position.at(i) + p / 20.0 * (chain.position.at(i + 1) - chain.position.at(i)) -
                         chain.position.at(j) - q / 20.0 * (chain.position.at(j + 1) - chain.position.at(j)))
                            .norm());
            if (min > heap.rig.def.contact_diameter || j - i < 3) continue;
            ++expected;
            bool found = false;
            for (const PairContact& pair : heap.set.pair_contacts())
                found = found || (pair.link_a == j && pair.link_b == i);
            EXPECT_TRUE(found) << i << " " << j;
        }
    }
    EXPECT_GT(expected, 5);
}

} // namespace
} // namespace windlass::physics
