// The server's chain as a method of the lab: its ends, and its order.

#include "tests/lab/problems.hpp"
#include "tests/lab/tank.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

/// A swing of 200 m with 10 t at its end through its snap (after 5.9 s), 60 times a second.
struct Swing {
    std::vector<double> top;  ///< N
    std::vector<Vec3> anchor; ///< m
    Swing(int links, int rate, double seconds) {
        Problem problem = swinging_chain(200, 1e4);
        problem.line.mass_per_metre = 126.5;
        problem.line.stiffness = 5.83e8;
        const auto chain = production(problem, links, 1.0 / rate);
        for (int k = 1; k <= seconds * rate; ++k) {
            chain->step();
            if (k % (rate / 60) != 0) continue;
            top.push_back(chain->tension(links - 1));
            anchor.push_back(chain->position(0));
        }
    }
    double tension_error(const Swing& exact) const {
        double sum = 0;
        for (std::size_t k = 0; k < top.size(); ++k)
            sum += std::pow(top[k] - exact.top[k], 2);
        return std::sqrt(sum);
    }
    double place_error(const Swing& exact) const {
        double sum = 0;
        for (std::size_t k = 0; k < anchor.size(); ++k)
            sum += (anchor[k] - exact.anchor[k]).squaredNorm();
        return std::sqrt(sum);
    }
};

TEST(Production, ConvergesWithTheSquareOfTheStepThroughTheSnap) {
    const Swing exact(50, 15360, 6.2), coarse(50, 480, 6.2), fine(50, 960, 6.2);
    ASSERT_GT(*std::max_element(exact.top.begin(), exact.top.end()), 1.8e6); // the snap is in it
    // 4: second order; 2: first.
    EXPECT_NEAR(coarse.tension_error(exact) / fine.tension_error(exact), 4, 0.4);
    EXPECT_NEAR(coarse.place_error(exact) / fine.place_error(exact), 4, 0.4);
}

TEST(Production, ConvergesWithTheSquareOfTheStepInWaterWithDampingAndADrivenEnd) {
    // The tank test's chain, driven round a quarter of its circle with 30 m of water under it: no link goes
    // slack and none lands, between steps or at all.
    Problem problem = tank(true);
    problem.environment.depth = 30;
    problem.line.damping_time = 1e-3;
    const auto top = problem.upper.motion;
    problem.upper.motion = [=](double time) { return Vec3(top(0) + 0.25 * (top(time) - top(0))); };
    const auto series = [&](double dt) { // top tension and height of the middle, 60 times in a second
        const auto chain = production(problem, 40, dt);
        std::vector<double> tension, height;
        for (int k = 1; k <= 60 * 24; ++k) {
            while (chain->time() < k / 60.0 - 0.5 * dt)
                chain->step();
            if (k < 60 * 21) continue; // the ramp is a corner in time
            tension.push_back(chain->tension(39));
            height.push_back(chain->position(20).z());
        }
        return std::pair(tension, height);
    };
    const auto error = [](const std::vector<double>& a, const std::vector<double>& b) {
        double sum = 0;
        for (std::size_t k = 0; k < a.size(); ++k)
            sum += (a[k] - b[k]) * (a[k] - b[k]);
        return std::sqrt(sum);
    };
    const auto exact = series(1.0 / 7680), coarse = series(1.0 / 240), fine = series(1.0 / 480);
    // 4: second order; 2: first, which damping known half a step late gave.
    EXPECT_NEAR(error(coarse.first, exact.first) / error(fine.first, exact.first), 4, 0.4);
    EXPECT_NEAR(error(coarse.second, exact.second) / error(fine.second, exact.second), 4, 0.4);
}

TEST(Production, StaysSecondOrderWhereTheStepChanges) {
    // 200 links: the step is divided ever finer as the chain comes taut.
    const Swing exact(200, 15360, 4), coarse(200, 120, 4), fine(200, 240, 4);
    EXPECT_LT(fine.place_error(exact) / coarse.place_error(exact), 1 / 2.5);
}

TEST(Production, NoStepOfAnExerciseBlowsUpASwing) {
    // As long a step as an exercise may have and as short links, through the snap and beyond: never twice the
    // tension that all the energy of the fall would give as stretch of the chain.
    Problem problem = swinging_chain(200, 1e4);
    for (const double dt : {1.0 / 15, 1.0 / 60, 1.0 / 240}) {
        const auto chain = production(problem, 1000, dt);
        double hardest = 0;
        while (chain->time() < 8) {
            chain->step();
            hardest = std::max(hardest, chain->tension(999));
        }
        const double mass = 1e4 + 0.5 * 200 * problem.line.mass_per_metre;
        const double all = std::sqrt(2 * mass * physics::kGravity * 200 * problem.line.stiffness / 200); // N
        EXPECT_LT(hardest, 2 * all) << dt;
        EXPECT_GT(hardest, 1e6) << dt;
    }
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
