// What whoever steps a chain or a tackle must keep to: a debug build ends where it is broken.

#include "rigs/tackle_rig.hpp"

#include <gtest/gtest.h>

#ifndef NDEBUG // asserts are a debug build's

namespace windlass::physics {
namespace {

TEST(StepHalvesDeathTest, SecondHalfOfATackleComesOnceAndAfterTheFirst) {
    const EnvironmentDef sea;
    GroundTackle tackle({}, sea, {0, 0, 6});
    EXPECT_DEATH(tackle.finish(sea, {}), "begin\\(\\) comes first");
    ASSERT_TRUE(tackle.begin(sea, 1.0 / 300, {}, {}, {0, 0, 6}, nullptr));
    tackle.finish(sea, {});
    EXPECT_DEATH(tackle.finish(sea, {}), "begin\\(\\) comes first");
}

TEST(StepHalvesDeathTest, ChainIsSolvedOnceAndAfterItWasPredicted) {
    const ChainDef def;
    const EnvironmentDef sea;
    ChainState chain = straight_chain(def, {0, 0, -20}, Vec3::Zero(), 20, 32);
    ChainSolver solver(def, 32);
    LockedEnd top;
    EXPECT_DEATH(solver.solve(chain, sea, top), "predict\\(\\) comes first");
    solver.predict(chain, sea, 1.0 / 300, {}, top, Vec3::Zero());
    solver.solve(chain, sea, top);
    EXPECT_DEATH(solver.solve(chain, sea, top), "predict\\(\\) comes first");
}

TEST(StepHalvesDeathTest, LeversBeyondTheirStopsAreNotTaken) {
    const EnvironmentDef sea;
    GroundTackle tackle({}, sea, {0, 0, 6});
    WindlassLevers levers;
    levers.brake = 1.1;
    EXPECT_DEATH(tackle.begin(sea, 1.0 / 300, levers, {}, {0, 0, 6}, nullptr), "the hand-wheel has stops");
}

} // namespace
} // namespace windlass::physics

#endif
