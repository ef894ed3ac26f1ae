// Stability: runs that are known to stay bounded, and runs that are known not to, judged rightly.

#include "bench/lab/stability/stability_suite.hpp"
#include "common/json_file.hpp"
#include "tests/lab/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <unistd.h>

namespace windlass::lab {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = WINDLASS_CASES_DIR;

/// A method whose course is written down beforehand: the line falls straight out of a shape, changed by f.
class Scripted : public Method {
public:
    using Change = void (*)(double time, std::vector<Vec3>& places);
    static inline Change change = nullptr;
    static inline long unsolved_steps = 0;

    Scripted(const Problem& problem, int links, double dt) : dt_(dt) {
        for (int i = 0; i <= links; ++i)
            start_.push_back(problem.start(problem.length * i / links));
        places_ = start_;
    }
    void step() override {
        places_ = start_;
        change(++steps_ * dt_, places_);
    }
    double time() const override { return double(steps_) * dt_; }
    int links() const override { return int(places_.size()) - 1; }
    Vec3 position(int node) const override { return places_[node]; }
    Vec3 velocity(int) const override { return Vec3::Zero(); }
    double tension(int) const override { return 0; }
    long unsolved() const override { return unsolved_steps; }

private:
    double dt_;
    long steps_ = 0;
    std::vector<Vec3> start_, places_;
};

Verdict judged(Scripted::Change change, long unsolved = 0) {
    Scripted::change = change;
    Scripted::unsolved_steps = unsolved;
    const MethodEntry entry{
        "scripted", "", "",
        [](const Problem& problem, int links, double dt, const MethodSettings&) -> std::unique_ptr<Method> {
            return std::make_unique<Scripted>(problem, links, dt);
        }};
    Case given = load_case(kCases / "whip.json");
    given.problem.duration = 1;
    return judge(given, entry, 10, 60, {});
}

Verdict whip(const char* method, int links, int rate, int iterations = 0) {
    Case given = load_case(kCases / "whip.json");
    given.settings.iterations = iterations;
    return judge(given, method_named(method), links, rate, {});
}

TEST(Stability, ALineThatStaysWhereItIsIsBounded) {
    const Verdict verdict = judged([](double, std::vector<Vec3>&) {});
    EXPECT_EQ(verdict.fate, Fate::bounded);
    EXPECT_NEAR(verdict.energy, 1,
                0.02); // the start's own, but for the stretch at rest, which it does not have
    EXPECT_NEAR(verdict.strain, 0, 1e-9);
}

TEST(Stability, ALineThatRisesWithoutCauseHasGrownInEnergy) {
    // At play are 10 t that can fall 50 m and 6.3 t that can fall 25 m; a tenth of it lifts all by 4 m.
    const Verdict verdict = judged([](double t, std::vector<Vec3>& places) {
        for (Vec3& place : places)
            place.z() += 10 * t;
    });
    EXPECT_EQ(verdict.fate, Fate::grew);
    EXPECT_GT(verdict.when, 0.39);
    EXPECT_LT(verdict.when, 0.45);
}

TEST(Stability, ALinkOfTwiceItsLengthIsStretchedEvenForOneStep) {
    const Verdict verdict = judged([](double t, std::vector<Vec3>& places) {
        if (std::abs(t - 0.5) < 1e-6) places[0].x() += 5;
    });
    EXPECT_EQ(verdict.fate, Fate::stretched);
    EXPECT_NEAR(verdict.when, 0.5, 1e-6);
    EXPECT_NEAR(verdict.strain, 1, 1e-9);
}

TEST(Stability, ANodeThatIsNowhereIsNotANumberWhateverCameBefore) {
    const Verdict verdict = judged([](double t, std::vector<Vec3>& places) {
        if (t > 0.2) places[0].x() += 5;
        if (t > 0.7) places[3].y() = std::numeric_limits<double>::quiet_NaN();
    });
    EXPECT_EQ(verdict.fate, Fate::not_a_number);
    EXPECT_NEAR(verdict.when, 0.2, 0.02); // the first fault
}

TEST(Stability, AStepThatWasNotSolvedIsTold) {
    EXPECT_EQ(judged([](double, std::vector<Vec3>&) {}, 1).fate, Fate::unsolved);
}

TEST(Stability, ExplicitStepIsBoundedBelowItsLimitAndNotAbove) {
    // c = 2147 m/s and links of 1 m: the limit is 2147 steps in a second.
    EXPECT_EQ(whip("leapfrog", 50, 3000, 1).fate, Fate::bounded);
    const Verdict above = whip("leapfrog", 50, 1500, 1);
    EXPECT_TRUE(above.fate == Fate::grew || above.fate == Fate::stretched ||
                above.fate == Fate::not_a_number);
    EXPECT_LT(above.when, 0.2); // at once: the fastest mode grows in each step
}

TEST(Stability, ImplicitStepIsBoundedFarBeyondTheExplicitLimit) {
    EXPECT_EQ(whip("direct_end", 50, 60).fate, Fate::bounded);
}

TEST(Stability, GivesUpARunThatWouldTakeTooLong) {
    const Case given = load_case(kCases / "whip.json");
    FaultLimits limits;
    limits.max_seconds = 1e-5;
    EXPECT_EQ(judge(given, method_named("production"), 50, 600, limits).fate, Fate::too_long);
}

TEST(Stability, TellsWhatAMethodCannotDo) {
    Case given = load_case(kCases / "whip.json");
    given.problem.upper.kind = EndKind::free;
    const Verdict verdict = judge(given, method_named("catenary"), 10, 60, {});
    EXPECT_EQ(verdict.fate, Fate::cannot);
    EXPECT_NE(verdict.why, "");
}

TEST(Stability, EnergyAtPlayIsTheFallToStraightDownAndTheSpeedOfTheEnds) {
    const Case whip = load_case(kCases / "whip.json");
    const double g = physics::kGravity, chain = 126.5 * 50,
                 stretch = std::pow((10000 + chain) * g, 2) * 50 / 5.83e8 / 2;
    EXPECT_NEAR(energy_at_play(whip.problem, 50), g * (10000 * 50 + chain * 25) + stretch, 1);
    const Case stop = load_case(kCases / "let_go.json"); // hangs at rest; the end moves with up to 8 m/s
    const double mass = 10000 + stop.problem.line.mass_per_metre * 60;
    EXPECT_NEAR(energy_at_play(stop.problem, 50) / (0.5 * mass * 64), 1, 0.06); // the stretch: 5 % of it
}

TEST(Stability, MassRatioKeepsTheLoadWithinWhatTheCaseHas) {
    const Case base = load_case(kCases / "whip.json"); // 10 t, links of 126.5 kg
    for (const double ratio : {1.0, 10.0, 1e3, 1e6}) {
        const Problem problem = with_mass_ratio(base, 50, ratio).problem;
        EXPECT_NEAR(problem.lower.mass / problem.line.mass_per_metre / ratio, 1, 1e-9);
        EXPECT_NEAR(problem.lower.weight, problem.lower.mass * physics::kGravity, 1e-6);
        EXPECT_LE(problem.lower.mass, 10000);
        EXPECT_LE(problem.line.mass_per_metre, 126.5);
    }
}

class StabilitySuiteTest : public testing::Test {
protected:
    StabilitySuiteTest() { fs::create_directories(folder_); }
    ~StabilitySuiteTest() override { fs::remove_all(folder_); }
    StabilitySuiteTest(const StabilitySuiteTest&) = delete;
    StabilitySuiteTest& operator=(const StabilitySuiteTest&) = delete;

    fs::path write(const std::string& methods, const std::string& map) const {
        std::ofstream(folder_ / "stability.json")
            << R"({"rates": [600, 6000], "methods": )" << methods << R"(, "maps": [)" << map << "]}";
        return folder_ / "stability.json";
    }
    std::string refusal(const std::string& methods, const std::string& map) const {
        try {
            load_stability(write(methods, map));
            return "";
        } catch (const ConfigError& error) {
            return error.what();
        }
    }
    static std::string map(const std::string& axis, const std::string& more) {
        return R"({"name": "m", "title": "t", "axis": ")" + axis + "\"" + more + "}";
    }
    static std::string whip() { return R"(, "case": ")" + (kCases / "whip.json").string() + "\""; }

    fs::path folder_ = fs::temp_directory_path() / ("lab_stability_" + std::to_string(getpid()));
};

TEST_F(StabilitySuiteTest, IsRefusedWithFilePlaceValueAndWhatIsAllowed) {
    const std::string good = map("nodes", whip() + R"(, "values": [4])");
    EXPECT_EQ(refusal(R"(["leapfrog"])", good), "");
    const std::string method = refusal(R"(["leapfrog", {"method": "frogleap", "name": "x"}])", good);
    for (const char* part : {"stability.json", "/methods/1", "frogleap", "chain_lab list"})
        EXPECT_NE(method.find(part), std::string::npos) << method;
    EXPECT_NE(refusal(R"(["leapfrog", "leapfrog"])", good).find("a name comes once"), std::string::npos);
    EXPECT_NE(refusal(R"(["leapfrog"])", map("nodes", whip() + R"(, "values": [4.5])"))
                  .find("/maps/0/values/0: 4.5"),
              std::string::npos);
    EXPECT_NE(refusal(R"(["leapfrog"])", map("nodes", "")).find("a case and values"), std::string::npos);
    EXPECT_NE(refusal(R"(["leapfrog"])", map("event", "")).find("events"), std::string::npos);
    EXPECT_NE(refusal(R"(["leapfrog"])", map("colour", "")).find("/maps/0/axis"), std::string::npos);
    const std::string heap = R"(, "case": ")" + (kCases / "heap.json").string() + R"(", "values": [10])";
    EXPECT_NE(refusal(R"(["leapfrog"])", map("mass_ratio", heap)).find("a mass at its lower end"),
              std::string::npos);
}

TEST_F(StabilitySuiteTest, RunsResumesAndComesBackFromItsFile) {
    const StabilitySuite suite =
        load_stability(write(R"(["direct_end", {"method": "leapfrog", "name": "raw", "iterations": 1}])",
                             map("nodes", whip() + R"(, "values": [4, 50])")));
    std::vector<StabilityRow> rows;
    const auto nothing = [](double, const std::string&) {};
    run_stability(suite, {.methods = {"raw"}, .maps = {}}, rows, nothing, [] {});
    ASSERT_EQ(rows.size(), 4U);
    for (StabilityRow& row : rows)
        row.verdict.cost = -1; // to know them again
    run_stability(suite, {.methods = {}, .maps = {}, .missing = true}, rows, nothing, [] {});
    ASSERT_EQ(rows.size(), 8U);
    EXPECT_EQ(
        std::count_if(rows.begin(), rows.end(), [](const StabilityRow& r) { return r.verdict.cost == -1; }),
        4);

    const fs::path file = folder_ / "stability.csv";
    const std::string name = suite.maps[0].name;
    write_stability(file, suite, name, rows);
    const std::vector<StabilityRow> again = read_stability(file, name);
    ASSERT_EQ(again.size(), 8U);
    EXPECT_EQ(again[0].method, "direct_end"); // in the order of the suite
    EXPECT_EQ(again[0].value, "4");
    for (const StabilityRow& row : again)
        EXPECT_EQ(row.verdict.fate == Fate::bounded,
                  row.method == "direct_end" || row.value == "4" || row.rate == 6000)
            << row.method << ' ' << row.value << ' ' << row.rate;

    draw_stability(suite, suite.maps[0], again, folder_ / "map.svg");
    std::ifstream in(folder_ / "map.svg");
    const std::string drawing{std::istreambuf_iterator<char>(in), {}};
    for (const char* part : {">direct_end<", ">raw<", ">S<", "steps in a second", "stretched"})
        EXPECT_NE(drawing.find(part), std::string::npos) << part;
}

TEST_F(StabilitySuiteTest, RefusesAFileOfCellsThatIsNoSuch) {
    const fs::path file = folder_ / "stability.csv";
    std::ofstream(file) << "method,value,fate,steps_per_s\n"
                        << "raw,4,exploded,600\n";
    try {
        read_stability(file, "m");
        FAIL();
    } catch (const ConfigError& error) {
        EXPECT_NE(std::string(error.what()).find("row 1: \"exploded\""), std::string::npos) << error.what();
    }
}

TEST(StabilitySuite, NoStepOfAnExerciseFailsInProduction) {
    // Every cell of the charts' maps: mass ratio 1 to 1e6, 10 to 2000 links, EA a hundredth to a hundredfold,
    // brake stop, fold, slack of no length and impact, each from 1/15 to 1/2000 s.
    StabilitySuite suite = load_stability(kCases / "stability.json");
    suite.max_seconds = 1e9; // a slow machine fails nothing
    std::vector<StabilityRow> rows;
    run_stability(
        suite, {.methods = {"production"}, .maps = {}}, rows, [](double, const std::string&) {}, [] {});
    EXPECT_GT(rows.size(), 150U);
    for (const StabilityRow& row : rows)
        EXPECT_EQ(row.verdict.fate, Fate::bounded) << row.map << " " << row.value << " at " << row.rate
                                                   << "/s: " << kFateNames[std::size_t(row.verdict.fate)];
}

TEST(StabilitySuite, TheOneOfTheChartsCanBeRead) {
    const StabilitySuite suite = load_stability(kCases / "stability.json");
    EXPECT_EQ(suite.maps.size(), 4U);
    EXPECT_GE(suite.methods.size(), 11U);
}

} // namespace
} // namespace windlass::lab
