// Which pictures of a cable are sent.

#include "server/dds/still_cable.hpp"

#include <gtest/gtest.h>

namespace windlass::dds {
namespace {

exercise::ChainView cable() {
    exercise::ChainView chain;
    chain.cable_out = 100;
    chain.nodes.assign(101, Eigen::Vector3f(1, 2, -3));
    chain.tension.assign(100, 5e4F);
    return chain;
}

/// Pictures sent of a second at 60 Hz from the given time on.
template <class Change>
int sent(StillCable& still, exercise::ChainView& chain, double from, const Change& change) {
    int count = 0;
    for (int k = 0; k < 60; ++k) {
        change(k);
        count += still.due(chain, from + k / 60.0) ? 1 : 0;
    }
    return count;
}

TEST(StillCable, IsToldFiveTimesASecond) {
    StillCable still;
    exercise::ChainView chain = cable();
    EXPECT_EQ(sent(still, chain, 10, [](int) {}), 5);
}

TEST(StillCable, ThatTremblesByLessThanCanBeSeenIsStill) {
    StillCable still;
    exercise::ChainView chain = cable();
    EXPECT_EQ(sent(still, chain, 10,
                   [&](int k) {
                       chain.nodes[50].x() = 1 + (k % 2 == 0 ? 1e-3F : 0);
                       chain.tension[99] = 5e4F + (k % 2 == 0 ? 50 : 0);
                   }),
              5);
}

TEST(StillCable, ThatMovesIsToldEveryTime) {
    for (const int node : {0, 50, 100}) {
        StillCable still;
        exercise::ChainView chain = cable();
        EXPECT_EQ(
            sent(still, chain, 10, [&](int) { chain.nodes[static_cast<std::size_t>(node)].z() -= 0.01F; }),
            60);
    }
}

TEST(StillCable, IsToldAtOnceWhenItMovesAfterAWhile) {
    StillCable still;
    exercise::ChainView chain = cable();
    for (int k = 0; k < 31; ++k)
        still.due(chain, k / 60.0);
    EXPECT_FALSE(still.due(chain, 31 / 60.0));
    chain.nodes[3].y() += 0.02F;
    EXPECT_TRUE(still.due(chain, 32 / 60.0));
}

TEST(StillCable, ThatIsPulledHarderOrPaidOutIsToldEveryTime) {
    StillCable still;
    exercise::ChainView chain = cable();
    EXPECT_EQ(sent(still, chain, 10, [&](int) { chain.tension[70] *= 1.01F; }), 60);
    EXPECT_EQ(sent(still, chain, 11, [&](int) { chain.cable_out += 0.005; }), 60);
    EXPECT_EQ(sent(still, chain, 12, [&](int k) { chain.nodes.resize(k % 2 == 0 ? 102 : 101); }), 60);
}

// A page that joins a paused exercise hears what is repeated, and nothing else.
TEST(StillCable, OfAnExercisePausedBetweenTwoPicturesIsToldWhenAsked) {
    StillCable still;
    const exercise::ChainView chain = cable();
    EXPECT_TRUE(still.due(chain, 10));
    EXPECT_FALSE(still.due(chain, 10.1)); // here it is paused
    EXPECT_TRUE(still.due(chain, 10.1));
    EXPECT_TRUE(still.due(chain, 10.1));
}

TEST(StillCable, OfAnExerciseThatStandsStillOrWasSetBackIsToldWhenAsked) {
    StillCable still;
    const exercise::ChainView chain = cable();
    EXPECT_TRUE(still.due(chain, 10));
    EXPECT_TRUE(still.due(chain, 10));
    EXPECT_TRUE(still.due(chain, 4));
    EXPECT_FALSE(still.due(chain, 4.1));
}

} // namespace
} // namespace windlass::dds
