// Contacts of the PBD baseline with planes and meshes.

#include "bench/methods/pbd_obstacles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace windlass::lab {
namespace {

constexpr double kRounding = 1e-8; ///< m; the contacts leave 1e-9

Obstacle ground(const SurfaceMaterial& material = {}) {
    Obstacle plane;
    plane.material = material;
    return plane;
}

/// A box of the given half side about the origin, its triangles' corners counterclockwise from outside;
/// turned inside out it is a room.
Obstacle box(double half, bool room, const SurfaceMaterial& material = {}) {
    Obstacle mesh;
    mesh.material = material;
    for (int k = 0; k < 8; ++k)
        mesh.corners.emplace_back(k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? half : -half);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    if (room)
        for (auto& t : mesh.triangles)
            std::swap(t[1], t[2]);
    return mesh;
}

/// One free particle that steps under gravity as PBD does.
struct Particle {
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero(), gravity = Vec3(0, 0, -9.81);

    void step(const PbdObstacles& obstacles, double dt) {
        Field from(1), to(1);
        from.set(0, position);
        to.set(0, position + dt * (velocity + dt * gravity));
        std::vector<PbdContact> contacts;
        obstacles.find(from, to, {1}, dt, contacts);
        for (int round = 0; round < 10; ++round)
            obstacles.project(contacts, from, to);
        obstacles.guard(from, to, {1});
        velocity = (to.at(0) - position) / dt;
        position = to.at(0);
    }
};

class Fast : public testing::TestWithParam<double> {}; ///< thickness, m

TEST_P(Fast, ParticlesNeverTunnelThroughAPlane) {
    const PbdObstacles obstacles({ground({.thickness = GetParam()})}, 0);
    for (const double speed : {1.0, 1e3, 1e6}) {
        Particle particle{.position = {0, 0, 3}, .velocity = {5, 0, -speed}};
        for (int k = 0; k < 300; ++k)
            particle.step(obstacles, 1.0 / 60);
        EXPECT_NEAR(particle.position.z(), GetParam(), kRounding) << speed;
    }
}

/// A thousand shots in all directions from within a room, also into its edges and corners: none gets out.
TEST_P(Fast, ParticlesNeverTunnelOutOfARoomOfTriangles) {
    const PbdObstacles obstacles({box(1, true, {.thickness = GetParam(), .friction = 0.3})}, 0);
    std::mt19937 random(3);
    std::normal_distribution<double> some;
    const double wall = 1 - GetParam() + kRounding;
    int at_wall = 0;
    for (int shot = 0; shot < 1000; ++shot) {
        Particle particle{.velocity = 100 * Vec3(some(random), some(random), some(random))};
        if (shot % 10 == 0) particle.velocity = {300, 300, shot % 20 == 0 ? 300.0 : 0}; // at edge and corner
        for (int k = 0; k < 20; ++k)
            particle.step(obstacles, 1.0 / 60);
        ASSERT_LE(particle.position.cwiseAbs().maxCoeff(), wall) << "shot " << shot;
        at_wall += particle.position.cwiseAbs().maxCoeff() > wall - 0.01;
    }
    EXPECT_GT(at_wall, 900); // they were shot at it
}

TEST_P(Fast, ParticlesNeverTunnelIntoABoxOfTriangles) {
    const PbdObstacles obstacles({box(1, false, {.thickness = GetParam()})}, 0);
    std::mt19937 random(5);
    std::normal_distribution<double> some;
    int met = 0;
    for (int shot = 0; shot < 1000; ++shot) {
        const Vec3 start = 3 * Vec3(some(random), some(random), some(random)).normalized();
        const Vec3 aim = 0.7 * Vec3(some(random), some(random), some(random)).normalized();
        Particle particle{.position = start, .velocity = 200 * (aim - start), .gravity = Vec3::Zero()};
        for (int k = 0; k < 20; ++k) {
            const Vec3 before = particle.velocity;
            particle.step(obstacles, 1.0 / 60);
            met += (particle.velocity - before).norm() > 1;
            ASSERT_GE(particle.position.cwiseAbs().maxCoeff(), 1 + GetParam() - kRounding)
                << "shot " << shot << ", step " << k;
        }
    }
    EXPECT_GT(met, 900);
}

std::string sign_name(const testing::TestParamInfo<double>& entry) {
    return entry.param > 0 ? "positive" : entry.param < 0 ? "negative" : "zero";
}

INSTANTIATE_TEST_SUITE_P(Thickness, Fast, testing::Values(0.0, 0.1, -0.1), sign_name);

TEST(Obstacles, KeepParticlesAtThicknessAndRestDistanceTogether) {
    for (const double thickness : {0.2, 0.0, -0.2}) {
        for (const bool mesh : {false, true}) {
            const SurfaceMaterial material{.thickness = thickness};
            const PbdObstacles obstacles({mesh ? box(1, false, material) : ground(material)}, 0.15);
            Particle particle{.position = {0.1, 0.2, 2}};
            for (int k = 0; k < 120; ++k)
                particle.step(obstacles, 1.0 / 60);
            EXPECT_NEAR(particle.position.z(), (mesh ? 1 : 0) + thickness + 0.15, kRounding);
        }
    }
}

/// Distance that a particle slides on a slope in a time, m, against Coulomb's law.
double slid(double degrees, double friction, double seconds) {
    const double angle = degrees * std::numbers::pi / 180;
    Obstacle slope = ground({.friction = friction});
    slope.normal = {std::sin(angle), 0, std::cos(angle)};
    const PbdObstacles obstacles({slope}, 0);
    Particle particle;
    for (int k = 0; k < std::lround(seconds * 240); ++k)
        particle.step(obstacles, 1.0 / 240);
    return particle.position.norm();
}

TEST(Obstacles, HoldAParticleWithinTheFrictionCone) {
    EXPECT_LT(slid(30, std::tan(31 * std::numbers::pi / 180), 2), 1e-9);
}

TEST(Obstacles, LetAParticleSlideOutsideTheFrictionConeByCoulombsLaw) {
    const double friction = std::tan(20 * std::numbers::pi / 180), angle = std::numbers::pi / 6;
    const double acceleration = 9.81 * (std::sin(angle) - friction * std::cos(angle));
    // Forward Euler comes half a step's speed further: 1/480 of 2 s.
    EXPECT_NEAR(slid(30, friction, 2) / (0.5 * acceleration * 4), 1, 0.003);
}

/// Height lost under a ceiling of the given stickiness in a second, m.
double fallen(double stickiness, double pull) {
    Obstacle ceiling = ground({.stickiness = stickiness});
    ceiling.normal = {0, 0, -1};
    const PbdObstacles obstacles({ceiling}, 0);
    Particle particle{.gravity = {0, 0, -pull}};
    for (int k = 0; k < 60; ++k)
        particle.step(obstacles, 1.0 / 60);
    return -particle.position.z();
}

TEST(Obstacles, StickUntilPulledHarderThanTheirStickiness) {
    EXPECT_NEAR(fallen(10, 9.81), 0, kRounding);
    EXPECT_GT(fallen(9, 9.81), 1);
    EXPECT_GT(fallen(0, 9.81), 4);
}

TEST(Obstacles, LetParticlesThroughFromBehind) {
    Obstacle sheet;
    sheet.corners = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    sheet.triangles = {{0, 1, 2}};
    const PbdObstacles obstacles({sheet}, 0);
    Particle rising{.position = {0, 0, -1}, .velocity = {0, 0, 60}, .gravity = Vec3::Zero()};
    Particle beside{.position = {5, 0, 1}, .velocity = {0, 0, -60}, .gravity = Vec3::Zero()};
    for (int k = 0; k < 10; ++k)
        rising.step(obstacles, 1.0 / 60), beside.step(obstacles, 1.0 / 60);
    EXPECT_NEAR(rising.position.z(), 9, kRounding);
    EXPECT_NEAR(beside.position.z(), -9, kRounding);
}

} // namespace
} // namespace windlass::lab
