// What is said of a lesson file that is wrong: where, what, and what to do.

#include "common/json_file.hpp"
#include "instructor_console/lesson_files.hpp"
#include "server/assess/names.hpp"
#include "server/assess/quantities.hpp"
#include "server/config/config.hpp"
#include "words/words.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace windlass::console {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

const fs::path kConfig = WINDLASS_CONFIG_DIR;

json good_lesson() {
    return read_json(kConfig / "exercises/L01_let_go_25m.json");
}

/// What is said of a document as an exercise file; empty: nothing.
std::string said_of(const json& document) {
    try {
        config::parse_exercise(document.dump(), "my.json", kConfig);
        return "";
    } catch (const ConfigError& error) {
        return error.what();
    }
}

} // namespace

TEST(LessonFile, ShippedOneIsSound) {
    EXPECT_EQ(said_of(good_lesson()), "");
}

// "Standing by" says the same of an anchor that was walked out, and earns nothing there.
TEST(LessonFile, ThatMarksReadySaysInItsBriefingWhenToReportIt) {
    int found = 0;
    for (const fs::directory_entry& file : fs::directory_iterator(kConfig / "exercises")) {
        if (file.path().extension() != ".json") continue;
        const json document = read_json(file.path());
        if (!document.contains("lesson")) continue;
        const json& lesson = document.at("lesson");
        for (const json& criterion : lesson.value("criteria", json::array()))
            if (criterion.value("report", json()) == "anchor_ready") {
                ++found;
                EXPECT_THAT(lesson.value("briefing", ""), HasSubstr("ready when")) << file.path();
            }
    }
    EXPECT_GT(found, 2);
}

// No report is called "in gear": who is to say it reads by which word.
TEST(LessonFile, WhoseBridgeWaitsToHearThatSheIsInGearSaysByWhichWord) {
    int found = 0;
    for (const fs::path& file : lesson_files(kConfig / "exercises")) {
        const json lesson = read_json(file).at("lesson");
        if (!lesson.contains("patience")) continue; // a bridge that hears nothing
        for (const json& order : lesson.value("orders", json::array()))
            if (order.at("code") == "gear_in") {
                ++found;
                EXPECT_THAT(lesson.value("briefing", ""),
                            testing::AnyOf(HasSubstr("report ready"), HasSubstr("are ready"),
                                           HasSubstr("ready once"), HasSubstr("ready, too, once"),
                                           HasSubstr("you stand by")))
                    << file;
            }
    }
    EXPECT_GT(found, 10);
}

TEST(LessonFile, EachMistakeIsToldWithItsPlaceAndARemedy) {
    const struct {
        const char* place; ///< where the value is put, or taken away (null)
        json value;
        const char* where;
        const char* remedy;
    } mistakes[] = {
        {"/lesson/criteria/0/kind", "limitt", "/lesson/criteria/0/kind", "limit"},
        {"/lesson/criteria/1/of", "cable_sped", "/lesson/criteria/1/of", "the nearest is \"cable_speed\""},
        {"/lesson/criteria/1/max", nullptr, "/lesson/criteria/1/max", "a limit needs"},
        {"/lesson/criteria/1/zero", 0, "/lesson/criteria/1/zero", "not above grace"},
        {"/lesson/criteria/1/fail_above", 2, "/lesson/criteria/1/fail_above", "before the limit is passed"},
        {"/lesson/criteria/0/at", "botom", "/lesson/criteria/0/at", "the nearest is \"bottom\""},
        {"/lesson/criteria/0/objective", "controll", "/lesson/criteria/0/objective",
         "the nearest is \"control\""},
        {"/lesson/criteria/0/id", "fall", "/lesson/criteria/1/id", "a name of its own"},
        {"/lesson/criteria/8/orders", {"lett-go"}, "/lesson/criteria/8/orders", "the nearest is \"let-go\""},
        {"/lesson/criteria/9/report", "defect", "/lesson/criteria/9/truth", "when is \"defect\" true?"},
        {"/lesson/orders/2/value", nullptr, "/lesson/orders/2/value", "how far the cable is to go out"},
        {"/lesson/orders/0/when", {{"done", "secure"}}, "/lesson/orders/0/when", "put it behind that one"},
        {"/lesson/orders/0/side", "starboard", "/lesson/orders/0/side", "no windlass there"},
        {"/lesson/moments/bottom",
         {{"event", "anchor.on_botom"}},
         "/lesson/moments/bottom/event",
         "the nearest is \"anchor.on_bottom\""},
        {"/lesson/moments/bottom",
         {{"cable_speed", {{"above", 3}, {"below", 2}}}},
         "/lesson/moments/bottom/cable_speed",
         "nothing can lie between"},
        {"/lesson/moments/bottom",
         {{"time", 5}, {"since", 5}},
         "/lesson/moments/bottom/since",
         "use \"for\""},
        {"/lesson/faults",
         {{{"code", "brake-lining-fadet"}}},
         "/lesson/faults/0/code",
         "the nearest is \"brake-lining-faded\""},
        {"/lesson/errors/0/fails", {"xyzzy"}, "/lesson/errors/0/fails", "there are"},
        {"/lesson/end/abort", {"cable.lots"}, "/lesson/end/abort", "the nearest is \"cable.lost\""},
        {"/lesson/end/accidents",
         {{{"when", json::object()}, {"say", "x"}}},
         "/lesson/end/accidents/0/when",
         "names nothing"},
        {"/lesson/hints/0/criterion", "fal", "/lesson/hints/0/criterion", "the nearest is \"fall\""},
        {"/lesson/hints/0/id", "runs-on", "/lesson/hints/1/id", "a name of its own"},
        {"/lesson/hints/0/say", " ", "/lesson/hints/0/say", "is empty"},
        {"/lesson/hints/0/say", nullptr, "/lesson/hints/0", "say"},
        {"/lesson/hints/0/when", json::object(), "/lesson/hints/0/when", "names nothing"},
        {"/lesson/hints/0/when", {{"not", "botom"}}, "/lesson/hints/0/when/not", "the nearest is \"bottom\""},
        {"/lesson/hints/0/seat", "engine", "/lesson/hints/0/seat", "forecastle"},
        {"/lesson/briefings", {{"deck", "x"}}, "/lesson/briefings", "forecastle"},
        {"/lesson/practice", "yes", "/lesson/practice", "true"},
        {"/lesson/pass", 170, "/lesson/pass", "0 to 100"},
        {"/lesson/bridge", "empty", "/lesson/bridge", "manned"},
        {"/lesson/schedule",
         {{{"at", 60}, {"wind_speed", 9}}, {{"at", 30}, {"wind_speed", 9}}},
         "/lesson/schedule/1/at",
         "put the earlier change first"},
    };
    for (const auto& mistake : mistakes) {
        json document = good_lesson();
        const json::json_pointer place(mistake.place);
        if (mistake.value.is_null())
            document[place.parent_pointer()].erase(place.back());
        else
            document[place] = mistake.value;
        const std::string said = said_of(document);
        EXPECT_THAT(said, HasSubstr(std::string("my.json: ") + mistake.where)) << mistake.place;
        EXPECT_THAT(said, HasSubstr(mistake.remedy)) << mistake.place;
    }
}

TEST(LessonFile, ScriptThatLooksAtTheTruthIsRefused) {
    const fs::path folder = fs::path(testing::TempDir()) / "windlass-lesson-scripts";
    fs::create_directories(folder);
    const fs::path file = folder / "peeps.json";
    std::ofstream(file) << R"({"steps": [{"when": {"anchor_on_bottom": true}, "say": "on the bottom"}]})";
    try {
        load_scripts({file});
        FAIL() << "was taken";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("/steps/0/when/anchor_on_bottom"));
    }
    fs::remove_all(folder);
}

TEST(LessonFile, NewOneIsSoundAsItIsWritten) {
    EXPECT_EQ(said_of(json::parse(new_lesson("L99", {}))), "");
}

// What is not to be missed is a must. Where all else is whole, one criterion that is no must leaves half of
// its objective, below which that fails the lesson, and the points to pass: no single word fails a lesson
// that was safe.
TEST(LessonFile, OfAShippedOneNoCriterionFailsItAloneThatIsNoMust) {
    const auto judged = [](const assess::Criterion& one) {
        return one.kind != assess::CriterionKind::rubric;
    };
    const auto guards = [](const assess::Criterion& one) {
        return one.kind == assess::CriterionKind::limit || one.kind == assess::CriterionKind::prohibited;
    };
    int looked_at = 0;
    for (const fs::path& path : lesson_files(kConfig / "exercises")) {
        const assess::Lesson lesson = read_lesson_file(path).lesson;
        // What guards earns in the measure of what was done: a deed that is lost takes its share of both.
        const auto share = [&](const assess::Criterion& of, bool in_objective) {
            int whole = 0;
            for (const assess::Criterion& one : lesson.criteria)
                if (judged(one) && (guards(of) || !guards(one)) &&
                    (!in_objective || one.objective == of.objective))
                    whole += one.weight;
            return 100.0 * of.weight / whole;
        };
        for (const assess::Criterion& one : lesson.criteria) {
            if (one.must || !judged(one)) continue;
            ++looked_at;
            EXPECT_LE(share(one, false), 100 - lesson.pass) << lesson.id << ": " << one.id;
            for (const assess::Objective& objective : lesson.objectives)
                if (objective.id == one.objective) {
                    EXPECT_LE(share(one, true), 100 - objective.least()) << lesson.id << ": " << one.id;
                }
        }
    }
    EXPECT_GT(looked_at, 100);
}

// The schema is written by hand beside the table: whatever the one has, the other has.
TEST(LessonFile, SchemaOfConditionsHasEveryFigureOfTheTable) {
    const json schema = read_json(kConfig / "schema/lesson_condition.schema.json").at("properties");
    for (const assess::Quantity& quantity : assess::quantities())
        EXPECT_TRUE(schema.contains(quantity.name)) << quantity.name;
    const std::set<std::string> others{"side",  "time",   "clutch", "stopper", "anchor",   "event",
                                       "times", "report", "moment", "given",   "repeated", "answered",
                                       "done",  "either", "not",    "since",   "for",      "challenged"};
    for (const auto& [name, unused] : schema.items())
        EXPECT_TRUE(others.contains(name) || assess::quantity_of(name) >= 0) << name;
}

} // namespace windlass::console
