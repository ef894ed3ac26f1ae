// The PBD baseline as a whole.

#include "tests/lab/problems.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace windlass::lab {
namespace {

std::unique_ptr<Method> make(const Problem& problem, int links, double dt,
                             const MethodSettings& settings = {}) {
    return make_method(method_named("pbd"), problem, links, dt, settings);
}

void run(Method& method, double until) {
    while (method.time() < until - 1e-9)
        method.step();
}

TEST(Pbd, HasThePublishedSettings) {
    const MethodSettings settings;
    EXPECT_EQ(settings.k_stretch, 0.99);
    EXPECT_EQ(settings.k_bend, 0.02);
    EXPECT_EQ(settings.k_lra, 1);
    EXPECT_EQ(settings.k_pin, 1);
    EXPECT_EQ(settings.bend_iterations, 8);
    EXPECT_EQ(settings.lra_iterations, 3);
    EXPECT_EQ(settings.pin_iterations, 5);
    EXPECT_EQ(make(hanging_chain(100, 0), 10, 0.01)->iterations(), 10);
}

TEST(Pbd, WithManySweepsInSmallStepsSwingsAsTheDirectSolver) {
    const Problem problem = swinging_chain(200, 1e4);
    const auto truth = make_method(method_named("production"), problem, 20, 1.0 / 7680, {});
    run(*truth, 2);
    for (const bool coloured : {false, true}) {
        const auto chain =
            make(problem, 20, 1.0 / 960,
                 {.iterations = 200, .k_bend = 0, .pin_iterations = 200, .coloured = coloured});
        run(*chain, 2);
        // First order in the step: 0.02 m at 960 Hz on a way of 25 m.
        EXPECT_LT((chain->position(0) - truth->position(0)).norm(), 0.1);
    }
}

TEST(Pbd, WithManySweepsShowsTheWeightBelowInItsMultipliers) {
    const Problem problem = hanging_chain(100, 0);
    const auto chain = make(problem, 10, 1.0 / 60, {.iterations = 2000, .k_bend = 0, .lra_iterations = 0});
    run(*chain, 0.5);
    const double weight = problem.line.mass_per_metre * physics::kGravity;
    for (int i = 0; i < 10; ++i) // k 0.99 takes nearly all: the sweeps have converged to 1e-6
        EXPECT_NEAR(chain->tension(i) / (weight * (10 * i + 5)), 1, 1e-4) << i;
}

TEST(Pbd, BoundsTheDistanceToTheHawseByTheLongRangeAttachment) {
    const auto chain = make(swinging_chain(200, 1e4), 100, 1.0 / 60);
    while (chain->time() < 8) {
        chain->step();
        // The sweeps over pin and links come after the attachment and may draw a particle out again a little.
        for (int i = 0; i <= 100; ++i)
            ASSERT_LT(chain->position(i).norm(), 2 * (100 - i) + 1) << i << " at " << chain->time();
    }
}

TEST(Pbd, LandsOnTheFlatBedAndStaysThere) {
    Problem problem = chain_in_air(40);
    problem.environment.depth = 10;
    problem.lower.kind = EndKind::free;
    problem.start = [](double s) { return Vec3(0.3 * (40 - s), 0, -9.5 * (40 - s) / 40); };
    const auto chain = make(problem, 80, 1.0 / 60);
    run(*chain, 6);
    for (int i = 0; i <= 80; ++i)
        EXPECT_GE(chain->position(i).z(), -10 - 1e-8) << i;
    EXPECT_NEAR(chain->position(10).z(), -10, 1e-8);
}

TEST(Pbd, HangsItsChainOverAHawseLipOfTriangles) {
    // A drum along y, over which the chain is led.
    Obstacle lip;
    lip.material.friction = 0.2;
    for (int k = 0; k <= 24; ++k) {
        const double turn = k * std::numbers::pi / 12;
        for (const double y : {-2.0, 2.0})
            lip.corners.emplace_back(1 + std::sin(turn - std::numbers::pi / 2), y,
                                     std::cos(turn - std::numbers::pi / 2) - 1);
    }
    for (int k = 0; k < 24; ++k) {
        lip.triangles.push_back({2 * k, 2 * k + 2, 2 * k + 1});
        lip.triangles.push_back({2 * k + 1, 2 * k + 2, 2 * k + 3});
    }
    Problem problem = chain_in_air(20);
    problem.lower.kind = EndKind::free;
    problem.upper.kind = EndKind::fixed;
    problem.start = [](double s) { return Vec3(20 - s - 3, 0, 0.02); };
    problem.obstacles = {lip};
    const auto chain = make(problem, 100, 1.0 / 120);
    double lowest = 0;
    while (chain->time() < 5) {
        chain->step();
        lowest = std::min(lowest, chain->position(0).z());
        for (int i = 0; i <= 100; ++i) {
            const Vec3 p = chain->position(i);
            // Within the drum, less the flats of its faces.
            ASSERT_GT(std::hypot(p.x() - 1, p.z() + 1), std::cos(std::numbers::pi / 24) - 1e-6)
                << i << " at " << chain->time();
        }
    }
    EXPECT_LT(lowest, -10); // it does hang over it
}

TEST(Pbd, PilesUpWithSelfCollisionAndKeepsTwoRadii) {
    Problem problem = chain_in_air(12);
    problem.environment.depth = 8;
    problem.lower.kind = problem.upper.kind = EndKind::free;
    problem.start = [](double s) { return Vec3(0.02 * std::sin(9 * s), 0.02 * std::cos(7 * s), s - 7.9); };
    const auto min = [&](bool self_collision) {
        const auto chain = make(problem, 60, 1.0 / 120, {.self_collision = self_collision});
        run(*chain, 6);
        double nearest = 1e9;
        for (int i = 0; i <= 60; ++i)
            for (int j = i + 2; j <= 60; ++j)
                nearest = std::min(nearest, (chain->position(j) - chain->position(i)).norm());
        return nearest / 0.2; // 2 radii
    };
    EXPECT_GT(min(true), 0.9); // sweeps are not a solution: a heap is pressed together a little
    EXPECT_LT(min(false), 0.5);
}

TEST(Pbd, BendsAFallingChainToItsRestAngle) {
    Problem problem = chain_in_air(20);
    problem.lower.kind = problem.upper.kind = EndKind::free;
    problem.start = [](double s) { return Vec3(s, 0, 0); };
    for (const double rest : {0.0, 0.2}) {
        const auto chain = make(problem, 20, 1.0 / 120,
                                {.k_bend = 0.1, .bend_by_angle = true, .rest_angle = rest, .k_slack = 0.99});
        run(*chain, 3); // nothing damps an arc but the method: it swings about its rest
        double mean = 0;
        for (int i = 1; i < 20; ++i) {
            const Vec3 into = chain->position(i) - chain->position(i - 1),
                       out = chain->position(i + 1) - chain->position(i);
            mean += std::atan2(into.cross(out).norm(), into.dot(out)) / 19;
        }
        EXPECT_NEAR(mean, rest, 0.1 * rest + 1e-9);
    }
}

TEST(Pbd, PinDampingAloneTakesTheSpeedOfEveryStep) {
    Problem problem = swinging_chain(10, 1e9); // too heavy to be moved
    problem.lower.weight = 0;
    problem.upper.kind = EndKind::free;
    const auto chain =
        make(problem, 5, 1.0 / 60, {.k_stretch = 0, .k_bend = 0, .k_pin = 0, .pin_damping = 1});
    run(*chain, 1);
    // Each step begins at rest and falls g dt^2; without damping it would be g / 2 and half a step's more.
    EXPECT_NEAR(chain->position(0).z(), -60 * physics::kGravity / 3600, 1e-4);
    EXPECT_NEAR(chain->position(5).z(), -physics::kGravity * (0.5 + 0.5 / 60), 1e-6);
}

TEST(Methods, RefuseObstaclesThatTheyDoNotKnow) {
    Problem problem = hanging_chain(50, 0);
    problem.obstacles.emplace_back();
    int able = 0;
    for (const MethodEntry& entry : methods()) {
        if (entry.does_obstacles) {
            EXPECT_NO_THROW(make_method(entry, problem, 10, 0.01, {})) << entry.name;
            ++able;
        } else {
            EXPECT_THROW(make_method(entry, problem, 10, 0.01, {}), std::invalid_argument) << entry.name;
        }
    }
    EXPECT_GE(able, 1);
}

} // namespace
} // namespace windlass::lab
