// Who guesses is told to wait, and keeps out nobody but himself.

#include "door/attempts.hpp"

#include <gtest/gtest.h>

namespace windlass::door {
namespace {

using namespace std::chrono_literals;

TEST(Attempts, SoManyAreWrongAtOnceThenOneEachSoOften) {
    Attempts attempts{3, 10s};
    Clock::time_point now{1h};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(attempts.wait("a", now), 0) << i;
        attempts.wrong("a", now);
    }
    EXPECT_DOUBLE_EQ(attempts.wait("a", now), 10);
    now += 4s;
    EXPECT_DOUBLE_EQ(attempts.wait("a", now), 6);
    now += 6s;
    EXPECT_EQ(attempts.wait("a", now), 0);
    attempts.wrong("a", now);
    EXPECT_DOUBLE_EQ(attempts.wait("a", now), 10) << "one has come back, not all";
    now += 30s;
    for (int i = 0; i < 3; ++i)
        attempts.wrong("a", now);
    EXPECT_DOUBLE_EQ(attempts.wait("a", now), 10) << "never more than at first";
}

TEST(Attempts, OneKeyIsNotKeptOutForAnother) {
    Attempts attempts{3, 10s};
    const Clock::time_point now{1h};
    for (int i = 0; i < 10'000; ++i)
        attempts.wrong("a", now);
    EXPECT_GT(attempts.wait("a", now), 0);
    EXPECT_EQ(attempts.wait("b", now), 0);
}

TEST(Attempts, WhatWasRightAfterAllIsNotCounted) {
    Attempts attempts{2, 10s};
    const Clock::time_point now{1h};
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(attempts.wait("a", now), 0);
        attempts.wrong("a", now);
        attempts.right("a");
    }
}

TEST(Attempts, AsManyKeysAsTheyMayBeDoNotForgetWhoHasTriedMost) {
    Attempts attempts{3, 1000s};
    const Clock::time_point now{1h};
    for (int i = 0; i < 5; ++i)
        attempts.wrong("guesser", now);
    for (std::size_t i = 0; i < Attempts::kKeys + 100; ++i)
        attempts.wrong(std::to_string(i), now);
    EXPECT_GT(attempts.wait("guesser", now), 0);
}

TEST(NetworkOf, TakesAHouseOfIPv6TogetherAndIPv4AsItIs) {
    EXPECT_EQ(network_of("192.168.1.7"), "192.168.1.7");
    EXPECT_EQ(network_of("::ffff:192.168.1.7"), "192.168.1.7");
    EXPECT_EQ(network_of("2001:db8:1:2:3:4:5:6"), network_of("2001:db8:1:2:ffff::1"));
    EXPECT_NE(network_of("2001:db8:1:2::1"), network_of("2001:db8:1:3::1"));
}

} // namespace
} // namespace windlass::door
