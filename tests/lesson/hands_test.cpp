// Every shipped lesson against hands that its author did not write: nothing wrong is achieved or above 50,
// nothing right is not achieved, and nothing done gets below 5.

#include "instructor_console/hands_table.hpp"
#include "instructor_console/lesson_files.hpp"
#include "lesson/hands.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace windlass::console {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files() {
    return lesson_files(fs::path(WINDLASS_CONFIG_DIR) / "exercises");
}

std::vector<trainee::Script> model_of(const LessonFile& file) {
    std::vector<fs::path> scripts;
    for (const std::string& script : file.lesson.model_run.scripts)
        scripts.push_back(file.root / script);
    return load_scripts(scripts);
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
    std::string name = info.param.stem().string();
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

class Hands : public testing::TestWithParam<fs::path> {};

} // namespace

TEST_P(Hands, GetWhatACaptainWouldSay) {
    const LessonFile file = read_lesson_file(GetParam());
    for (const lesson::Hand& hand : lesson::hands(file.lesson, model_of(file)))
        EXPECT_EQ(lesson::fault_of(hand, lesson::play(file.def, hand.parts)), "")
            << hand.name << ", who " << hand.about;
}

INSTANTIATE_TEST_SUITE_P(Every, Hands, testing::ValuesIn(files()), name_of);

// A hand that differs in nothing from the model run would show nothing.
TEST(GenericHands, DifferFromTheModelRun) {
    const LessonFile file = read_lesson_file(fs::path(WINDLASS_CONFIG_DIR) / "exercises/L01_let_go_25m.json");
    const auto hands = lesson::hands(file.lesson, model_of(file));
    EXPECT_EQ(hands.size(), lesson::hand_rows().size()) << "L01 has orders, figures, a wheel and reports";
    const LessonFile watch =
        read_lesson_file(fs::path(WINDLASS_CONFIG_DIR) / "exercises/A09_box_ship_gard.json");
    for (const lesson::Hand& hand : lesson::hands(watch.lesson, model_of(watch)))
        EXPECT_NE(hand.name, "one_over") << "nothing is paid out there";
}

// A5's model run has as many steps as the hand who closes all, with other conditions.
TEST(GenericHands, AreMadeOfAModelRunOfAsManySteps) {
    const LessonFile file =
        read_lesson_file(fs::path(WINDLASS_CONFIG_DIR) / "exercises/A05_royal_pescadores.json");
    const auto model = model_of(file);
    ASSERT_EQ(model.size(), 1U);
    ASSERT_EQ(model[0].steps.size(), 3U);
    EXPECT_GT(lesson::hands(file.lesson, model).size(), 5U);
}

// Nobody repeats a question back: where the bridge only asks, as in A5, a wrong repeat has nothing to be
// wrong about.
TEST(GenericHands, RepeatWronglyOnlyWhatIsRepeated) {
    const fs::path exercises = fs::path(WINDLASS_CONFIG_DIR) / "exercises";
    const auto repeats_wrongly = [&](const char* name) {
        const LessonFile file = read_lesson_file(exercises / name);
        const auto hands = lesson::hands(file.lesson, model_of(file));
        return std::ranges::find(hands, "wrong_repeats", &lesson::Hand::name) != hands.end();
    };
    EXPECT_FALSE(repeats_wrongly("A05_royal_pescadores.json"));
    EXPECT_TRUE(repeats_wrongly("A09_box_ship_gard.json"));
}

TEST(GenericHands, OfWhichALessonSaysWhatItShouldMakeOfThem) {
    LessonFile file = read_lesson_file(fs::path(WINDLASS_CONFIG_DIR) / "exercises/L01_let_go_25m.json");
    file.lesson.hands = {{"patient", "fail"}};
    for (const lesson::Hand& hand : lesson::hands(file.lesson, model_of(file)))
        if (hand.name == "patient") {
            EXPECT_EQ(hand.should, lesson::Should::fail);
        }
}

// The bridge gives two orders, the forecastle repeats them, and nothing is done: 25 points once.
TEST(MannedBridge, WhoseCrewRepeatsAndDoesNothingGetsNearlyNothing) {
    const LessonFile file = read_lesson_file(fs::path(WINDLASS_CONFIG_DIR) / "exercises/L27_the_conn.json");
    trainee::Script bridge{.title = {}, .repeats_orders = {}, .conns = true, .steps = {}};
    for (const BridgeOrderCode code : {BRIDGE_ORDER_STAND_BY, BRIDGE_ORDER_LET_GO}) {
        trainee::Step step;
        step.when.after = 10;
        step.order = trainee::BridgesOrder{.code = code, .side = {}, .text = {}};
        step.timeout = 1e9;
        bridge.steps.push_back(step);
    }
    const trainee::Script forecastle{.title = {}, .repeats_orders = 2, .steps = {}};
    const auto played = lesson::play(file.def, std::vector{bridge, forecastle});
    EXPECT_LT(played.result.tenths, 10 * lesson::kIdleMost);
    EXPECT_NE(played.result.outcome, assess::Outcome::achieved);
    bridge.steps.pop_back();
    EXPECT_EQ(lesson::play(file.def, std::vector{bridge, forecastle}).result.tenths, 0);
}

// What --output writes.
TEST(HandsTable, SaysOfEachLessonAndHandWhatItGotAndShould) {
    using lesson::Should;
    const auto got = [](assess::Outcome outcome, int tenths) {
        lesson::Played played;
        played.result.outcome = outcome;
        played.result.tenths = tenths;
        return played;
    };
    const auto hand = [](const char* name, Should should) {
        lesson::Hand one;
        one.name = name;
        one.should = should;
        return one;
    };
    HandsTable table;
    table.add("L01", hand("idle", Should::fail), got(assess::Outcome::not_shown, 0));
    table.add("L01", hand("silent", Should::fail), got(assess::Outcome::not_yet, 501));
    table.add("L01", hand("patient", Should::pass), got(assess::Outcome::achieved, 1000));
    table.add("L02", hand("patient", Should::end), got(assess::Outcome::not_yet, 234));
    const std::string text = table.document("docs/hands.md", "two cores, commit 0123456");
    EXPECT_THAT(text, testing::HasSubstr("--output docs/hands.md`: two cores, commit 0123456."));
    EXPECT_THAT(text, testing::HasSubstr("\n| lesson | idle |"));
    EXPECT_THAT(text, testing::HasSubstr("\n| *should* | *fail* |"));
    EXPECT_THAT(text, testing::HasSubstr("\n| L01 | 0.0 |  |  |  |  | 50.1 - **?** |"))
        << "more than wrong gets";
    EXPECT_THAT(text, testing::HasSubstr(" 100.0 + |\n| L02 |"));
    EXPECT_THAT(text, testing::HasSubstr(" 23.4 - (end) |\n")) << "its lesson says another thing";
    for (const lesson::HandRow& row : lesson::hand_rows())
        EXPECT_THAT(text, testing::HasSubstr(std::string("\n| ") + row.name + " | " + row.about + " |"));
}

} // namespace windlass::console
