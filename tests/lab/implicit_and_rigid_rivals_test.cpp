// The second half of the rivals against what each of them must get right: the catenary, the lumped mass with
// Runge-Kutta, Bullet's rods, finite elements.

#include "tests/lab/problems.hpp"
#include "tests/lab/tank.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::lab {
namespace {

std::unique_ptr<Method> make(const std::string& name, const Problem& problem, int links, double dt,
                             MethodSettings settings = {}) {
    return method_named(name).make(problem, links, dt, settings);
}

void run(Method& method, double until) {
    while (method.time() < until - 1e-9)
        method.step();
}

/// N, what hangs below the middle of the topmost link of hanging_chain().
double load_at_top(const Problem& problem, int links) {
    const double weight = problem.line.mass_per_metre * physics::kGravity;
    return problem.lower.weight + weight * problem.length * (links - 0.5) / links;
}

struct Hang {
    const char* name;
    double dt, tolerance;
    int iterations = 0;
};

class Hanging : public testing::TestWithParam<Hang> {};

TEST_P(Hanging, ShowsTheWeightBelowAtTheTop) {
    const Hang& hang = GetParam();
    const Problem problem = hanging_chain(100, 9900);
    const auto chain = make(hang.name, problem, 50, hang.dt, {.iterations = hang.iterations});
    run(*chain, 5);
    EXPECT_NEAR(chain->tension(49) / load_at_top(problem, 50), 1, hang.tolerance);
}

// Bullet's rods settle from their straight, unstretched start; sweeps are not a solution.
INSTANTIATE_TEST_SUITE_P(Methods, Hanging,
                         testing::Values(Hang{"catenary", 0.1, 1e-9}, Hang{"lumped_rk4", 0.01, 1e-4},
                                         Hang{"implicit_fe", 0.01, 1e-4}, Hang{"bullet_links", 0.001, 0.01}),
                         [](const auto& entry) { return std::string(entry.param.name); });

/// The swing's place of the anchor after 2 s, before any snap, as production finds it.
Vec3 swung(const std::string& name, double dt) {
    const auto chain = make(name, swinging_chain(200, 1e4), 20, dt);
    run(*chain, 2);
    return chain->position(0);
}

TEST(LumpedRk4, SwingsAsTheDirectSolver) {
    EXPECT_LT((swung("lumped_rk4", 0.01) - swung("production", 1.0 / 7680)).norm(), 1e-3);
}

TEST(ImplicitFe, SwingsAsTheDirectSolver) {
    EXPECT_LT((swung("implicit_fe", 1e-3) - swung("production", 1.0 / 7680)).norm(), 1e-3);
}

TEST(ImplicitFe, ConvergesWithTheSquareOfTheStep) {
    const Vec3 exact = swung("implicit_fe", 1.0 / 7680);
    const double coarse = (swung("implicit_fe", 1.0 / 120) - exact).norm();
    const double fine = (swung("implicit_fe", 1.0 / 240) - exact).norm();
    EXPECT_GT(coarse / fine, 3.4); // 4: second order; 2: first
    EXPECT_LT(coarse / fine, 4.6);
}

TEST(BulletLinks, SwingsAsTheDirectSolver) {
    EXPECT_LT((swung("bullet_links", 1e-3) - swung("production", 1.0 / 7680)).norm(), 0.5);
}

TEST(Methods, SwingThroughTheSnapWithoutBlowingUp) {
    for (const char* name : {"lumped_rk4", "implicit_fe", "bullet_links"}) {
        const auto chain = make(name, swinging_chain(200, 1e4), 20, 1.0 / 480);
        while (chain->time() < 10) {
            chain->step();
            for (int i = 0; i <= 20; ++i) {
                ASSERT_LT(chain->position(i).norm(), 210) << name << " at " << chain->time() << " s";
                ASSERT_LT(chain->position(i).z(), 5) << name << " at " << chain->time() << " s";
            }
        }
    }
}

TEST(Catenary, HangsAtTheRestTensionOfTheTank) {
    const auto line = make("catenary", tank(false), 330, 0.1);
    EXPECT_NEAR(line->tension(329), 22.7, 0.01 * 22.7);
}

TEST(Catenary, LeadsToItsEndsAndKeepsItsLength) {
    Problem problem = chain_in_air(120);
    problem.environment.depth = 25;
    problem.environment.water_density = physics::kSeaWaterDensity;
    double before = 0;
    for (const double reach : {1.0, 80.0, 95.0, 105.0, 112.0, 116.0, 117.3, 118.0, 130.0}) {
        problem.start = [reach](double s) {
            return Vec3(0.6 * reach * s / 120, 0.8 * reach * s / 120, 25 * (s / 120 - 1));
        };
        const auto line = make("catenary", problem, 240, 0.1);
        EXPECT_LT((line->position(0) - Vec3(0, 0, -25)).norm(), 1e-6) << reach;
        EXPECT_LT((line->position(240) - Vec3(0.6 * reach, 0.8 * reach, 0)).norm(), 1e-6) << reach;
        EXPECT_GE(line->tension(239), before) << reach;
        before = line->tension(239);
        for (int i = 0; i < 240; ++i) {
            const double stretched = 0.5 * (1 + line->tension(i) / problem.line.stiffness);
            const double chord = (line->position(i + 1) - line->position(i)).norm();
            EXPECT_LE(chord, stretched * (1 + 1e-6)) << reach << ", link " << i;
            if (reach > 100) { // none in a heap
                EXPECT_NEAR(chord, stretched, 2e-4) << reach << ", link " << i;
            }
        }
    }
}

TEST(Catenary, SagsBetweenTwoHighEndsOntoTheBed) {
    Problem problem = chain_in_air(100);
    problem.environment.depth = 10;
    problem.environment.water_density = 1025;
    problem.start = [](double s) { return Vec3(0.85 * s, 0, 0); };
    const auto line = make("catenary", problem, 200, 0.1);
    for (int i = 0; i < 200; ++i)
        EXPECT_NEAR(line->tension(i), line->tension(199 - i), 1e-6 * line->tension(0));
    EXPECT_NEAR(line->position(100).z(), -10, 1e-9);
    EXPECT_NEAR(line->position(200).x(), 85, 1e-6);
    // Lifted to 10 m: T at the top less w h is H, which also holds the bed part.
    const double w = physics::weight_in_water(problem.line, 1025);
    EXPECT_NEAR(line->tension(199) - w * 9.75, line->tension(100), 0.01 * line->tension(199));
}

TEST(Catenary, RefusesALineThatNothingHolds) {
    Problem problem = hanging_chain(50, 0);
    problem.upper.kind = EndKind::free;
    EXPECT_THROW(make("catenary", problem, 10, 0.01), std::invalid_argument);
}

TEST(Methods, RefuseADrivenEndWithoutMotion) {
    Problem problem = hanging_chain(50, 0);
    problem.upper.kind = EndKind::driven;
    for (const char* name : {"catenary", "lumped_rk4", "implicit_fe", "bullet_links"})
        EXPECT_THROW(make(name, problem, 10, 0.01), std::invalid_argument) << name;
}

struct Tank {
    const char* name;
    double dt;
};

class InTank : public testing::TestWithParam<Tank> {};

TEST_P(InTank, SnapsAsTheMeasuredChain) {
    const auto chain = make(GetParam().name, tank(true), 40, GetParam().dt);
    const TankFigures figures = measure_in_tank(*chain);
    EXPECT_NEAR(figures.largest / 72.7, 1, 0.04);
    EXPECT_NEAR(figures.mean / 26.45, 1, 0.07); // MoorDyn 2.7.1 has 27.9
    EXPECT_NEAR(figures.slack, 20.7, 5);
}

INSTANTIATE_TEST_SUITE_P(Methods, InTank,
                         testing::Values(Tank{"lumped_rk4", 0.002}, Tank{"implicit_fe", 0.001}),
                         [](const auto& entry) { return std::string(entry.param.name); });

} // namespace
} // namespace windlass::lab
