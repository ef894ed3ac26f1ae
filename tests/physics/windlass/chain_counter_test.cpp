// The chain counter knows the gypsy's pockets; the paint on the cable knows the cable.

#include "rigs/gypsy_bench.hpp"
#include "server/physics/chain/shackle_marks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::physics {
using namespace rigs;

namespace {

/// A bench whose chain runs out freely for some metres.
GypsyBench run_out(const EquipmentFaults& causes = {}, const WindlassDef& def = {}) {
    GypsyBench bench(def);
    bench.causes = causes;
    bench.levers.brake = 0;
    bench.run(6, bench.pull_for(1e5));
    return bench;
}

double pulse(const GypsyBench& bench) {
    return counter_pulse(bench.chain.diameter);
}

TEST(ChainCounter, CountsPocketsAsTheyPass) {
    const GypsyBench bench = run_out();
    const double shown = bench.windlass.counter_reading();
    ASSERT_GT(bench.state().cable_out, 110);
    EXPECT_LE(std::abs(shown - bench.state().cable_out), pulse(bench));
    EXPECT_NEAR(std::remainder(shown - 100, 0.5 * 8 * 0.078), 0, 1e-9); // two pulses in 8 d of chain
}

TEST(ChainCounter, ShowsByHowMuchItWasSetWrong) {
    WindlassDef def;
    def.counter_offset = 27.5; // a shackle too many
    const GypsyBench bench = run_out({}, def);
    EXPECT_LE(std::abs(bench.windlass.counter_reading() - 27.5 - bench.state().cable_out), pulse(bench));
}

TEST(ChainCounter, LosesTheShareOfPulsesThatItMisses) {
    GypsyBench bench = run_out({.counter_drift = 0.2});
    const double out = bench.state().cable_out - 100;
    EXPECT_NEAR(bench.windlass.counter_reading() - 100, 0.8 * out, 2 * pulse(bench));
    bench.causes.counter_drift = 1;
    const double dead = bench.windlass.counter_reading();
    bench.run(2, bench.pull_for(1e5));
    EXPECT_EQ(bench.windlass.counter_reading(), dead);
}

TEST(ChainCounter, DoesNotSeeChainThatJumpsOverTheGypsy) {
    GypsyBench bench;
    bench.causes.pockets_worn = 0.9;
    bench.run(2, bench.pull_for(1.05 * gypsy_grip(bench.def, bench.causes)));
    ASSERT_TRUE(bench.state().gypsy.jumping);
    ASSERT_GT(bench.state().cable_out, 105);
    EXPECT_NEAR(bench.windlass.counter_reading(), 100, 2 * pulse(bench)); // a step passes before it jumps
}

TEST(ShackleMarks, CountWhiteLinksAndBeginAgainAtTheSixth) {
    const ChainDef cable; // 330 m, 12 lengths
    ASSERT_EQ(joining_shackles(cable), 11);
    const int white[] = {1, 2, 3, 4, 5, 1, 2, 3, 4, 5, 1};
    for (int n = 1; n <= 11; ++n) {
        const ShackleMark mark = shackle_mark(cable, n);
        EXPECT_EQ(mark.white_links, white[n - 1]) << n;
        EXPECT_EQ(mark.from_anchor, 27.5 * n);
        EXPECT_EQ(mark.last, n >= 10) << n; // the eleventh and twelfth lengths are painted
    }
}

TEST(ShackleMarks, AreWhereTheCableIs) {
    ChainDef cable;
    cable.node_spacing = 0.84; // marks lie between nodes
    const Vec3 anchor(3, -2, -60), lip(3, 18, -10);
    const double length = (lip - anchor).norm();
    const ChainState chain = straight_chain(cable, anchor, lip, length, 200);
    for (const double from_anchor : {0.0, 27.5, 53.0}) {
        const Vec3 expected = anchor + (lip - anchor) * (from_anchor / length);
        EXPECT_LT((point_of_cable(cable, chain, from_anchor) - expected).norm(), 1e-9) << from_anchor;
    }
    EXPECT_EQ(point_of_cable(cable, chain, length + 20), lip); // inboard
}

} // namespace
} // namespace windlass::physics
