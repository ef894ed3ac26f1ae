// Turns in a cable: what puts them in, what lets them out, and what they do at the lip.

#include "server/physics/chain/cable_twist.hpp"

#include "rigs/gypsy_bench.hpp"
#include "rigs/tackle_rig.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace windlass::physics {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// A ship at anchor, in the hand of the test for a minute: heading and way from lip to anchor, of a share
/// 0..1 of the time.
double turns_after(const std::function<double(double)>& heading,
                   const std::function<Vec3(double)>& to_anchor) {
    constexpr int kSteps = 18000;
    CableTwistState twist;
    for (int k = 1; k <= kSteps; ++k) {
        const double now = static_cast<double>(k) / kSteps, before = (k - 1.0) / kSteps;
        follow_twist({.dt = 1.0 / 300,
                      .turned = std::remainder(heading(now) - heading(before), kTurn),
                      .to_anchor = to_anchor(now),
                      .anchored = true},
                     twist);
    }
    return twist.turns;
}

/// m, so far off on a bearing (rad), 30 m below.
Vec3 leading(double bearing, double off = 100) {
    return {off * std::sin(bearing), off * std::cos(bearing), -30};
}

TEST(Twist, ShipThatTurnsOnTheSpotPutsHerTurnsIn) {
    const auto round = [](double t) { return 2 * kTurn * t; };
    EXPECT_NEAR(turns_after(round, [](double) { return leading(1); }), 2, 0.01); // less the first step
    EXPECT_NEAR(turns_after(round, [](double) { return leading(1, 0); }), 2, 1e-9);
    EXPECT_NEAR(turns_after([&](double t) { return -round(t); }, [](double) { return leading(1, 0); }), -2,
                1e-9);
    const auto there_and_back = [](double t) { return kTurn * std::sin(0.5 * kTurn * t); };
    EXPECT_NEAR(turns_after(there_and_back, [](double) { return leading(1); }), 0, 0.01);
}

TEST(Twist, ShipThatSwingsRoundHerAnchorPutsNoneIn) {
    const auto swings = [](double t) { return 3 * kTurn * t; };
    EXPECT_NEAR(turns_after(swings, [&](double t) { return leading(swings(t)); }), 0, 1e-3);
}

TEST(Twist, ShipThatPassesOverHerAnchorPutsInWhatSheTurnsOnly) {
    const auto across = [](double t) { return Vec3(0.3, 100 - 200 * t, -30); }; // anchor ahead, then astern
    EXPECT_NEAR(turns_after([](double) { return 0.0; }, across), 0, 0.1); // cable swept aside by 5 m at most
    // Then she swings to it, clockwise: half a turn stays in.
    const auto swings_after = [](double t) { return std::max(0.0, t - 0.5) * kTurn; };
    EXPECT_NEAR(turns_after(swings_after, across), 0.5, 0.1);
}

TEST(Twist, SwivelLetsTheTurnsOutWhenTheAnchorIsOffTheBottom) {
    CableTwistState twist{.turns = 4};
    follow_twist({.dt = 10, .anchored = true}, twist);
    EXPECT_EQ(twist.turns, 4);
    follow_twist({.dt = 10, .turned = 1, .anchored = false}, twist);
    EXPECT_NEAR(twist.turns, 4 / std::numbers::e, 1e-12);
}

TEST(Twist, CrowdsTogetherAsTheCableComesIn) {
    const ChainDef chain;
    const double link = 4 * chain.diameter;
    EXPECT_NEAR(twist_per_link(chain, 3, 360 * link), radians_from_degrees(3), 1e-12);
    EXPECT_NEAR(twist_per_link(chain, -3, 90 * link), radians_from_degrees(12), 1e-12);
}

TEST(Twist, LoadOfHeavingGrowsAsTheHawsePipeTakesMore) {
    for (const double degrees : {0.0, 3.0, 13.5}) {
        // From 3 to 24 degrees a link the efficiency falls in a straight line to a twentieth.
        const double share = degrees > 3 ? 1 - 0.95 * 0.5 : 1;
        rigs::GypsyBench bench;
        bench.cable.twist = radians_from_degrees(degrees);
        bench.drive(0.5);
        const double outboard = 1e5, g = bench.chain.mass_per_metre * kGravity;
        bench.run(5, outboard);
        ASSERT_LT(bench.speed(), -0.15);
        const double expected = (outboard + g * bench.def.hawse_pipe_height) / (kHawseEfficiency * share);
        EXPECT_NEAR(bench.windlass.loads().deck.gypsy_load / expected, 1, 1e-6) << degrees;
    }
}

TEST(Twist, KnottedCableNeitherRunsNorComesIn) {
    rigs::GypsyBench bench;
    bench.cable.twist = 1.01 * knotting_twist();
    bench.drive(1);
    bench.run(5, 1e5);
    EXPECT_NEAR(bench.speed(), 0, 1e-6); // the motor stalls on a tenth of its pull
    bench.levers.clutch_in = false;
    bench.levers.speed = 0;
    bench.run(5, 3e5);
    EXPECT_EQ(bench.state().clutch.position, Clutch::out);
    EXPECT_EQ(bench.speed(), 0); // brake off
    bench.cable.twist = 0;
    bench.run(1, 3e5);
    EXPECT_GT(bench.speed(), 1);
}

TEST(Twist, FaultPutsTurnsInAndTakesThemOut) {
    CableTwistState twist;
    follow_twist({.dt = 1, .anchored = true, .put_in = 0.5}, twist);
    EXPECT_EQ(twist.turns, 4);
    follow_twist({.dt = 1, .anchored = true, .put_in = 0.5}, twist); // once
    EXPECT_EQ(twist.turns, 4);
    follow_twist({.dt = 1, .turned = -kTurn, .anchored = true, .put_in = 0.5}, twist);
    EXPECT_EQ(twist.turns, 3); // the ship can turn them out as well
    follow_twist({.dt = 1, .anchored = true, .put_in = 0}, twist);
    EXPECT_EQ(twist.turns, 0);
}

} // namespace
} // namespace windlass::physics
