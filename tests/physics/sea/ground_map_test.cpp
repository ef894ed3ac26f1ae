// The ground by itself: heights, normals, soils, and the force that it makes of them.

#include "server/physics/sea/ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace windlass::physics {
namespace {

/// A grid of hills and holes on a slope, with soils in no order.
GroundDef rough_ground(unsigned seed) {
    std::mt19937 random(seed);
    GroundDef def{
        .slope = 0.1, .slope_towards = 2, .west = -40, .south = -30, .spacing = 5, .columns = 17, .rows = 13};
    for (int k = 0; k < def.columns * def.rows; ++k) {
        def.heights.push_back(std::uniform_real_distribution<double>(-3, 3)(random));
        def.soils.push_back(static_cast<Soil>(std::uniform_int_distribution<int>(0, 6)(random)));
    }
    return def;
}

EnvironmentDef rough_sea(unsigned seed) {
    EnvironmentDef sea;
    lay_ground(sea, rough_ground(seed));
    return sea;
}

TEST(GroundMap, EvenGridIsThePlaneThatItsPointsLieIn) {
    GroundDef def{.west = -50, .south = -50, .spacing = 10, .columns = 11, .rows = 11};
    const auto plane = [](double x, double y) { return 0.2 * x - 0.1 * y + 1; };
    for (int r = 0; r < def.rows; ++r)
        for (int c = 0; c < def.columns; ++c)
            def.heights.push_back(plane(-50 + 10 * c, -50 + 10 * r));
    const Ground ground(def, {});
    const Vec3 up = Vec3(-0.2, 0.1, 1).normalized();
    for (double x = -39; x < 40; x += 3.7)
        for (double y = -39; y < 40; y += 4.3) {
            EXPECT_NEAR(ground.height(x, y), plane(x, y), 1e-12);
            EXPECT_LT((ground.normal(x, y) - up).norm(), 1e-12);
        }
}

TEST(GroundMap, SlopeGoesDownWhereItPoints) {
    EnvironmentDef sea;
    lay_ground(sea, {.slope = 0.3, .slope_towards = 0.5 * std::numbers::pi}); // east
    EXPECT_NEAR(bed_height(sea, 100, 30), -sea.depth - 100 * std::tan(0.3), 1e-9);
    EXPECT_NEAR(bed_normal(sea, 0, 0).x(), std::sin(0.3), 1e-12);
}

TEST(GroundMap, NormalIsThatOfTheHeightAndNeverJumps) {
    const EnvironmentDef sea = rough_sea(1);
    std::mt19937 random(2);
    const auto pick = [&](double max) { return std::uniform_real_distribution<double>(-max, max)(random); };
    for (int k = 0; k < 2000; ++k) {
        const double x = pick(60), y = pick(50), d = 1e-4; // beyond the edges, too
        const Vec3 n = bed_normal(sea, x, y);
        const double dx = (bed_height(sea, x + d, y) - bed_height(sea, x - d, y)) / (2 * d);
        const double dy = (bed_height(sea, x, y + d) - bed_height(sea, x, y - d)) / (2 * d);
        EXPECT_LT((n - Vec3(-dx, -dy, 1).normalized()).norm(), 1e-4); // curvature of at most 1/m, times d
        EXPECT_LT((n - bed_normal(sea, x + d, y + d)).norm(), 2e-3);
    }
}

TEST(GroundMap, BedLiesBetweenThePointsAround) {
    GroundDef def = rough_ground(3);
    def.slope = 0;
    const Ground ground(def, {});
    std::mt19937 random(4);
    const auto pick = [&](double max) { return std::uniform_real_distribution<double>(-max, max)(random); };
    for (int k = 0; k < 2000; ++k) {
        const double height = ground.height(pick(1000), pick(1000));
        EXPECT_LE(std::abs(height), 3);
        EXPECT_LE(height, ground.ceiling(0, 0));
    }
}

TEST(GroundMap, SoilIsThatOfTheNearestPoint) {
    const GroundDef def = rough_ground(5);
    const Ground ground(def, {});
    const auto at = [&](int c, int r) { return def.soils[static_cast<std::size_t>(r * def.columns + c)]; };
    EXPECT_EQ(ground.soil(-40 + 5 * 3 + 2.4, -30 + 5 * 7 - 2.4), at(3, 7));
    EXPECT_EQ(ground.soil(-1e4, 1e4), at(0, def.rows - 1));
    EXPECT_EQ(ground.soil(std::nan(""), 1e300), at(0, def.rows - 1)); // nothing, but no crash
}

TEST(GroundMap, ChainIsPushedDownTheGradientOfItsEnergy) {
    // U = k d^2 / 2 with what under() says; its force k d along the normal must be -grad U: else a chain that
    // goes round in a hollow or over a border of soils would gain by it.
    const EnvironmentDef sea = rough_sea(6);
    std::mt19937 random(7);
    const auto pick = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto energy = [&](const Vec3& at) {
        const BedUnder bed = bed_under(sea, at);
        return 0.5 * bed.stiffness * bed.penetration * bed.penetration;
    };
    for (int k = 0; k < 2000; ++k) {
        Vec3 at(pick(-60, 60), pick(-50, 50), 0);
        at.z() = bed_height(sea, at.x(), at.y()) - pick(0.01, 0.5);
        const BedUnder bed = bed_under(sea, at);
        const Vec3 force = bed.stiffness * bed.penetration * bed.normal;
        Vec3 slope;
        const double d = 1e-5;
        for (int axis = 0; axis < 3; ++axis)
            slope[axis] = (energy(at + d * Vec3::Unit(axis)) - energy(at - d * Vec3::Unit(axis))) / (2 * d);
        EXPECT_LT((force + slope).norm(), 1e-4 * force.norm()) << at.transpose(); // of differences at 1e-5 m
    }
}

TEST(GroundMap, LevelGridIsALevelBed) {
    EnvironmentDef level, grid;
    lay_ground(grid, {.west = -10, .south = -10, .spacing = 4, .columns = 5, .rows = 5});
    for (double x = -20; x < 20; x += 3.3) {
        const Vec3 at(x, 0.7 * x, -level.depth - 0.1);
        const BedUnder a = bed_under(level, at), b = bed_under(grid, at);
        EXPECT_DOUBLE_EQ(a.penetration, b.penetration);
        EXPECT_DOUBLE_EQ(a.stiffness, b.stiffness);
        EXPECT_DOUBLE_EQ(a.friction, b.friction);
        EXPECT_DOUBLE_EQ(bed_grip(level, at.x(), at.y()), bed_grip(grid, at.x(), at.y()));
        EXPECT_EQ(b.normal, Vec3::UnitZ());
    }
}

TEST(GroundMap, RefusesWhatDoesNotFit) {
    const EnvironmentDef sea;
    EXPECT_THROW(Ground({.columns = 3}, sea), std::invalid_argument);
    EXPECT_THROW(Ground({.spacing = 0, .columns = 3, .rows = 3}, sea), std::invalid_argument);
    EXPECT_THROW(Ground({.columns = 2, .rows = 2, .heights = {1, 2, 3}}, sea), std::invalid_argument);
    EXPECT_THROW(Ground({.columns = 2, .rows = 1, .soils = {Soil::mud}}, sea), std::invalid_argument);
    EXPECT_THROW(Ground({.slope = 1.5}, sea), std::invalid_argument);
}

} // namespace
} // namespace windlass::physics
