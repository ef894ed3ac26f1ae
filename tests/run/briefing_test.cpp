// What the trainees of a lesson read before it begins reaches their seats as events.

#include "server/run/briefing.hpp"

#include "server/exercise/checkpoint.hpp"
#include "tests/run/session_rig.hpp"

#include <future>

namespace windlass::run::test {
namespace {

constexpr std::size_t kRoom = 255; // bytes of SeatEvent.text

assess::Lesson lesson(const std::string& briefing, bool manned = false) {
    assess::Lesson lesson;
    lesson.briefing = briefing;
    lesson.bridge_manned = manned;
    return lesson;
}

std::string whole(const std::vector<std::string>& pieces) {
    std::string text;
    for (const std::string& piece : pieces)
        text += (text.empty() ? "" : " ") + piece;
    return text;
}

TEST(Briefing, BreaksAtSpacesAndIsWholeAgain) {
    std::string text;
    for (int k = 0; k < 120; ++k)
        text += (k == 0 ? "" : " ") + std::to_string(1000 + 7 * k);
    const auto pieces = briefing_pieces(lesson(text));
    EXPECT_GE(pieces.size(), 3U);
    for (const std::string& piece : pieces)
        EXPECT_LE(piece.size(), kRoom);
    EXPECT_EQ(whole(pieces), text + " The bridge's orders come by themselves.");
}

TEST(Briefing, OfTheLongestWordAndOfLinesFitsTheWire) {
    for (const std::string& text :
         {std::string(4096, 'x'), std::string("one\ntwo\tthree"), std::string(600, ' ')})
        for (const std::string& piece : briefing_pieces(lesson(text))) {
            EXPECT_LE(piece.size(), kRoom);
            EXPECT_EQ(piece.find('\n'), std::string::npos);
        }
}

TEST(Briefing, SaysWhoGivesTheBridgesOrders) {
    EXPECT_EQ(whole(briefing_pieces(lesson("Let go.", true))),
              "Let go. The bridge's orders come from its own seat.");
}

TEST(Briefing, SaysWhereItsShacklesAreCounted) {
    EXPECT_EQ(whole(briefing_pieces(lesson("Hold on at 6 shackles."))),
              "Hold on at 6 shackles. The bridge's orders come by themselves. Where no other place is said, "
              "shackles are counted in the pipe.");
}

TEST(Briefing, SaysWhatSecuredIs) {
    EXPECT_EQ(
        whole(briefing_pieces(lesson("Heave up, say when it is secured."))),
        "Heave up, say when it is secured. The bridge's orders come by themselves. Secured is: brake hard "
        "on, stopper on, gear out.");
}

class BriefingOfASession : public SessionTest {
protected:
    static exercise::ExerciseDef def() {
        exercise::ExerciseDef def;
        def.lesson =
            R"({"id": "T", "briefing": "Let go on order.", "criteria": [)"
            R"({"id": "p", "kind": "prohibited", "that": {"clutch": "in"}}]})"; // one line, as files are read
        return def;
    }
};

TEST_F(BriefingOfASession, IsToldAtTheSetUpAndAfterARestore) {
    Session session(def(), options());
    EXPECT_EQ(text_of(session, "exercise.briefing"),
              "Let go on order. The bridge's orders come by themselves.");
    session.clear_news();
    RunOrder back;
    back.action = RunAction::restore;
    give(session, back);
    EXPECT_EQ(count(session, "exercise.restored"), 1) << text_of(session, "command.refused");
    EXPECT_EQ(count(session, "exercise.briefing"), 1);
    session.clear_news();
    give(session, run_order(RunAction::reset));
    EXPECT_EQ(count(session, "exercise.briefing"), 1);
}

class OneSeatAlone : public SessionTest {
protected:
    static exercise::ExerciseDef def(const std::string& more = {}) {
        exercise::ExerciseDef def;
        def.lesson =
            "{" + more +
            R"("id": "T", "hints": [{"id": "h", "when": {"time": 0.1, "cable_speed": {"below": 99}}, "say": "Ease it."}, )"
            R"({"id": "b", "seat": "bridge", "when": {"time": 0.2, "cable_speed": {"below": 99}}, "say": "Ring it."}], )"
            R"("criteria": [{"id": "p", "kind": "prohibited", "that": {"clutch": "in"}}]})";
        return def;
    }
    static constexpr const char* kOwn = R"("briefings": {"forecastle": "One shackle.", "bridge": "Two."}, )";

    /// Codes and times of the hints from now on.
    static std::vector<std::pair<std::string, std::uint64_t>> hints(Session& session, int ticks) {
        std::vector<std::pair<std::string, std::uint64_t>> all;
        for (int i = 0; i < ticks; ++i) {
            session.tick();
            for (const auto& event : session.events())
                if (event.code.starts_with("hint.")) all.emplace_back(event.code, event.tick);
            session.clear_news();
        }
        return all;
    }
};

TEST_F(OneSeatAlone, IsToldItsOwnBriefingAndThatThereIsNoneAnyMore) {
    SessionOptions options = this->options();
    options.load = [](const std::string&) {
        std::promise<exercise::ExerciseDef> read;
        read.set_value(def());
        return Reading{.def = read.get_future(), .in_hand = {}};
    };
    Session session(def(kOwn), options);
    EXPECT_EQ(text_of(session, "briefing.forecastle"), "One shackle.");
    EXPECT_EQ(text_of(session, "briefing.bridge"), "Two.");
    EXPECT_EQ(text_of(session, "exercise.briefing"), "The bridge's orders come by themselves.");
    for (const int again : {1, 0}) {
        session.clear_news();
        give(session, run_order(RunAction::load));
        EXPECT_EQ(count(session, "briefing.forecastle"), again);
        EXPECT_EQ(text_of(session, "briefing.bridge"), again == 1 ? "nothing for this seat alone" : "");
    }
}

TEST_F(OneSeatAlone, HasItsHintsInPracticeAloneAndTheSameAfterARestore) {
    Session test(def(), options());
    give(test, levers(1));
    EXPECT_TRUE(hints(test, 300).empty());

    exercise::ExerciseDef practice = def();
    put_to_practice(practice);
    Session session(practice, options());
    give(session, levers(1));
    EXPECT_TRUE(text_of(session, "exercise.briefing").ends_with("it is no test of competence."));
    const auto first = hints(session, 45);
    ASSERT_EQ(first.size(), 1U);
    EXPECT_EQ(first[0].first, "hint.forecastle");
    session.take_checkpoint_now();
    const auto second = hints(session, 60);
    ASSERT_EQ(second.size(), 1U) << "each once";
    EXPECT_EQ(second[0].first, "hint.bridge");
    const auto hash = session.assessor().result().assessment_hash;

    RunOrder back = run_order(RunAction::restore);
    back.restore_time = session.now_time();
    give(session, back);
    EXPECT_EQ(session.assessor().result().hints.size(), 1U);
    give(session, run_order(RunAction::start));
    EXPECT_EQ(hints(session, 60), second);
    EXPECT_EQ(session.assessor().result().assessment_hash, hash);

    give(session, run_order(RunAction::reset));
    EXPECT_TRUE(session.assessor().lesson()->practice) << "it is for practice until another is loaded";
}

TEST_F(OneSeatAlone, HasItsPracticeToWhereTheExerciseBeginsAtAnchor) {
    exercise::ExerciseDef practice = def();
    practice.settled = std::make_shared<const std::vector<std::uint8_t>>(
        exercise::write_checkpoint(exercise::Exercise(practice)));
    practice.tackle[0].at_anchor = 5; // as if that were what the prelude came to
    put_to_practice(practice);
    Session session(practice, options());
    EXPECT_TRUE(session.assessor().lesson()->practice);
    EXPECT_TRUE(text_of(session, "exercise.briefing").ends_with("it is no test of competence."));
}

TEST_F(OneSeatAlone, IsNotPutToPracticeWithoutALesson) {
    exercise::ExerciseDef none;
    none.name = "bare";
    EXPECT_THROW(put_to_practice(none), std::invalid_argument);
}

class EndOfALesson : public SessionTest {
protected:
    /// more: fields of the lesson, each with a comma behind it.
    static exercise::ExerciseDef def(const std::string& more = {}) {
        exercise::ExerciseDef def;
        def.lesson = "{" + more +
                     R"("id": "T", "end": {"time": 0.5}, "criteria": [)"
                     R"({"id": "p", "kind": "prohibited", "that": {"clutch": "in"}}]})";
        return def;
    }
    static void run(Session& session, int ticks) {
        for (int i = 0; i < ticks; ++i)
            session.tick();
    }
};

TEST_F(EndOfALesson, IsToldToTheSeatsOnceWithWhatEndedItAndNoMark) {
    Session session(def(), options());
    give(session, levers(1));
    run(session, 140);
    EXPECT_EQ(count(session, "lesson.over"), 0);
    run(session, 160);
    EXPECT_EQ(count(session, "lesson.over"), 1);
    EXPECT_EQ(text_of(session, "lesson.over"), "the lesson is over: its time is up");
    EXPECT_EQ(session.status().state, exercise::RunState::running);
}

TEST_F(EndOfALesson, IsForetoldToWhoHasTheTruthWhereTheBridgeHasNoAnswer) {
    exercise::ExerciseDef silent;
    silent.lesson = R"({"id": "T", "patience": 60, "orders": [
        {"id": "o", "code": "stand_by", "repeat": 1, "when": {"time": 0.1}}],
      "criteria": [{"id": "c", "kind": "order", "orders": ["o"]}], "end": {"good": {"answered": "o"}}})";
    Session session(silent, options());
    run(session, 29 * silent.tick_rate_hz); // nobody has said anything yet
    EXPECT_EQ(count(session, "assessment.unanswered"), 0);
    run(session, 2 * silent.tick_rate_hz);
    EXPECT_EQ(text_of(session, "assessment.unanswered"),
              "the bridge asks again: if it hears nothing it gives up at 2:00, and the lesson ends");
}

TEST_F(EndOfALesson, IsForetoldAgainWhereARestoreLeadsIntoTheBridgesAsking) {
    exercise::ExerciseDef silent;
    silent.lesson = R"({"id": "T", "patience": 60, "orders": [)" // one line, as files are read
                    R"({"id": "o", "code": "stand_by", "repeat": 1, "when": {"time": 0.1}}], )"
                    R"("criteria": [{"id": "c", "kind": "order", "orders": ["o"]}], )"
                    R"("end": {"good": {"answered": "o"}}})";
    Session session(silent, options());
    run(session, 31 * silent.tick_rate_hz);
    ASSERT_EQ(count(session, "assessment.unanswered"), 1);
    session.take_checkpoint_now();
    RunOrder back = run_order(RunAction::restore);
    back.restore_time = session.now_time();
    session.clear_news();
    give(session, back);
    EXPECT_EQ(text_of(session, "assessment.unanswered"),
              "the bridge asks again: if it hears nothing it gives up at 2:00, and the lesson ends");
    session.clear_news();
    back.restore_time = 0;
    give(session, back);
    EXPECT_EQ(count(session, "exercise.restored"), 1);
    EXPECT_EQ(count(session, "assessment.unanswered"), 0) << "it had not asked then";
}

TEST_F(EndOfALesson, OverAnOrderThatWasRepeatedWronglyIsNoWantOfAnAnswer) {
    exercise::ExerciseDef misheard;
    misheard.lesson = R"({"id": "T", "patience": 60, "orders": [
        {"id": "o", "code": "stand_by", "repeat": 1, "when": {"time": 0.1}}],
      "criteria": [{"id": "c", "kind": "order", "orders": ["o"]}], "end": {"good": {"answered": "o"}}})";
    Session session(misheard, options());
    for (int repeats = 0; repeats < 30 && count(session, "lesson.over") == 0; ++repeats) {
        run(session, 4 * misheard.tick_rate_hz);
        give(session, exercise::Order{exercise::ReportMade{.code = exercise::ReportCode::order_repeated,
                                                           .order_number = count(session, "order.given"),
                                                           .order_code = exercise::BridgeOrderCode::let_go}});
    }
    EXPECT_EQ(text_of(session, "lesson.over"),
              "the lesson is over: an order was repeated back wrongly to the last");
}

TEST_F(EndOfALesson, OverAQuestionThatWasAnsweredFalselyToTheLastIsNoWantOfAnAnswer) {
    exercise::ExerciseDef lied;
    lied.lesson = R"({"id": "T", "patience": 1,
      "criteria": [{"id": "p", "kind": "prohibited", "that": {"clutch": "in"}}],
      "end": {"good": {"report": "clear_anchor"}}})";
    Session session(lied, options());
    int answered = 0;
    for (int looks = 0; looks < 100 && count(session, "lesson.over") == 0; ++looks) {
        run(session, lied.tick_rate_hz / 10);
        if (count(session, "order.given") == answered) continue;
        ++answered; // how much cable is out? He does not look
        give(session, exercise::Order{exercise::ReportMade{
                          .code = exercise::ReportCode::shackles_in_pipe, .side = 0, .value = 9}});
    }
    EXPECT_EQ(answered, 3);
    EXPECT_EQ(count(session, "assessment.answered"), 0);
    EXPECT_EQ(count(session, "assessment.unanswered"), 3) << "each time that it asks";
    EXPECT_EQ(count(session, "assessment.misled"), 3) << "and each time that it is lied to";
    EXPECT_EQ(text_of(session, "lesson.over"), "the lesson is over: the bridge was told what is not so");
}

TEST_F(EndOfALesson, IsNoAssessorsWhoHasAWordOnItsMarksAlone) {
    const auto confirm = [](Session& session) {
        session.clear_news();
        give(session, exercise::Order{exercise::AssessorsWord{.criterion = {},
                                                              .verdict = exercise::AssessorVerdict::confirmed,
                                                              .milli = 0,
                                                              .note = "seen enough",
                                                              .by = "i"}});
    };
    Session session(def(), options());
    give(session, levers(1));
    run(session, 100);
    confirm(session);
    EXPECT_EQ(
        text_of(session, "command.refused"),
        "AssessmentCommand from instructor: criterion = \"\" refused; allowed: the code of a criterion: "
        "the whole is confirmed once the lesson is over");
    EXPECT_FALSE(session.assessor().ended());
    EXPECT_TRUE(session.orders().empty());
    run(session, 100);
    ASSERT_TRUE(session.assessor().ended());
    confirm(session);
    EXPECT_TRUE(session.assessor().state().confirmed);

    Session failed(def(), options());
    failed.fail("a test");
    confirm(failed);
    EXPECT_TRUE(failed.assessor().state().confirmed) << "its lesson never ends by itself";
    EXPECT_EQ(text_of(failed, "lesson.over"), "the lesson is over: it was ended");
}

TEST_F(EndOfALesson, IsToldWhenTheExerciseIsEnded) {
    Session stopped(def(), options());
    give(stopped, run_order(RunAction::stop));
    EXPECT_EQ(text_of(stopped, "lesson.over"), "the lesson is over: it was ended");
}

TEST_F(EndOfALesson, LetsTheSeatsHaveTheirMarksAndARestoreToBeforeItTakesThemBack) {
    Session session(def(), options());
    run(session, 100);
    EXPECT_FALSE(session.marks_are_told());
    give(session, levers(1));
    run(session, 200);
    EXPECT_TRUE(session.marks_are_told());
    RunOrder back;
    back.action = RunAction::restore;
    give(session, back);
    EXPECT_EQ(count(session, "exercise.restored"), 1);
    EXPECT_FALSE(session.marks_are_told());
}

TEST_F(EndOfALesson, KeepsTheMarksBackUntilAnAssessorHasConfirmedThemWhereItSaysSo) {
    Session session(def(R"("marks_told": "when_confirmed", )"), options());
    run(session, 300);
    EXPECT_FALSE(session.marks_are_told());
    give(session, exercise::Order{exercise::AssessorsWord{.criterion = {},
                                                          .verdict = exercise::AssessorVerdict::confirmed,
                                                          .milli = 0,
                                                          .note = "seen enough",
                                                          .by = "i"}});
    EXPECT_TRUE(session.marks_are_told());
}

TEST_F(EndOfALesson, IsToldAgainAfterARestoreToAMomentAfterItAndNotBefore) {
    Session session(def(), options());
    give(session, levers(1));
    run(session, 300);
    give(session, run_order(RunAction::snapshot));
    session.clear_news();
    RunOrder back;
    back.action = RunAction::restore;
    back.restore_time = 1;
    give(session, back);
    EXPECT_EQ(count(session, "lesson.over"), 1);
    session.clear_news();
    back.restore_time = 0;
    give(session, back);
    EXPECT_EQ(count(session, "exercise.restored"), 1);
    EXPECT_EQ(count(session, "lesson.over"), 0);
}

TEST_F(BriefingOfASession, IsNotThereWithoutALesson) {
    Session session({}, options());
    EXPECT_EQ(count(session, "exercise.briefing"), 0);
}

} // namespace
} // namespace windlass::run::test
