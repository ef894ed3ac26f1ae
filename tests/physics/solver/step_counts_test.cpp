// What a step that was not solved as it should be is counted as.

#include "rigs/tackle_rig.hpp"
#include "server/physics/solver/step_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace windlass::physics {
namespace {

/// An anchor on 150 m of cable in links of 0.25 m, hove up and down by 2 m in 4 s, in so many substeps of a
/// tick of 1/60 s at most.
StepCounts hanging(int max_substeps) {
    TackleSetup setup;
    setup.chain.node_spacing = 0.25;
    setup.cable_out = 150;
    GroundTackle tackle(setup, rigs::quiet_water(300), {0, 0, 6});
    constexpr double kTick = 1.0 / 60, kOmega = 1.57;
    for (int tick = 0; tick < 600; ++tick) {
        const int substeps = tackle.substeps(kTick, max_substeps);
        for (int k = 1; k <= substeps; ++k) {
            const double t = kTick * (tick + static_cast<double>(k) / substeps);
            rigs::step_tackle(tackle, rigs::quiet_water(300), kTick / substeps, {}, {},
                              {0, 0, 7 - std::cos(kOmega * t)});
        }
    }
    EXPECT_TRUE(tackle.finite());
    return tackle.step_counts();
}

TEST(StepCounts, OfASwingThatIsSteppedFinelyEnoughAreSteps) {
    const StepCounts counts = hanging(64);
    EXPECT_GT(counts.steps, 600U);
    EXPECT_EQ(counts, (StepCounts{.steps = counts.steps}));
    EXPECT_FALSE(in_doubt(counts));
}

TEST(StepCounts, TellStepsThatAreTooLongAndWhatBecameOfThem) {
    // Waves run at sqrt(T / mu), 40 m/s and more: 0.7 m in 1/60 s, three links.
    const StepCounts counts = hanging(1);
    EXPECT_EQ(counts.steps, 600U);
    EXPECT_EQ(counts.capped, 600U);
    EXPECT_GT(counts.implicit, 550U);
    EXPECT_EQ(counts.unsolved, 0U);
    EXPECT_TRUE(in_doubt(counts));
}

TEST(StepCounts, TellContactsForWhichThereWasNoPlace) {
    ContactSet set(1, 1);
    set.add(NodeContact{.node = 1});
    EXPECT_EQ(set.dropped(), 0);
    set.add(NodeContact{.node = 2});
    set.add(PairContact{});
    set.add(PairContact{});
    EXPECT_EQ(set.dropped(), 2);
}

TEST(StepCounts, AreInDoubtWhenAnythingWasLeftOutOrMuchWasOfFirstOrder) {
    EXPECT_FALSE(in_doubt({}));
    EXPECT_FALSE(in_doubt({.steps = 3000, .implicit = 30, .friction = 170, .contacts = 3000}));
    EXPECT_TRUE(in_doubt({.steps = 3000, .implicit = 310}));
    EXPECT_FALSE(in_doubt({.steps = 3000, .friction = 900})); // a cable that comes to strain on the bed
    EXPECT_TRUE(in_doubt({.steps = 3000, .friction = 1600}));
    EXPECT_TRUE(in_doubt({.steps = 3000, .implicit = 1, .unsolved = 1}));
    EXPECT_TRUE(in_doubt({.steps = 3000, .dropped = 1}));
    EXPECT_FALSE(in_doubt({.steps = 3000, .capped = 16})); // a snatch
    EXPECT_TRUE(in_doubt({.steps = 3000, .capped = 1500}));
}

TEST(StepCounts, OfAWhileAreTheirDifference) {
    const StepCounts early{.steps = 10, .implicit = 2}, late{.steps = 30, .implicit = 3, .friction = 4};
    EXPECT_EQ(late - early, (StepCounts{.steps = 20, .implicit = 1, .friction = 4}));
    EXPECT_EQ(early + (late - early), late);
}

} // namespace
} // namespace windlass::physics
