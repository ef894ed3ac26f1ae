// When an anchor counts as foul of its own cable.

#include "server/physics/anchor/bight.hpp"

#include <gtest/gtest.h>

namespace windlass::physics {
namespace {

/// Half a minute of the same pull, taut from 10 kN on, on an anchor with its shackle towards +x, which slides
/// from 25 kN on; by 12 m, unless it stays where it is.
void pull(BightState& state, const Vec3& body, const Vec3& shackle, double touching, double way = 12) {
    for (int k = 0; k < 3000; ++k)
        update_bight({.body = body,
                      .shackle = shackle,
                      .touching = touching,
                      .taut = 1e4,
                      .slides = 2.5e4,
                      .moved = way / 3000,
                      .dt = 0.01},
                     state);
}

TEST(Bight, PullByTheShackleIsClear) {
    BightState state;
    pull(state, Vec3::Zero(), {2e5, 0, 3e4}, 0);
    EXPECT_EQ(state.share, 0);
}

TEST(Bight, SlackCableThatLiesOnTheAnchorIsClear) {
    BightState state;
    pull(state, {2e4, 0, -3e4}, {2e3, 0, 0}, 2e3);
    EXPECT_EQ(state.share, 0);
}

TEST(Bight, TautCableRoundTheCrownIsFoul) {
    BightState state;
    pull(state, {1e5, 0, 0}, {5e4, 0, 0}, 1e5);
    EXPECT_NEAR(state.share, 2.0 / 3, 1e-2); // e^-6 is left after 12 m of 2 m, or half a minute of 5 s
}

TEST(Bight, ShackleDrawnBackOverTheCrownIsFoul) {
    BightState state;
    pull(state, {5e3, 0, 0}, {-5e4, 0, 0}, 5e4);
    EXPECT_NEAR(state.share, 1, 1e-2);
    // The same with the cable clear of the body: she has only swung, and the anchor has yet to turn.
    state = {};
    pull(state, Vec3::Zero(), {-5e4, 0, 0}, 0);
    EXPECT_EQ(state.share, 0);
}

// A heap that is drawn out leads away over its anchor for a while, before it turns it round.
TEST(Bight, CableThatLeadsAcrossTheAnchorAndDoesNotMoveItIsNotCalledFoul) {
    BightState state;
    pull(state, {1e5, 0, 0}, {-5e4, 0, 0}, 1e5, 0);
    EXPECT_EQ(state.share, 0);
    state = {};
    pull(state, {1e4, 0, 0}, {-1.2e4, 0, 0}, 2e4); // it is turned, by less than would drag it
    EXPECT_EQ(state.share, 0);
}

TEST(Bight, StaysFoulWhileTheCableIsSlackAndClearsWhenTheShacklePulls) {
    BightState state;
    pull(state, {1e5, 0, 0}, {5e4, 0, 0}, 1e5);
    pull(state, Vec3::Zero(), Vec3::Zero(), 0);
    EXPECT_GT(state.share, kFoul);
    pull(state, Vec3::Zero(), {1e5, 0, 0}, 0);
    EXPECT_LT(state.share, 0.01);
}

} // namespace
} // namespace windlass::physics
