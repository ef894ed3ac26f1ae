// The first half of the rivals against what each of them must get right: the leapfrog, PBD, XPBD, the direct
// solve with the gradient at the end of the step.

#include "tests/lab/problems.hpp"
#include "tests/lab/tank.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::lab {
namespace {

std::unique_ptr<Method> make(const std::string& name, const Problem& problem, int links, double dt,
                             const MethodSettings& settings = {}) {
    return method_named(name).make(problem, links, dt, settings);
}

void run(Method& method, double until) {
    while (method.time() < until - 1e-9)
        method.step();
}

/// Place of the anchor in the swing after 2 s, before any snap.
Vec3 swung(const std::string& name, double dt, const MethodSettings& settings = {}) {
    const auto chain = make(name, swinging_chain(200, 1e4), 20, dt, settings);
    run(*chain, 2);
    return chain->position(0);
}

/// The same without error: production converged to 0.1 mm.
Vec3 swung_truly() {
    static const Vec3 place = swung("production", 1.0 / 7680);
    return place;
}

/// N, what hangs below the middle of the topmost link of hanging_chain().
double load_at_top(const Problem& problem, int links) {
    const double weight = problem.line.mass_per_metre * physics::kGravity;
    return problem.lower.weight + weight * problem.length * (links - 0.5) / links;
}

/// Runs a swing through the snap; fails where a node leaves the circle of the taut chain.
void expect_bounded_swing(const std::string& name, double dt) {
    const auto chain = make(name, swinging_chain(200, 1e4), 20, dt);
    while (chain->time() < 10) {
        chain->step();
        for (int i = 0; i <= 20; ++i) {
            ASSERT_LT(chain->position(i).norm(), 210) << name << " at " << chain->time() << " s";
            ASSERT_LT(chain->position(i).z(), 5) << name << " at " << chain->time() << " s";
        }
    }
}

TEST(Leapfrog, HangsWithTheWeightBelowAtEveryLink) {
    const Problem problem = hanging_chain(100, 9900);
    const auto chain = make("leapfrog", problem, 50, 0.01);
    run(*chain, 5);
    EXPECT_NEAR(chain->tension(49) / load_at_top(problem, 50), 1, 1e-4);
    EXPECT_NEAR(chain->velocity(25).norm(), 0, 1e-2);
}

TEST(Leapfrog, SwingsAsTheDirectSolver) {
    EXPECT_LT((swung("leapfrog", 0.01) - swung_truly()).norm(), 1e-3);
    expect_bounded_swing("leapfrog", 1.0 / 480);
}

TEST(Leapfrog, ConvergesWithTheSquareOfTheStep) {
    const MethodSettings undivided{.iterations = 1};
    const Vec3 exact = swung("leapfrog", 1.0 / 16000, undivided);
    const double coarse = (swung("leapfrog", 1.0 / 500, undivided) - exact).norm();
    const double fine = (swung("leapfrog", 1.0 / 1000, undivided) - exact).norm();
    EXPECT_GT(coarse / fine, 3.4); // 4: second order; 2: first
    EXPECT_LT(coarse / fine, 4.6);
}

TEST(Leapfrog, IsUnstableJustAboveItsStableStepAndStableJustBelow) {
    const Problem problem = hanging_chain(100, 9900);
    const double limit =
        2 / std::sqrt(problem.line.stiffness / problem.line.mass_per_metre); // l / c, l = 2 m
    const auto above = make("leapfrog", problem, 50, 1.03 * limit, {.iterations = 1});
    const auto below = make("leapfrog", problem, 50, 0.99 * limit, {.iterations = 1});
    run(*above, 10);
    run(*below, 10);
    const double load = load_at_top(problem, 50);
    EXPECT_FALSE(std::abs(above->tension(49) / load - 1) < 0.1);
    EXPECT_NEAR(below->tension(49) / load, 1, 1e-3);
}

TEST(Leapfrog, DividesItsStepForStructuralDamping) {
    Problem problem = hanging_chain(100, 9900);
    problem.line.damping_time = 2e-3;
    const auto chain = make("leapfrog", problem, 50, 0.01);
    EXPECT_GT(chain->iterations(), 3 * make("leapfrog", hanging_chain(100, 9900), 50, 0.01)->iterations());
    run(*chain, 5);
    EXPECT_NEAR(chain->tension(49) / load_at_top(problem, 50), 1, 1e-4);
}

TEST(Leapfrog, SnapsAsTheMeasuredChainInTheTank) {
    const auto chain = make("leapfrog", tank(true), 40, 0.001); // at 0.002 it rings: 85 N
    const TankFigures figures = measure_in_tank(*chain);
    EXPECT_NEAR(figures.largest / 72.7, 1, 0.04);
    EXPECT_NEAR(figures.mean / 26.45, 1, 0.07);
    EXPECT_NEAR(figures.slack, 20.7, 5);
}

} // namespace
} // namespace windlass::lab
