// The server's chain as a method of the lab: its ends, and its order.

#include "tests/lab/problems.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::lab {
namespace {

std::unique_ptr<Method> production(const Problem& problem, int links, double dt) {
    return method_named("production").make(problem, links, dt, {});
}

void run(Method& method, double until) {
    while (method.time() < until - 1e-9)
        method.step();
}

TEST(Production, HangsWithTheWeightBelowAtEveryLink) {
    const Problem problem = hanging_chain(100, 9900);
    const auto chain = production(problem, 100, 1.0 / 240);
    run(*chain, 5);
    const double weight = problem.line.mass_per_metre * physics::kGravity;
    for (const int link : {0, 50, 99})
        EXPECT_NEAR(chain->tension(link) / (9900 * physics::kGravity + (link + 0.5) * weight), 1, 1e-4)
            << link;
}

TEST(Production, SwingsToTheMirroredPlaceWithoutLosingEnergy) {
    // A short rigid pendulum of the same length would turn back at the height it was let go from; nothing of
    // the chain may pass that height.
    const auto chain = production(swinging_chain(20, 1e5), 10, 1e-3);
    double highest = -1e9;
    for (int k = 0; k < 20000; ++k) {
        chain->step();
        if (chain->time() > 2) highest = std::max(highest, chain->position(0).z());
    }
    EXPECT_LT(highest, 0.2);
    EXPECT_GT(highest, -1);
}

/// Place of the anchor after 1 s of swing, before any snap.
Vec3 tip(double dt) {
    const auto chain = production(swinging_chain(200, 1e4), 20, dt);
    run(*chain, 1);
    return chain->position(0);
}

TEST(Production, ConvergesWithTheSquareOfTheStep) {
    const Vec3 exact = tip(1.0 / 15360);
    const double coarse = (tip(1.0 / 240) - exact).norm(), fine = (tip(1.0 / 480) - exact).norm();
    EXPECT_GT(coarse / fine, 3.5); // 4: second order; 2: first
    EXPECT_LT(coarse / fine, 4.6);
}

TEST(Production, TurnsTheLineWhenOnlyItsLowerEndIsHeld) {
    // The same hanging chain, counted from its held end.
    Problem upright = hanging_chain(50, 500), turned = upright;
    std::swap(turned.lower, turned.upper);
    turned.start = [start = upright.start](double s) { return start(50 - s); };
    const auto one = production(upright, 25, 0.002), other = production(turned, 25, 0.002);
    run(*one, 1);
    run(*other, 1);
    for (int i = 0; i < 25; ++i) {
        EXPECT_DOUBLE_EQ(one->tension(i), other->tension(24 - i));
        EXPECT_EQ(one->position(i), other->position(25 - i));
    }
}

TEST(Production, RefusesALineThatNothingHolds) {
    Problem problem = hanging_chain(50, 0);
    problem.upper.kind = EndKind::free;
    EXPECT_THROW(production(problem, 10, 0.01), std::invalid_argument);
}

TEST(Production, FollowsADrivenEndToItsPlaceInTheStep) {
    Problem problem = hanging_chain(50, 500);
    problem.upper.kind = EndKind::driven;
    problem.upper.motion = [](double t) { return Vec3(std::sin(t), 0, 0); };
    const auto chain = production(problem, 25, 0.002);
    run(*chain, 1);
    EXPECT_NEAR(chain->position(25).x(), std::sin(1.0), 1e-12);
}

} // namespace
} // namespace windlass::lab
