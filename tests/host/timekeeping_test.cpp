// How late ticks begin, counted.

#include "server/host/timekeeping.hpp"

#include <gtest/gtest.h>

namespace windlass::host {
namespace {

using namespace std::chrono_literals;

constexpr double kStep = 0.0501e-3; // s: it is rounded up to 0.05 ms, and a little for the sum in binary

TEST(Timekeeping, SaysWithinWhatHalfMostAndAllBegan) {
    Timekeeping kept;
    for (int i = 1; i <= 1000; ++i) // 0.01 to 10 ms, evenly
        kept.began(10us * i);
    const auto figures = kept.collect();
    EXPECT_EQ(figures.beats, 1000U);
    EXPECT_NEAR(figures.half, 5.0e-3, kStep);
    EXPECT_NEAR(figures.most, 9.9e-3, kStep);
    EXPECT_NEAR(figures.all, 10e-3, 1e-9);
}

TEST(Timekeeping, BeginsAnewWhenItWasAsked) {
    Timekeeping kept;
    kept.began(8ms);
    kept.collect();
    kept.began(1ms);
    const auto figures = kept.collect();
    EXPECT_EQ(figures.beats, 1U);
    EXPECT_NEAR(figures.all, 1e-3, 1e-9);
}

TEST(Timekeeping, OfNoBeatsSaysNothing) {
    Timekeeping kept;
    const auto figures = kept.collect();
    EXPECT_EQ(figures.beats, 0U);
    EXPECT_EQ(figures.half, 0);
    EXPECT_EQ(figures.all, 0);
}

/// A beat before its time is not late, and one that is later than the counts go is not lost.
TEST(Timekeeping, KnowsNoNegativeLatenessAndNoEnd) {
    Timekeeping kept;
    kept.began(-3ms);
    EXPECT_LE(kept.collect().most, kStep);
    kept.began(2s);
    EXPECT_NEAR(kept.collect().half, 2, 1e-9);
}

} // namespace
} // namespace windlass::host
