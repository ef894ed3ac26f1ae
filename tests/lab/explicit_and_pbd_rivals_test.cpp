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

/// The place errs with the step or with its square: their ratio of errors when the step is halved.
double halving(const std::string& name, double dt, const MethodSettings& settings = {}) {
    const Vec3 exact = swung_truly();
    return (swung(name, dt, settings) - exact).norm() / (swung(name, dt / 2, settings) - exact).norm();
}

TEST(Xpbd, HangsWithTheWeightBelowWithoutCalibration) {
    const Problem problem = hanging_chain(100, 9900);
    for (const int links : {10, 50}) {
        const auto chain = make("xpbd_small_steps", problem, links, 1e-4);
        run(*chain, 2);
        EXPECT_NEAR(chain->tension(links - 1) / load_at_top(problem, links), 1, 0.01) << links;
    }
}

TEST(Xpbd, ComesTrueWithMoreIterationsInTheSameStep) {
    // The same step, so that only what the sweeps leave undone differs. Their limit is the direct solve.
    const auto place = [](const std::string& name, int iterations) {
        const auto chain = make(name, swinging_chain(200, 1e4), 100, 1.0 / 60, {.iterations = iterations});
        run(*chain, 1);
        return chain->position(0);
    };
    const Vec3 limit = place("direct_end", 0);
    const double few = (place("xpbd", 10) - limit).norm(), many = (place("xpbd", 10000) - limit).norm();
    EXPECT_GT(few, 100 * many);
    EXPECT_LT(many, 1e-3);
}

TEST(Xpbd, IsFirstOrderInSmallSteps) {
    EXPECT_NEAR(halving("xpbd_small_steps", 1e-3), 2, 0.3);
    expect_bounded_swing("xpbd_small_steps", 1.0 / 1000);
    expect_bounded_swing("xpbd", 1.0 / 240);
}

TEST(Xpbd, SnapsNearlyAsTheMeasuredChainInTheTank) {
    const auto chain = make("xpbd_small_steps", tank(true), 40, 2e-4);
    const TankFigures figures = measure_in_tank(*chain);
    EXPECT_NEAR(figures.largest / 72.7, 1, 0.05);
    EXPECT_NEAR(figures.mean / 26.45, 1, 0.07);
    EXPECT_NEAR(figures.slack, 20.7, 5);
}

TEST(DirectEnd, HangsWithTheWeightBelowAtAnyStep) {
    const Problem problem = hanging_chain(100, 9900);
    for (const double dt : {1.0 / 15, 1.0 / 60, 1.0 / 480}) {
        const auto chain = make("direct_end", problem, 50, dt);
        run(*chain, 2);
        EXPECT_NEAR(chain->tension(49) / load_at_top(problem, 50), 1, 1e-4) << dt;
        EXPECT_NEAR(chain->tension(0) /
                        (problem.lower.weight + 1 * problem.line.mass_per_metre * physics::kGravity),
                    1, 1e-3)
            << dt;
    }
}

TEST(DirectEnd, IsFirstOrderAndDamps) {
    EXPECT_NEAR(halving("direct_end", 1.0 / 240), 2, 0.2);
    expect_bounded_swing("direct_end", 1.0 / 60);
}

TEST(DirectEnd, LeavesASlackLineWithoutPullOnTheBed) {
    // 30 m of chain dropped onto the seabed in a bow between two ends 20 m apart.
    Problem problem = chain_in_air(30);
    problem.environment.depth = 2;
    problem.environment.water_density = physics::kSeaWaterDensity;
    problem.start = [](double s) { return Vec3(20 * s / 30, 3.4 * std::sin(3 * 3.14159265 * s / 30), -1.9); };
    const auto chain = make("direct_end", problem, 60, 1.0 / 240);
    run(*chain, 20);
    for (int i = 2; i < 58; ++i) {
        EXPECT_LT(chain->tension(i), 1500) << i; // less than a metre's friction or so
        EXPECT_NEAR(chain->position(i).z(), -2, 0.1) << i;
    }
}

TEST(DirectEnd, SnapsNearlyAsTheMeasuredChainInTheTank) {
    const auto chain = make("direct_end", tank(true), 40, 5e-4);
    const TankFigures figures = measure_in_tank(*chain);
    EXPECT_NEAR(figures.largest / 72.7, 1, 0.05);
    EXPECT_NEAR(figures.mean / 26.45, 1, 0.07);
    EXPECT_NEAR(figures.slack, 20.7, 5);
}

TEST(RivalsOne, RefuseADrivenEndWithoutMotion) {
    Problem problem = hanging_chain(50, 0);
    problem.upper.kind = EndKind::driven;
    for (const char* name : {"leapfrog", "xpbd", "xpbd_small_steps", "direct_end"})
        EXPECT_THROW(make(name, problem, 10, 0.01), std::invalid_argument) << name;
}

} // namespace
} // namespace windlass::lab
