// Is the mark right: sheets go out without our marks, come back filled in, and agreement is what the books
// say it is.

#include "recorder/blind/agreement.hpp"

#include "common/json_file.hpp"
#include "recorder/blind/answers.hpp"
#include "recorder/blind/questions.hpp"
#include "recorder/command.hpp"

#include "tests/recorder/folder.hpp"
#include "tests/recorder/taped_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <random>
#include <ranges>

namespace windlass::blind {
namespace {

using test::Folder;
using testing::HasSubstr;
using testing::Not;

Pairs pairs_of(const std::vector<int>& one, const std::vector<int>& other) {
    Pairs pairs;
    for (std::size_t i = 0; i < one.size(); ++i)
        pairs.push_back({one[i], other[i]});
    return pairs;
}
/// Each mark as often as told.
std::vector<int> times(std::initializer_list<std::array<int, 2>> marks) {
    std::vector<int> all;
    for (const auto [mark, count] : marks)
        all.insert(all.end(), static_cast<std::size_t>(count), mark);
    return all;
}
/// One pair a recording.
Beside each_of_its_own(const Pairs& pairs) {
    Beside all;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        all["S" + std::to_string(i)] = {pairs[i]};
    return all;
}

/// By the sums over the table, as Cohen has it (1968, formula 6): v are weights of disagreement.
double kappa_of_table(const Pairs& pairs) {
    std::map<int, double> rows, columns;
    double seen = 0, by_chance = 0;
    const double n = static_cast<double>(pairs.size());
    for (const Pair& pair : pairs) {
        rows[pair[0]] += 1 / n;
        columns[pair[1]] += 1 / n;
        seen += std::pow(pair[0] - pair[1], 2) / n;
    }
    for (const auto& [i, p] : rows)
        for (const auto& [j, q] : columns)
            by_chance += std::pow(i - j, 2) * p * q;
    return 1 - seen / by_chance;
}

/// Two who mark 0 to 3 what both see with that correlation.
class TwoRaters {
public:
    explicit TwoRaters(double correlation) : correlation_(correlation) {}
    Pairs mark(std::size_t recordings) {
        Pairs pairs;
        for (std::size_t i = 0; i < recordings; ++i) {
            const double one = normal_(chance_);
            const double other =
                correlation_ * one + std::sqrt(1 - correlation_ * correlation_) * normal_(chance_);
            pairs.push_back({mark_of(one), mark_of(other)});
        }
        return pairs;
    }

private:
    /// 10, 15, 30 and 45 % of them.
    static int mark_of(double seen) { return (seen > -1.2816) + (seen > -0.6745) + (seen > 0.1257); }
    double correlation_;
    std::mt19937_64 chance_{7};
    std::normal_distribution<double> normal_;
};

} // namespace

// Worked elsewhere: R's irr, kappa2(anxiety, "squared"), raters 1 and 2, 2 and 3 (of the latter it drops the
// level that neither gave); scikit-learn's test of cohen_kappa_score, where of two marks there is but one
// kind of weight (0.348).
TEST(Agreement, KappaIsThatOfPublishedExamples) {
    const std::vector<int> anxiety1{3, 3, 3, 4, 5, 5, 2, 3, 5, 2, 2, 6, 1, 5, 2, 2, 1, 2, 4, 3};
    std::vector<int> anxiety2{3, 6, 4, 6, 2, 4, 2, 4, 3, 3, 2, 3, 3, 3, 2, 2, 1, 3, 3, 4};
    std::vector<int> anxiety3{2, 1, 4, 4, 3, 2, 1, 6, 1, 1, 1, 2, 3, 3, 1, 1, 3, 3, 2, 2};
    EXPECT_NEAR(*weighted_kappa(pairs_of(anxiety1, anxiety2)), 0.297, 0.0005);
    EXPECT_NEAR(
        *weighted_kappa(pairs_of(times({{0, 40}, {1, 60}}), times({{0, 20}, {1, 20}, {0, 10}, {1, 50}}))),
        0.348, 0.0005);
    EXPECT_NEAR(
        *weighted_kappa(pairs_of(times({{0, 46}, {1, 44}, {2, 10}}), times({{0, 50}, {1, 40}, {2, 10}}))),
        0.9541, 0.00005);
    for (auto* marks : {&anxiety2, &anxiety3})
        for (int& mark : *marks)
            if (mark > 5) mark = 5; // nobody gave 5
    EXPECT_NEAR(*weighted_kappa(pairs_of(anxiety2, anxiety3)), 0.2520325, 5e-7);
}

TEST(Agreement, KappaIsOneWhereAllAgreeNoneByChanceAndLessWhereTheyAreReversed) {
    Pairs equal, reversed, independent;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            equal.push_back({i, i});
            reversed.push_back({i, 3 - i});
            independent.push_back({i, j});
        }
    EXPECT_EQ(weighted_kappa(equal), 1);
    EXPECT_EQ(weighted_kappa(independent), 0);
    EXPECT_EQ(weighted_kappa(reversed), -1);
    EXPECT_EQ(agreement({each_of_its_own(equal)}).kappa, 1);
    EXPECT_THAT(agreement({each_of_its_own(equal)}).undetermined, HasSubstr("nothing varies"));
    EXPECT_NEAR(*agreement({each_of_its_own(equal), each_of_its_own(independent)}).kappa, 0.5, 1e-12)
        << "the mean";
}

TEST(Agreement, KappaIsThatOfTheTable) {
    for (const double correlation : {-0.5, 0.2, 0.9}) {
        const Pairs pairs = TwoRaters(correlation).mark(57);
        EXPECT_NEAR(*weighted_kappa(pairs), kappa_of_table(pairs), 1e-12);
    }
}

TEST(Agreement, IsUndeterminedWhereAllMarksAreEqualOrRecordingsAreFew) {
    EXPECT_FALSE(weighted_kappa({}));
    EXPECT_FALSE(weighted_kappa(pairs_of({2, 2, 2}, {1, 2, 3})));
    const auto few = agreement({each_of_its_own(TwoRaters(0.7).mark(9))});
    EXPECT_FALSE(few.kappa);
    EXPECT_THAT(few.undetermined, HasSubstr("fewer than 10"));
    EXPECT_FALSE(agreement({each_of_its_own(Pairs(20, Pair{3, 3}))}).kappa);
    EXPECT_DOUBLE_EQ(agreement({each_of_its_own(Pairs(20, Pair{3, 3}))}).same, 1);
    Pairs but_one(20, Pair{3, 3});
    but_one.push_back({1, 2});
    const auto one = agreement({each_of_its_own(but_one)});
    EXPECT_TRUE(one.kappa);
    EXPECT_FALSE(one.interval) << "all hangs on one recording";
}

// The table of docs/validity.md is what this prints.
TEST(Agreement, IntervalHoldsTheTrueKappaInNineCasesOfTenAndMore) {
    for (const double correlation : {0.7, 0.9, 0.97}) {
        const double truth = *weighted_kappa(TwoRaters(correlation).mark(400'000));
        for (const std::size_t n : {10, 20, 30, 50, 100}) {
            TwoRaters two(correlation);
            int intervals = 0, holds = 0;
            double low = 0, high = 0;
            const int studies = n > 50 ? 500 : 1000;
            for (int study = 0; study < studies; ++study) {
                const auto found = agreement({each_of_its_own(two.mark(n))});
                if (!found.interval) continue;
                ++intervals;
                low += (*found.interval)[0];
                high += (*found.interval)[1];
                holds += (*found.interval)[0] <= truth && truth <= (*found.interval)[1];
            }
            const double share = 1.0 * holds / intervals;
            std::cout << "kappa " << truth << ", " << n << " recordings: mean interval " << low / intervals
                      << " to " << high / intervals << ", holds it in " << 100 * share
                      << " %, undetermined in " << 100.0 * (studies - intervals) / studies << " %\n";
            EXPECT_GT(share, 0.9) << n;
            EXPECT_LT(share, 0.985) << n;
        }
    }
}

TEST(Blind, OurMarkStandsOnTheScaleByItsQuarters) {
    EXPECT_EQ(on_scale(0), 0);
    EXPECT_EQ(on_scale(249), 0);
    EXPECT_EQ(on_scale(499), 1);
    EXPECT_EQ(on_scale(500), 2) << "met";
    EXPECT_EQ(on_scale(750), 3);
    EXPECT_EQ(on_scale(1000), 3);
    assess::Result whole;
    whole.tenths_computed = 700;
    whole.pass = 70;
    whole.outcome = assess::Outcome::achieved;
    EXPECT_EQ(on_scale(whole), 2);
    whole.tenths_computed = 850;
    EXPECT_EQ(on_scale(whole), 3);
    whole.outcome = assess::Outcome::not_yet;
    EXPECT_EQ(on_scale(whole), 1);
    whole.tenths_computed = 349;
    EXPECT_EQ(on_scale(whole), 0);
}

namespace {

/// L01 for half a minute: the wheel is thrown open, and checked or left.
void record_lesson(const std::filesystem::path& folder, double brake) {
    test::TapedSession taped(folder,
                             config::load_exercise(WINDLASS_CONFIG_DIR "/exercises/L01_let_go_25m.json"));
    taped.run(15 * 300);
    taped.give(exercise::Order{exercise::WindlassOrder{.side = exercise::Side::port, .brake = 0}}, "zebedee");
    taped.run(8 * 300);
    taped.give(exercise::Order{exercise::ReportMade{.code = exercise::ReportCode::on_the_bottom, .side = 0}},
               "zebedee");
    taped.give(exercise::Order{exercise::WindlassOrder{.side = exercise::Side::port, .brake = brake}},
               "zebedee");
    taped.run(6 * 300);
    taped.give(exercise::Order{exercise::AssessorsWord{.criterion = "pay-out",
                                                       .verdict = exercise::AssessorVerdict::met,
                                                       .note = "said by the assessor",
                                                       .by = "Ann"}},
               "instructor");
    taped.give(run::RunAction::stop);
    taped.run(300);
    taped.close();
}

/// The program's own command.
int command(const std::string& line) {
    CLI::App app;
    recorder::Command chosen;
    recorder::add_blind(app, chosen);
    app.parse("recorder blind " + line, true);
    return chosen();
}

/// Fills in every answer of a form.
void fill(const std::filesystem::path& form, const std::string& rater,
          const std::function<std::string(const std::string& item)>& answer) {
    std::string filled;
    for (const auto part : std::views::split(test::content(form), std::string_view("\r\n"))) {
        const std::string line(part.begin(), part.end());
        if (line.empty()) continue;
        const auto first = line.find(',') + 1;
        const std::string item = line.substr(first, line.find(',', first) - first);
        filled += !line.ends_with(",,")
                      ? line
                      : line.substr(0, line.size() - 1) + (item == kRaterItem ? rater : answer(item)) + ",";
        filled += "\r\n";
    }
    test::put(form, filled);
}

std::string refused(const std::vector<std::filesystem::path>& forms, const Key& key) {
    try {
        read_forms(forms, key);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(Blind, SheetsGoOutWithoutMarksAndNamesAndComeBackAsAgreement) {
    const Folder folder;
    record_lesson(folder / "checked", 0.9);
    record_lesson(folder / "left", 0);
    std::string recordings;
    for (int i = 0; i < 5; ++i)
        recordings += (folder / "checked").string() + " " + (folder / "left").string() + " ";
    const std::string sheets = (folder / "sheets").string(), again = (folder / "again").string();
    ASSERT_EQ(command("sheets " + recordings + "--seed 5 --output " + sheets), 0);
    ASSERT_EQ(command("sheets " + recordings + "--seed 5 --output " + again), 0);
    EXPECT_THROW(command("sheets " + recordings + "--seed 5 --output " + sheets), std::runtime_error)
        << "forms that are filled in are not written over";
    const auto key_file = folder / "sheets_key.json";
    EXPECT_EQ(test::content(key_file), test::content(folder / "again_key.json"))
        << "of the same seed the same";

    const std::string page = test::content(folder / "sheets" / "S01.html");
    for (const char* told :
         {"Bulk carrier, laden, 25 m of water", "let go port anchor", "port anchor is on the bottom", "<svg",
          "Load on the cable", "Speed of the cable", "Levers", "Fall. How well was this kept",
          "cannot be told"})
        EXPECT_THAT(page, HasSubstr(told));
    for (const char* kept :
         {"zebedee", "Ann", "said by the assessor", "checked", "points", "not met", "achieved"}) {
        EXPECT_THAT(page, Not(HasSubstr(kept)));
        EXPECT_THAT(test::content(folder / "sheets" / "S01.csv"), Not(HasSubstr(kept)));
    }

    const Key key = read_key(key_file);
    ASSERT_EQ(key.size(), 10U);
    const auto recording_of = [&, read = read_json(key_file)](const std::string& code) {
        return std::filesystem::path(read["sheets"][code]["recording"].get<std::string>()).filename();
    };
    std::string forms;
    for (const auto& [code, ours] : key) {
        EXPECT_FALSE(ours.contains("L01/stance")) << "of that a recording says nothing";
        if (recording_of(code) == "left") {
            EXPECT_EQ(ours.at("L01/pay-out"), 0) << "ours, not the assessor's, who called it met";
        }
        const auto anna = folder / "sheets" / (code + ".csv"), ben = folder / ("ben_" + code + ".csv");
        std::filesystem::copy_file(anna, ben);
        // Anna sees it as we do, and says nothing of what we do not mark; Ben sees nothing but good in what
        // was left.
        fill(anna, "anna",
             [&](const std::string& item) { return ours.at(item) ? std::to_string(*ours.at(item)) : "-"; });
        fill(ben, "ben", [&](const std::string&) { return recording_of(code) == "left" ? "3" : "2"; });
        forms += " " + anna.string() + " " + ben.string();
    }
    testing::internal::CaptureStdout();
    ASSERT_EQ(command("agree " + key_file.string() + forms + " --json " + (folder / "a.json").string()), 0);
    EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("all criteria"));
    const auto told = read_json(folder / "a.json")["rows"];
    const auto row = [&](const std::string& item, const std::string& who) {
        for (const auto& each : told)
            if (each["item"] == item && each["who"] == who) return each;
        return nlohmann::json();
    };
    EXPECT_EQ(row("all criteria", "ours - anna")["kappa"], 1);
    EXPECT_EQ(row("all criteria", "ours - anna")["recordings"], 10);
    EXPECT_EQ(row("all criteria", "ours - anna")["same"], 1);
    EXPECT_LT(row("all criteria", "ours - ben")["kappa"], 0.3);
    EXPECT_EQ(row("all criteria", "ours - ben")["kappa"], row("all criteria", "anna - ben")["kappa"]);
    EXPECT_EQ(row("overall", "ours - anna")["recordings"], 10);
    EXPECT_TRUE(row("L01/clutch", "ours - anna")["kappa"].is_null()) << "out in all of them";
}

TEST(Blind, BadRowsAreRefusedWithFileLineFieldAndWhatIsAllowed) {
    const Folder folder;
    const Key key{{"S01", {{"L01/fall", 2}, {"overall", 1}}}, {"S02", {{"overall", std::nullopt}}}};
    const auto form = folder / "f.csv";
    const auto of = [&](const std::string& rows) {
        test::put(form, "sheet,item,question,allowed,answer,remark\r\n" + rows);
        return refused({form}, key);
    };
    const std::string good = "S01,rater,,,anna,\r\nS01,L01/fall,\"How,\nwell?\",,3,\r\nS01,overall,,,-,\r\n";
    EXPECT_EQ(of(good), "");
    EXPECT_THAT(
        of("S01,rater,,,anna,\r\nS01,L01/fall,\"How,\nwell?\",,4,\r\nS01,overall,,,0,\r\n"),
        HasSubstr("f.csv:3: answer of L01/fall: \"4\" is not allowed: 0 to 3, or - where it cannot be told"));
    EXPECT_THAT(of("S01,rater,,,anna,\r\nS01,L01/fall,,,,\r\nS01,overall,,,good,\r\n"),
                testing::AllOf(HasSubstr("f.csv:3: answer of L01/fall: \"\""),
                               HasSubstr("f.csv:4: answer of overall: \"good\"")))
        << "all faults at once";
    EXPECT_THAT(of(good + "S01,overall,,,1,\r\n"),
                HasSubstr("f.csv:6: item: \"overall\" is not allowed: once; it stands in line 5"));
    EXPECT_THAT(of(good + "S01,L01/wind,,,1,\r\n"),
                HasSubstr("\"L01/wind\" is not allowed: an item of sheet S01"));
    EXPECT_THAT(of(good + "S09,overall,,,1,\r\n"), HasSubstr("sheet: \"S09\" is not allowed"));
    EXPECT_THAT(of("S01,rater,,,ours,\r\n"), HasSubstr("a name or a number, but not ours"));
    EXPECT_THAT(of("S02,overall,,,1,\r\n"), HasSubstr("sheet S02: item rater is missing"));
    EXPECT_THAT(of("S01,rater,,,anna,\r\nS01,overall,,,1,\r\n"),
                HasSubstr("sheet S01: item L01/fall is missing"));
    test::put(form, "sheet,item\r\n");
    EXPECT_THAT(refused({form}, key), HasSubstr("f.csv:1: column answer is missing"));
    EXPECT_THAT(refused({folder / "none.csv"}, key), HasSubstr("none.csv: cannot be read"));

    // As a German spreadsheet writes it.
    test::put(form, "\xEF\xBB\xBFsheet;item;answer;remark\nS02;rater;7;\nS02;overall; 1 ;\"a; b\"\n;;;\n");
    const auto raters = read_forms({form}, key);
    ASSERT_EQ(raters.size(), 1U);
    EXPECT_EQ(raters[0].name, "7");
    EXPECT_EQ(raters[0].marks.at("S02").at("overall"), 1);
    EXPECT_THAT(refused({form, form}, key), HasSubstr("7 has marked it in another file"));

    test::put(folder / "key.json",
              R"({"format": "windlass blind key 1", "sheets": {"S01": {"marks": {"overall": 4}}}})");
    EXPECT_THROW(read_key(folder / "key.json"), ConfigError);
    test::put(folder / "key.json", R"({"sheets": {}})");
    EXPECT_THROW(read_key(folder / "key.json"), ConfigError);
}

} // namespace windlass::blind
