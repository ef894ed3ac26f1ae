// Suites: how they are refused, run in parts and kept in a file.

#include "bench/lab/accuracy/compare_charts.hpp"
#include "bench/lab/accuracy/suite.hpp"
#include "bench/lab/case/table.hpp"
#include "common/json_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace windlass::lab {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = WINDLASS_CASES_DIR;

class SuiteTest : public testing::Test {
protected:
    SuiteTest() { fs::create_directories(folder_); }
    ~SuiteTest() override { fs::remove_all(folder_); }
    SuiteTest(const SuiteTest&) = delete;
    SuiteTest& operator=(const SuiteTest&) = delete;

    fs::path write(const std::string& text, const std::string& name = "suite.json") const {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }
    /// What is said of a suite with these fields of its only case; "" when it is accepted.
    std::string refusal(const std::string& fields, const std::string& methods = R"(["leapfrog"])") const {
        try {
            load_suite(write(R"({"methods": )" + methods + R"(, "cases": [{)" + fields + "}]}"));
            return "";
        } catch (const ConfigError& error) {
            return error.what();
        }
    }
    std::string hang(const std::string& nodes = "[4]", const std::string& rates = "[60, 120]") const {
        return R"("case": ")" + (kCases / "hang.json").string() + R"(", "nodes": )" + nodes +
               R"(, "rates": )" + rates + R"(, "reference_rate": 480, "duration": 0.1, "bar": "air")";
    }
    /// Runs what is selected into the rows and tells what was run.
    static std::vector<std::string> run(const Suite& suite, const Selection& selection,
                                        std::vector<SuiteRow>& rows) {
        std::vector<std::string> told;
        run_suite(
            suite, selection, rows, [&](double, const std::string& what) { told.push_back(what); }, [] {});
        return told;
    }

    fs::path folder_ = fs::temp_directory_path() / ("lab_suite_" + std::to_string(getpid()));
};

TEST_F(SuiteTest, IsRefusedWithFilePlaceValueAndWhatIsAllowed) {
    EXPECT_EQ(refusal(hang()), "");
    const std::string method = refusal(hang(), R"(["leapfrog", "frogleap"])");
    for (const char* part : {"suite.json", "/methods/1", "frogleap", "chain_lab list"})
        EXPECT_NE(method.find(part), std::string::npos) << method;
    const std::string rate = refusal(hang("[4]", "[60, 100]"));
    for (const char* part : {"suite.json", "/cases/0/rates/1", "100"})
        EXPECT_NE(rate.find(part), std::string::npos) << rate;
    EXPECT_NE(refusal(hang("[1]")).find("/cases/0/nodes/0"), std::string::npos);
    EXPECT_NE(refusal(R"("case": "none.json", "nodes": [4], "rates": [60], "reference_rate": 60)")
                  .find("none.json"),
              std::string::npos);
    EXPECT_NE(refusal(hang("[4]", "[60, 480]")).find("/cases/0/rates: 480"), std::string::npos);
    EXPECT_NE(refusal(hang() + R"(, "set": ["line.length=-1"])").find("/line/length"), std::string::npos);
    EXPECT_EQ(refusal(hang() + "}, {" + R"("name": "again", )" + hang()), "");
    EXPECT_NE(refusal(hang() + "}, {" + hang()).find("a name comes once"), std::string::npos);
}

TEST_F(SuiteTest, RunsWhatIsSelectedAndKeepsTheRest) {
    const Suite suite =
        load_suite(write(R"({"methods": ["production", "leapfrog"], "cases": [{)" + hang("[4, 5]") + "}]}"));
    std::vector<SuiteRow> rows;
    run(suite, {}, rows);
    const auto count = [&](const std::string& method, int nodes) {
        return std::count_if(rows.begin(), rows.end(), [&](const SuiteRow& row) {
            return row.method == method && row.nodes == nodes && row.end.empty();
        });
    };
    ASSERT_GE(count("leapfrog", 4), 2);
    const auto whole = rows.size();
    for (SuiteRow& row : rows)
        row.cost = -1; // to know them again
    run(suite, {.methods = {"leapfrog"}, .cases = {}, .nodes = {5}}, rows);
    EXPECT_EQ(rows.size(), whole);
    for (const SuiteRow& row : rows) {
        const bool again =
            row.nodes == 5 && (row.method == "leapfrog" || row.method.starts_with(kReferenceCheck));
        EXPECT_EQ(row.cost >= 0, again) << row.method << ' ' << row.nodes;
    }
}

TEST_F(SuiteTest, ResumesWithTheRunsThatAreMissing) {
    const fs::path file =
        write(R"({"methods": ["leapfrog"], "cases": [{)" + hang("[4]", "[60, 120]") + "}]}");
    std::vector<SuiteRow> rows;
    run(load_suite(file), {}, rows);
    for (SuiteRow& row : rows)
        row.cost = -1;
    const Suite more =
        load_suite(write(R"({"methods": ["leapfrog"], "cases": [{)" + hang("[4]", "[60, 120, 180]") + "}]}"));
    run(more, {.methods = {}, .cases = {}, .nodes = {}, .missing = true}, rows);
    for (const SuiteRow& row : rows)
        EXPECT_EQ(row.cost >= 0, row.method != "leapfrog" || row.rate == 180)
            << row.method << ' ' << row.rate;
    const auto told = run(more, {.methods = {}, .cases = {}, .nodes = {}, .missing = true}, rows);
    EXPECT_TRUE(std::none_of(told.begin(), told.end(),
                             [](const std::string& what) { return what.ends_with("converged run"); }));
}

TEST_F(SuiteTest, RowsComeBackFromTheirFileInTheOrderOfTheSuite) {
    const Suite suite =
        load_suite(write(R"({"methods": ["production", "leapfrog"], "cases": [{)" + hang() + "}]}"));
    const fs::path file = folder_ / "rows.csv";
    EXPECT_TRUE(read_rows(file, "hang").empty());
    write_rows(file, suite, "hang",
               {{"hang", 4, "leapfrog", 60, 0, {}, "cannot, for a reason"},
                {"hang",
                 4,
                 "production",
                 120,
                 0.5,
                 {.tension = 1e-3, .position = 2e-6, .link = 3e-5, .peak = -0.25},
                 ""},
                {"hang", 4, "production", 60, 1.5, {}, ""},
                {"swing", 4, "production", 60, 1.5, {}, ""}},
               {"a machine"});
    EXPECT_EQ(read_notes(file), Notes{"a machine"});
    const std::vector<SuiteRow> rows = read_rows(file, "hang");
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].rate, 60);
    EXPECT_EQ(rows[1].rate, 120);
    EXPECT_EQ(rows[1].cost, 0.5);
    EXPECT_EQ(rows[1].errors.tension, 1e-3);
    EXPECT_EQ(rows[1].errors.peak, -0.25);
    EXPECT_EQ(rows[1].end, "");
    EXPECT_EQ(rows[2].method, "leapfrog");
    EXPECT_EQ(rows[2].end, "cannot, for a reason");
}

TEST_F(SuiteTest, RefusesAFileOfRowsThatIsNoSuch) {
    const auto said = [&](const std::string& text) -> std::string {
        try {
            read_rows(write(text, "rows.csv"), "hang");
            return "";
        } catch (const ConfigError& error) {
            return error.what();
        }
    };
    const std::string head = "links,method,end,steps_per_s,cost_ms_per_s,tension_error,position_error,"
                             "link_error,peak_error\n";
    EXPECT_EQ(said(head), "");
    EXPECT_NE(said("a,b\n").find("line 1"), std::string::npos);
    EXPECT_NE(said(head + "4,leapfrog\n").find("line 2"), std::string::npos);
    EXPECT_NE(said(head + "four,leapfrog,,60,1,1,1,1,1\n").find("\"four\""), std::string::npos);
    EXPECT_NE(said(head + "4,leapfrog,,60 120,1,1 2,1 2,1 2,1 2\n").find("row 1: 1 figures of cost"),
              std::string::npos);
}

TEST_F(SuiteTest, CheapestRunPassesInEveryCaseOfItsBar) {
    Suite suite;
    suite.methods = {find_method("leapfrog")};
    suite.cases = {{.name = "a", .given = {}, .nodes = {4}, .rates = {}, .drawn = {}, .bar = "air"},
                   {.name = "b", .given = {}, .nodes = {4}, .rates = {}, .drawn = {}, .bar = "air"},
                   {.name = "c", .given = {}, .nodes = {4}, .rates = {}, .drawn = {}, .bar = "wet"}};
    const auto row = [](const char* name, int rate, double cost, double tension, double peak = 0) {
        return SuiteRow{name, 4,    "leapfrog",
                        rate, cost, {.tension = tension, .position = 0, .link = 0, .peak = peak},
                        ""};
    };
    const std::vector<SuiteRow> rows{
        row("a", 60, 1, 1e-4),  row("b", 60, 1, 5e-3), // fails at 0.1 % in b
        row("a", 120, 2, 1e-4), row("b", 120, 3, 1e-4),      row("a", 240, 4, 1e-5),
        row("b", 240, 4, 1e-5), row("c", 60, 9, 1e-5, -0.04)}; // fails by its peak
    const auto best = [&](const char* bar, double limit) { return cheapest_runs(suite, rows, bar, limit); };
    ASSERT_EQ(best("air", 1e-3).size(), 1U);
    EXPECT_EQ(best("air", 1e-3)[0].rate, 120);
    EXPECT_EQ(best("air", 1e-3)[0].cost, 3); // of the dearer case
    EXPECT_EQ(best("air", 1e-2)[0].rate, 60);
    EXPECT_TRUE(best("wet", 1e-2).empty());
}

} // namespace
} // namespace windlass::lab
