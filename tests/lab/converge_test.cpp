// The projection of one step, by Newton's method and by PBD's sweeps.

#include "bench/lab/convergence/converge.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace windlass::lab {
namespace {

const std::filesystem::path kCases = WINDLASS_CASES_DIR;

StepProblem swing_step(int particles, double dt) {
    return step_problem(load_case(kCases / "swing.json"), particles, 3, dt);
}

double worst_link(const StepProblem& problem, const Field& places) {
    double worst = 0;
    for (std::size_t i = 0; i < problem.rest.size(); ++i) {
        const int k = static_cast<int>(i);
        const double length = (places.at(k + 1) - places.at(k)).norm();
        worst = std::max(worst, std::abs(length / problem.rest[i] - 1));
    }
    return worst;
}

TEST(StepProblem, BreaksItsLinksByThePredictionAlone) {
    const StepProblem problem = swing_step(51, 1.0 / 60);
    EXPECT_LT(worst_link(problem, problem.before), 1e-12);
    EXPECT_GT(worst_link(problem, problem.predicted), 1e-5);
    EXPECT_EQ(problem.predicted.at(50), problem.before.at(50)); // the held end
}

TEST(NewtonProjection, ReachesTheLinksLengthsQuadratically) {
    const StepProblem problem = swing_step(51, 1.0 / 60);
    for (const auto along : {NewtonProjection::Along::start, NewtonProjection::Along::now}) {
        NewtonProjection projection(problem, along);
        double before = worst_link(problem, problem.predicted);
        const double constant = 2e3; // of error(k + 1) <= constant error(k)^2: 50 links add theirs
        for (int k = 0; k < 6; ++k) {
            projection.iterate();
            const double now = worst_link(problem, projection.places());
            EXPECT_LT(now, std::max(constant * before * before, 1e-12)) << k;
            before = now;
        }
        EXPECT_LT(before, 1e-12);
    }
}

TEST(NewtonProjection, KeepsHeldEndsAndMomentumOfAFreeLine) {
    StepProblem problem = swing_step(21, 1.0 / 60);
    problem.inverse_mass.back() = problem.inverse_mass[10]; // nothing holds it now
    NewtonProjection projection(problem, NewtonProjection::Along::now);
    for (int k = 0; k < 10; ++k)
        projection.iterate();
    Vec3 moved = Vec3::Zero();
    for (int i = 0; i <= 20; ++i)
        moved += (projection.places().at(i) - problem.predicted.at(i)) / problem.inverse_mass[i];
    EXPECT_LT(moved.norm(), 1e-8); // kg m, of 35 t that moved by up to millimetres
}

TEST(Converge, SweepsAndNewtonEndInTheSamePlaceWhereTheStepIsShort) {
    const auto curves = converge(swing_step(21, 1.0 / 600), 0.99, 3000);
    ASSERT_EQ(curves.size(), 5U);
    for (const ConvergeCurve& curve : curves) {
        const bool newton = curve.method.starts_with("Newton");
        EXPECT_LT(curve.limit_distance, curve.method == "Newton, along start" ? 0.5 : 0.01) << curve.method;
        for (const ConvergePoint& point : curve.points) {
            if (newton && point.iterations >= 5) {
                EXPECT_LT(point.error, 1e-8) << curve.method;
            }
            if (!newton && point.iterations <= 10) {
                EXPECT_GT(point.error, 0.1) << curve.method;
            }
        }
    }
}

TEST(Converge, CurvesComeBackFromTheirFile) {
    const std::filesystem::path file = testing::TempDir() + "/converge.csv";
    write_converge(file, {{"swing, 10 t", "PBD, up", {{1, 0.5, 1e-4}, {12, 1e-3, 2e-3}}, 0.25}}, {"there"});
    EXPECT_EQ(read_notes(file), Notes{"there"});
    const auto curves = read_converge(file);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(curves[0].problem, "swing, 10 t");
    EXPECT_EQ(curves[0].method, "PBD, up");
    EXPECT_EQ(curves[0].limit_distance, 0.25);
    ASSERT_EQ(curves[0].points.size(), 2U);
    EXPECT_EQ(curves[0].points[1].iterations, 12);
    EXPECT_EQ(curves[0].points[1].error, 1e-3);
    EXPECT_NEAR(curves[0].points[1].seconds, 2e-3, 1e-15);
    EXPECT_TRUE(read_converge(file.string() + ".none").empty());
}

} // namespace
} // namespace windlass::lab
