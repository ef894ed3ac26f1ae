// The model's hands beside a trainee: what he is shown is what they do, never later than his own time, and
// never past what his own lesson has brought.

#include "lesson/beside.hpp"
#include "server/config/config.hpp"
#include "server/host/companion.hpp"
#include "server/run/course.hpp"

#include "tests/run/session_rig.hpp"

#include <gtest/gtest.h>

namespace windlass::lesson {
namespace {

using host::Companion;
using run::test::give;
using run::test::run_order;
using namespace std::chrono_literals;

const std::filesystem::path kConfig = WINDLASS_CONFIG_DIR;

run::ModelHandsFrom hands_from_config() {
    return [](const run::Beginning& beginning) { return model_beside(beginning, kConfig); };
}

run::SessionOptions options() {
    run::SessionOptions options;
    options.seed = 7;
    options.fault_folder = testing::TempDir();
    options.model_hands = hands_from_config();
    return options;
}

exercise::ExerciseDef for_practice(const char* file) {
    exercise::ExerciseDef def = config::load_exercise(kConfig / "exercises" / file);
    def.lesson = assess::for_practice(def.lesson);
    return def;
}

/// A trainee with a companion whose lookout has all the time that it wants, at each tenth of a second.
class CompanionTest : public testing::Test {
protected:
    explicit CompanionTest(const char* file = "L01_let_go_25m.json")
        : session_(for_practice(file), options()) {}

    void ask(assess::AidKind kind, bool forecastle = true) {
        const auto word = assess::write_aid({.kind = kind, .forecastle = forecastle, .on = true});
        give(session_, run::AnswerOrder{forecastle, word}, session_.now_time(), "trainee");
    }
    void report(const exercise::ReportMade& report) {
        give(session_, exercise::Order{report}, session_.now_time(), "trainee");
    }
    /// Goes on to that time, s.
    void run_to(double time) {
        while (session_.now_time() < time - 1e-9) {
            session_.tick();
            for (const auto& event : session_.events())
                if (event.code.starts_with("hint.")) hints_.push_back(event.text);
            session_.clear_news();
            if (session_.now_tick() % 30 == 0) beat();
        }
    }
    void beat() {
        now_ += Companion::kApart;
        companion_.look(session_, now_, [this](const dds::Ghost& hands, bool forecastle) {
            (forecastle ? shown_ : shown_bridge_) = hands;
            latest_ = std::max(latest_, hands.bridge.time() - session_.now_time());
            ++times_;
        });
        for (int turns = 0; turns < 100'000 && companion_.go_on(); ++turns) {
        }
    }

    run::Session session_;
    Companion companion_{hands_from_config()};
    Companion::Time now_{1h};
    dds::Ghost shown_, shown_bridge_;
    double latest_ = -1e9; // s by which what was shown was ahead of him, at most
    int times_ = 0;
    std::vector<std::string> hints_;
};

TEST_F(CompanionTest, NothingIsShownUnlessItIsAskedFor) {
    run_to(3);
    EXPECT_EQ(times_, 0);
    ask(assess::AidKind::ghost);
    run_to(6);
    EXPECT_GT(times_, 20);
    EXPECT_TRUE(shown_bridge_.forecastle.empty()) << "the bridge has not asked";
}

TEST_F(CompanionTest, ShowsWhatTheModelsHandsDoAndNothingOfTheRest) {
    run_to(0.2);
    ask(assess::AidKind::ghost);
    run_to(3.2);
    const auto hands = model_beside(session_.beginning(), kConfig);
    ASSERT_EQ(shown_.forecastle.size(), 1U);
    const ForecastleView& shown = shown_.forecastle.front();
    while (hands->tick() < shown.tick())
        ASSERT_TRUE(hands->step());
    const exercise::Snapshot& seen = hands->seen();
    EXPECT_EQ(shown.brake_position(), seen.tackle[0].windlass.brake_position);
    EXPECT_EQ(shown.speed_lever(), seen.tackle[0].windlass.speed_lever);
    EXPECT_LE(latest_, 0);
    EXPECT_GT(session_.now_time() - shown.time(), -1e-9);
    EXPECT_LT(session_.now_time() - shown.time(), 0.35) << "as of now, nearly";
    EXPECT_EQ(shown.ship_heading(), 0);
    EXPECT_EQ(shown.motor_current(), 0);
    EXPECT_EQ(shown.nodes().size(), 0U);
}

/// The second order comes once the first is answered. The model answers; this trainee does not.
TEST_F(CompanionTest, WaitsForWhatTheTraineesLessonHasNotBrought) {
    ask(assess::AidKind::ghost);
    run_to(60);
    const auto hands = model_beside(session_.beginning(), kConfig);
    while (hands->state().orders[1].given < 0)
        ASSERT_TRUE(hands->step());
    const auto second = static_cast<std::uint64_t>(hands->state().orders[1].given);
    ASSERT_LT(second, 50U * 300) << "the model comes to the second order well before that";
    ASSERT_LT(session_.assessor().state().orders[1].given, 0) << "and this trainee does not";
    ASSERT_EQ(shown_.forecastle.size(), 1U);
    EXPECT_LE(shown_.forecastle.front().tick(), second);
    EXPECT_GT(shown_.forecastle.front().tick() + 60, second) << "up to there it is shown";
    EXPECT_LE(latest_, 0);
    // He answers: they go on, as late as they have come to be.
    const exercise::BridgeOrderView& first = session_.snapshot().bridge_orders.front();
    report({.code = exercise::ReportCode::order_repeated,
            .side = first.given.side,
            .value = first.given.value,
            .order_number = first.number,
            .order_code = first.given.code});
    report({.code = exercise::ReportCode::standing_by, .side = 0});
    run_to(90);
    ASSERT_GE(session_.assessor().state().orders[1].given, 0);
    EXPECT_GT(shown_.forecastle.front().tick(), second + 300);
    EXPECT_LE(latest_, 0);
}

TEST_F(CompanionTest, AskedForLateTheyCatchUp) {
    run_to(5);
    ask(assess::AidKind::ghost);
    run_to(5.5);
    ASSERT_FALSE(shown_.forecastle.empty());
    EXPECT_LT(session_.now_time() - shown_.forecastle.front().time(), 0.35);
}

TEST_F(CompanionTest, AskedForLateTheyCatchUpToWhereTheyWait) {
    run_to(60); // and nobody has answered the first order
    ask(assess::AidKind::ghost);
    run_to(62);
    ASSERT_FALSE(shown_.forecastle.empty());
    EXPECT_LT(shown_.forecastle.front().time(), 50);
    EXPECT_GT(shown_.forecastle.front().time(), 1);
}

/// As from a recording, or after its server was lost.
TEST_F(CompanionTest, AnAttemptThatIsGoneOnWithElsewhereHasThem) {
    run_to(5);
    const std::vector<std::uint8_t> kept = session_.state();
    give(session_, run_order(run::RunAction::reset));
    give(session_, run::StateOrder{.from = "monday", .checkpoint = kept});
    give(session_, run_order(run::RunAction::start));
    ask(assess::AidKind::ghost);
    run_to(6);
    ASSERT_FALSE(shown_.forecastle.empty());
    EXPECT_LT(session_.now_time() - shown_.forecastle.front().time(), 0.35);
}

TEST_F(CompanionTest, TheExerciseIsTheSameWithThemAndWithout) {
    ask(assess::AidKind::ghost);
    run_to(5);
    run::Session alone(for_practice("L01_let_go_25m.json"), options());
    while (alone.now_tick() < session_.now_tick())
        alone.tick();
    EXPECT_EQ(alone.snapshot().state_hash, session_.snapshot().state_hash);
}

class CompanionInL15 : public CompanionTest {
protected:
    CompanionInL15() : CompanionTest("L15_motor_overhauled.json") {}
};

/// Its faults come some seconds after the cable has been hove: this trainee does not heave.
TEST_F(CompanionInL15, HandsThatMeetAFaultGiveNothingOfItAwayBeforeItComes) {
    ask(assess::AidKind::ghost);
    run_to(150);
    const auto hands = model_beside(session_.beginning(), kConfig);
    const auto met = [&] {
        return std::ranges::any_of(hands->state().faults, [](int fault) { return fault > 0; });
    };
    while (!met())
        ASSERT_TRUE(hands->step());
    ASSERT_LT(hands->tick(), 120U * 300) << "the model meets it well before that";
    ASSERT_TRUE(
        std::ranges::all_of(session_.assessor().state().faults, [](int fault) { return fault == 0; }));
    EXPECT_LE(shown_.forecastle.front().tick(), hands->tick());
    EXPECT_GT(shown_.forecastle.front().tick() + 60, hands->tick());
}

/// To the bit, with the chance that was drawn when it began: its fault comes at the same tick.
TEST_F(CompanionInL15, ItsHandsBeginAsTheAttemptBegan) {
    const std::vector<std::uint8_t> first = session_.state();
    run_to(20);
    run::Session elsewhere(for_practice("L01_let_go_25m.json"), options());
    give(elsewhere, run::StateOrder{.from = "monday", .checkpoint = session_.state()});
    const run::Beginning beginning = elsewhere.beginning();
    EXPECT_EQ(run::beginning_of(beginning.def, beginning.seed).checkpoint(), first);
}

/// Their faults and weather, of a lesson that has both.
TEST(ModelBeside, WhatALessonBringsIsNoIntervention) {
    for (const char* file : {"L15_motor_overhauled.json", "L07_second_anchor.json"}) {
        const exercise::ExerciseDef def = for_practice(file);
        const auto hands = model_beside({.def = def, .seed = 9}, kConfig);
        const assess::State& state = hands->state();
        while (std::ranges::all_of(state.faults, [](int fault) { return fault == 0; }) && state.changes == 0)
            ASSERT_TRUE(hands->step()) << file;
        ASSERT_TRUE(hands->step());
        EXPECT_FALSE(state.intervened) << file;
        hands->take(exercise::EnvironmentOrder{});
        EXPECT_TRUE(state.intervened) << file;
    }
}

TEST(ModelBeside, IsNotToBeHadWithoutItsScriptsAModelRunOrAnExercise) {
    const exercise::ExerciseDef def = for_practice("L01_let_go_25m.json");
    EXPECT_NO_THROW(model_beside({.def = def, .seed = 0}, kConfig));
    EXPECT_THROW(model_beside({.def = def, .seed = 0}, "/nowhere"), std::exception);
    exercise::ExerciseDef no_lesson = def, no_tackle = def;
    no_lesson.lesson.clear();
    EXPECT_THROW(model_beside({.def = no_lesson, .seed = 0}, kConfig), std::exception);
    no_tackle.tackle.clear();
    EXPECT_THROW(model_beside({.def = no_tackle, .seed = 0}, kConfig), std::exception);
}

TEST_F(CompanionTest, AHintComesAndIsCounted) {
    run_to(2);
    ask(assess::AidKind::hint);
    run_to(3);
    ASSERT_EQ(hints_.size(), 1U);
    const bool names_a_lever = hints_[0].ends_with(" now.");
    EXPECT_EQ(session_.assessor().result().hints.size(), names_a_lever ? 1U : 0U) << hints_[0];
    EXPECT_FALSE(session_.hint_wanted());
}

} // namespace
} // namespace windlass::lesson
