// Case files: what they make, and how they are refused.

#include "bench/lab/case/case.hpp"
#include "bench/lab/case/motion.hpp"
#include "bench/lab/case/run.hpp"
#include "bench/lab/case/shapes.hpp"
#include "common/json_file.hpp"
#include "tests/lab/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace windlass::lab {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = WINDLASS_CASES_DIR;

/// What is said of a case with one field changed; "" when it is accepted.
std::string refusal(const std::string& file, const std::string& assignment) {
    try {
        load_case(kCases / file, {assignment});
        return "";
    } catch (const ConfigError& error) {
        return error.what();
    }
}

class ExampleTest : public testing::TestWithParam<const char*> {};

TEST_P(ExampleTest, RunsByTheProductionMethodAndStaysFinite) {
    Case given = load_case(kCases / GetParam());
    given.problem.duration = given.settle + std::min(1.0, given.problem.duration - given.settle);
    const RunResult result = run_case(given, method_named("production"), given.links, given.dt);
    EXPECT_TRUE(result.finite);
    EXPECT_EQ(result.series.names.size(), given.probes.size() + 1);
    EXPECT_NEAR(result.series.columns[0].back(), given.problem.duration - given.settle, given.dt);
    EXPECT_GT(result.series.rows(), 5U);
}

INSTANTIATE_TEST_SUITE_P(Cases, ExampleTest,
                         testing::Values("tank.json", "swing.json", "hang.json", "catenary.json", "snap.json",
                                         "let_go.json", "swell.json"));

TEST(Case, TankTestHasTheMeasuredFigures) {
    // Lindahl 1985: top tension at most 72.7 +- 0.8 N, mean 26.45 N, 20.7 % of the time below 2 N.
    const Case given = load_case(kCases / "tank.json");
    const RunResult result = run_case(given, method_named("production"), 40, 0.0005);
    double largest = 0, sum = 0, counted = 0, slack = 0;
    for (std::size_t i = 0; i < result.series.rows(); ++i) {
        if (result.series.columns[0][i] < 12.5) continue;
        const double tension = result.series.columns[1][i];
        largest = std::max(largest, tension);
        sum += tension, ++counted, slack += tension < 2 ? 1 : 0;
    }
    EXPECT_NEAR(largest / 72.7, 1, 0.03);
    EXPECT_NEAR(sum / counted / 26.45, 1, 0.06);
    EXPECT_NEAR(100 * slack / counted, 20.7, 4);
}

TEST(Case, SnapCannotBeHarderThanAStiffSpringAndSofterThanTheFallingWeight) {
    // A mass m that falls h onto a massless spring k pulls with m g + sqrt((m g)^2 + 2 m g h k).
    const Case given = load_case(kCases / "snap.json");
    const RunResult result = run_case(given, method_named("production"), 40, 0.0005);
    const double foot = *std::max_element(result.series.columns[2].begin(), result.series.columns[2].end());
    const double mass = 5000, weight = mass * physics::kGravity, k = 5.83e8 / 40;
    const double spring = weight + std::sqrt(weight * weight + 2 * weight * 40 * k);
    EXPECT_GT(foot, 0.5 * spring);
    EXPECT_LT(foot, 1.5 * spring); // the chain's own weight falls with it
}

TEST(Case, IsRefusedWithFilePlaceValueAndWhatIsAllowed) {
    EXPECT_NE(
        refusal("hang.json", "line.length=-5").find("/line/length: -5 is not allowed: a number above 0"),
        std::string::npos);
    EXPECT_NE(refusal("hang.json", "line.lenght=5").find("the nearest known one is \"length\""),
              std::string::npos);
    EXPECT_NE(refusal("hang.json", "upper.kind=driven").find("/upper/motion: nothing is not allowed"),
              std::string::npos);
    EXPECT_NE(refusal("hang.json", "upper.mass=3").find("/upper/mass: 3 is not allowed: this kind"),
              std::string::npos);
    EXPECT_NE(refusal("tank.json", "upper.motion.ramp=0").find("/upper/motion/ramp: "), std::string::npos);
    EXPECT_NE(refusal("tank.json", "reference.probe=tip").find("/reference/probe: \"tip\""),
              std::string::npos);
    EXPECT_NE(refusal("tank.json", "start.upper=[0, 0, 0.3]").find("/start: "), std::string::npos);
    EXPECT_NE(refusal("tank.json", "nonsense").find("FIELD=VALUE"), std::string::npos);
    EXPECT_EQ(refusal("tank.json", "line.length=34"), "");
}

TEST(Case, FilesItNamesAreReadAndRefusedByLine) {
    const fs::path folder = fs::temp_directory_path() / ("case_test_" + std::to_string(getpid()));
    fs::create_directory(folder);
    fs::copy(kCases / "tank.json", folder / "case.json");
    std::ofstream(folder / "motion.csv") << "t,x,y,z\n0,0,0,0\n1,0.5,0,0\n2,0.5,0,0.25\n";
    const std::vector<std::string> table{R"(upper.motion={"kind": "table", "file": "motion.csv"})",
                                         "settle=0"};
    const Case given = load_case(folder / "case.json", table);
    const Vec3 place = given.problem.start(33);
    EXPECT_LT((given.problem.upper.motion(1) - place - Vec3(0.5, 0, 0)).norm(), 1e-12);
    EXPECT_LT((given.problem.upper.motion(9) - place - Vec3(0.5, 0, 0.25)).norm(), 1e-12);

    std::ofstream(folder / "motion.csv") << "t,x,y,z\n0,0,0,0\n1,0.5,0,zero\n";
    try {
        load_case(folder / "case.json", table);
        ADD_FAILURE() << "accepted";
    } catch (const ConfigError& error) {
        EXPECT_NE(std::string(error.what()).find("line 3: \"zero\" is not allowed: a finite number"),
                  std::string::npos)
            << error.what();
    }
    fs::remove_all(folder);
}

TEST(Shape, CatenaryIsThatOfTheClosedForm) {
    // Inextensible, 200 kN along: s = sqrt(y^2 + 2 y a), x = a asinh(s / a), a = H / w.
    const double w = 1135, H = 2e5, a = H / w, height = 40, s = std::sqrt(height * (height + 2 * a));
    const double lying = 20, reach = lying + a * std::asinh(s / a);
    const Shape shape = catenary_shape(Vec3(0, 0, -40), Vec3(reach, 0, 0), {lying + s, w, 1e14}, true);
    EXPECT_LT((shape(lying + s) - Vec3(reach, 0, 0)).norm(), 1e-6);
    EXPECT_LT((shape(lying) - Vec3(lying, 0, -40)).norm(), 1e-3);
    const double up = 50;
    EXPECT_LT(
        (shape(lying + up) - Vec3(lying + a * std::asinh(up / a), 0, -40 + std::hypot(a, up) - a)).norm(),
        1e-3);
}

TEST(Shape, FoldedLineIsAsLongAsTheLineAndTurnsBelow) {
    const Shape shape = folded_shape({1, 0, 0}, {0, 0, 0}, 40, {0, 0, -1});
    double length = 0, lowest = 0;
    for (int i = 1; i <= 4000; ++i) {
        length += (shape(0.01 * i) - shape(0.01 * (i - 1))).norm();
        lowest = std::min(lowest, shape(0.01 * i).z());
    }
    EXPECT_NEAR(length, 40, 1e-2);
    EXPECT_NEAR(lowest, -20, 0.02);
}

TEST(Motion, CircleBeginsAtItsCentreAndTurnsClockwise) {
    const Motion motion = circle_motion({1, 2, 3}, 0.2, 1.25, true, 1.25);
    EXPECT_LT((motion(0) - Vec3(1, 2, 3)).norm(), 1e-12);
    EXPECT_LT((motion(12.5) - Vec3(1.2, 2, 3)).norm(), 1e-9);
    EXPECT_LT((motion(12.5 + 1.25 / 4) - Vec3(1, 2, 2.8)).norm(), 1e-9); // right, then down
}

} // namespace
} // namespace windlass::lab
