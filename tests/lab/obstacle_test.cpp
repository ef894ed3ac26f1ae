// Obstacles in case files.

#include "bench/lab/case/case.hpp"
#include "bench/lab/case/run.hpp"
#include "common/json_file.hpp"
#include "tests/lab/problems.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace windlass::lab {
namespace {

const std::filesystem::path kFile = std::filesystem::path(WINDLASS_CASES_DIR) / "hawse_lip.json";

std::string refusal(const std::string& assignment) {
    try {
        load_case(kFile, {assignment});
        return "";
    } catch (const ConfigError& error) {
        return error.what();
    }
}

TEST(ObstacleCase, IsReadWithItsMaterial) {
    const Case given = load_case(kFile, {"obstacles.1.normal=[0, 0, 5]"});
    ASSERT_EQ(given.problem.obstacles.size(), 2U);
    const Obstacle &ship = given.problem.obstacles[0], &mud = given.problem.obstacles[1];
    EXPECT_FALSE(ship.is_plane());
    EXPECT_EQ(ship.triangles.size(), 16U);
    EXPECT_EQ(ship.material.thickness, 0.05);
    EXPECT_TRUE(mud.is_plane());
    EXPECT_EQ(mud.normal, Vec3::UnitZ());
    EXPECT_EQ(mud.material.stickiness, 2);
}

TEST(ObstacleCase, IsRefusedWithPlaceValueAndWhatIsAllowed) {
    EXPECT_EQ(refusal("obstacles.1.friction=0.4"), "");
    EXPECT_NE(refusal("obstacles.1.normal=[0, 0, 0]")
                  .find("/obstacles/1/normal: [0,0,0] is not allowed: a direction"),
              std::string::npos);
    EXPECT_NE(refusal("obstacles.0.triangles.2=[0, 1, 99]").find("/obstacles/0/triangles/2: [0,1,99] is not"),
              std::string::npos);
    EXPECT_NE(refusal("obstacles.0.triangles.2=[0, 1, 1]").find("do not lie on one line"), std::string::npos);
    EXPECT_NE(refusal("obstacles.0.point=[0, 0, 0]").find("/obstacles/0/point: "), std::string::npos);
    EXPECT_NE(refusal("obstacles.1.friction=-1").find("/obstacles/1/friction: -1"), std::string::npos);
}

TEST(ObstacleCase, EndsWithTheChainOverTheLipAndOnTheMud) {
    const Case given = load_case(kFile);
    const RunResult result = run_case(given, method_named("pbd"), given.links, given.dt);
    EXPECT_TRUE(result.finite);
    EXPECT_NEAR(result.series.columns[3].back(), -12, 1e-6);
    EXPECT_GT(result.series.columns[2].back(), 1); // not within the ship
    for (const double z : result.series.columns[3])
        ASSERT_GT(z, -12 - 1e-6);
}

TEST(ObstacleCase, ProductionCarriesOverTheLipWhatHangsThere) {
    // 12.05 m from the lip's height to the mud; friction of 0.2 over a quarter turn and the deck may hold
    // some of it back, or more.
    const Case given = load_case(kFile);
    const RunResult result = run_case(given, method_named("production"), 28, given.dt);
    EXPECT_TRUE(result.finite);
    const double weight = 12.05 * 126.5 * physics::kGravity, capstan = std::exp(0.2 * 0.5 * std::numbers::pi);
    EXPECT_GT(result.series.columns[1].back(), weight / capstan);
    EXPECT_LT(result.series.columns[1].back(), weight * capstan);
    EXPECT_NEAR(result.series.columns[3].back(), -12, 1e-3); // what lies on mud is pressed in
    EXPECT_GT(result.series.columns[2].back(), 1);           // not within the ship
}

TEST(ObstacleCase, ProductionWantsAMeshOfSomeThickness) {
    const Case given = load_case(kFile, {"obstacles.0.thickness=0"});
    EXPECT_THROW(run_case(given, method_named("production"), 28, given.dt), std::invalid_argument);
}

} // namespace
} // namespace windlass::lab
