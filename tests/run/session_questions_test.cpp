// A lesson's question holds the exercise at its tick, until the asked seat has answered or an instructor goes
// on.

#include "server/exercise/checkpoint.hpp"
#include "server/run/course.hpp"

#include "tests/run/session_rig.hpp"

namespace windlass::run {
namespace {

using exercise::AnswerGiven;
using exercise::AnswerKind;
using exercise::RunState;
using test::count;
using test::give;
using test::run_order;
using test::text_of;

constexpr std::uint64_t kCue = 60; // tick: 0.2 s

exercise::ExerciseDef def() {
    exercise::ExerciseDef def;
    def.lesson =
        R"({"id": "T", "criteria": [)"
        R"({"id": "out", "kind": "question", "ask": "How much is out?", "of": "cable_out", "tolerance": 2,)"
        R"( "when": {"time": 0.2, "cable_speed": {"below": 99}}, "meant_for": 20},)"
        R"({"id": "gear", "kind": "question", "seat": "bridge", "ask": "Is she in gear?",)"
        R"( "when": {"time": 0.4, "cable_speed": {"below": 99}},)"
        R"( "choices": [{"answer": "in", "that": {"clutch": "in"}}, {"answer": "out", "that": {"clutch": "out"}}]}]})";
    return def;
}

AnswerOrder number(double value, const char* question = "out") {
    return {true, {.question = question, .kind = AnswerKind::number, .value = value}};
}
AnswerOrder choice(int place, bool forecastle = false) {
    return {forecastle, {.question = "gear", .kind = AnswerKind::choice, .choice = place}};
}

class SessionQuestions : public test::SessionTest {
protected:
    SessionQuestions() : session_(def(), options()) {}

    void run(int ticks) {
        for (int i = 0; i < ticks; ++i)
            session_.tick();
    }
    /// Up to the first question.
    void freeze() {
        session_.clear_news();
        run(kCue + 40);
    }
    double out() const { return session_.snapshot().tackle[0].chain.cable_out; }
    std::string refusal(OrderContent order) {
        session_.clear_news();
        give(session_, std::move(order));
        return text_of(session_, "command.refused");
    }
    std::optional<int> mark(std::size_t k) const {
        const auto& mark = session_.assessor().state().marks[k];
        return mark.decided < 0 ? std::nullopt : std::optional(mark.milli);
    }

    Session session_;
};

TEST_F(SessionQuestions, HoldAtTheVeryTickOfTheCueAndNothingMovesUntilTheAnswer) {
    freeze();
    EXPECT_EQ(session_.now_tick(), kCue);
    EXPECT_EQ(session_.status().state, RunState::paused);
    EXPECT_TRUE(session_.held());
    EXPECT_FALSE(session_.tick());
    ASSERT_EQ(session_.questions().size(), 1U);
    const QuestionView& question = session_.questions()[0];
    EXPECT_TRUE(question.forecastle);
    EXPECT_EQ(question.id, "out");
    EXPECT_EQ(question.text, "How much is out?");
    EXPECT_EQ(question.unit, "m");
    EXPECT_EQ(question.tick, kCue);
    EXPECT_EQ(question.meant_for, 20);
    EXPECT_EQ(session_.status().asked, (std::array{true, false}));
    EXPECT_EQ(count(session_, "question.asked"), 1);
    session_.clear_news();

    give(session_, number(out() + 1), 0, "trainee");
    EXPECT_EQ(session_.status().state, RunState::running);
    EXPECT_EQ(mark(0), 1000);
    ASSERT_EQ(session_.questions().size(), 1U);
    EXPECT_EQ(session_.questions()[0].id, "") << "nothing is asked any more";
    EXPECT_EQ(session_.orders().back().tick, kCue);
    EXPECT_EQ(session_.orders().back().source, "trainee");
    EXPECT_EQ(session_.status().asked, (std::array{false, false}));
    run(1);
    EXPECT_EQ(session_.now_tick(), kCue + 1);
    EXPECT_FALSE(session_.marks_are_told());
}

TEST_F(SessionQuestions, RefuseWhatIsNotAskedOfThatSeatOrIsNoAnswerToIt) {
    EXPECT_EQ(
        refusal(number(1)),
        "ForecastleAnswer from instructor: question = \"out\" refused; allowed: none: the forecastle is not "
        "asked anything now");
    freeze();
    EXPECT_EQ(refusal(choice(0)),
              "BridgeAnswer from instructor: question = \"gear\" refused; allowed: none: the "
              "bridge is not asked anything now");
    EXPECT_EQ(refusal(number(1, "gear")), "ForecastleAnswer from instructor: question = \"gear\" refused; "
                                          "allowed: \"out\", which is asked now");
    EXPECT_EQ(refusal(AnswerOrder{true, {.question = "out", .kind = AnswerKind::choice}}),
              "ForecastleAnswer from instructor: kind = ANSWER_CHOICE refused; allowed: ANSWER_NUMBER or "
              "ANSWER_NOT_KNOWN: the question wants a number");
    EXPECT_TRUE(session_.held());
    EXPECT_EQ(mark(0), std::nullopt);
    give(session_, number(99));
    EXPECT_EQ(mark(0), 0);
    run(100);
    EXPECT_EQ(refusal(choice(2)), "BridgeAnswer from instructor: choice = 2 refused; allowed: 0..1");
    EXPECT_NE(
        refusal(AnswerOrder{false, {.question = "gear", .kind = AnswerKind::number}}).find("has choices"),
        std::string::npos);
    give(session_, AnswerOrder{false, {.question = "gear", .kind = AnswerKind::not_known}});
    EXPECT_EQ(mark(1), 0);
    EXPECT_TRUE(session_.running());
}

TEST_F(SessionQuestions, AreGoneOnWithoutByAStart) {
    freeze();
    session_.clear_news();
    give(session_, run_order(RunAction::start));
    EXPECT_TRUE(session_.running());
    EXPECT_EQ(mark(0), std::nullopt) << "it counts for nobody";
    EXPECT_EQ(text_of(session_, "question.passed_over"), "out: instructor goes on without an answer");
    const auto& order = session_.orders().back();
    EXPECT_EQ(order.source, kServerName);
    EXPECT_EQ(std::get<AnswerGiven>(order.command).kind, AnswerKind::passed_over);
}

TEST_F(SessionQuestions, ThatAnInstructorPausesBesidesStayPausedAfterTheAnswer) {
    freeze();
    give(session_, run_order(RunAction::pause));
    give(session_, number(out()));
    EXPECT_EQ(mark(0), 1000);
    EXPECT_EQ(session_.status().state, RunState::paused);
    give(session_, run_order(RunAction::start));
    EXPECT_TRUE(session_.running());
}

TEST_F(SessionQuestions, AreOpenAgainAfterARestoreWithinTheFreezeAndMarkedTheSame) {
    freeze();
    give(session_, run_order(RunAction::snapshot));
    const auto frozen = *session_.checkpoint();
    give(session_, number(out() + 3));
    run(10);
    EXPECT_EQ(mark(0), 500);
    session_.clear_news();

    give(session_, StateOrder{.from = "the freeze", .checkpoint = frozen.data});
    EXPECT_EQ(session_.now_tick(), kCue);
    EXPECT_EQ(mark(0), std::nullopt);
    ASSERT_FALSE(session_.questions().empty());
    EXPECT_EQ(session_.questions().back().id, "out");
    EXPECT_EQ(session_.questions().back().run, session_.status().run);
    EXPECT_FALSE(session_.held()) << "paused as after every restore";
    give(session_, run_order(RunAction::start));
    EXPECT_TRUE(session_.held()) << "the start makes it wait for the answer, and does not pass it over";
    EXPECT_FALSE(session_.tick());
    give(session_, number(out() + 3));
    EXPECT_TRUE(session_.running());
    EXPECT_EQ(mark(0), 500);
}

TEST_F(SessionQuestions, AreTakenBackByAReset) {
    freeze();
    session_.clear_news();
    give(session_, run_order(RunAction::reset));
    ASSERT_EQ(session_.questions().size(), 1U);
    EXPECT_EQ(session_.questions()[0].id, "");
    EXPECT_FALSE(session_.held());
}

TEST_F(SessionQuestions, EndWithTheExerciseAsNotShown) {
    freeze();
    session_.clear_news();
    give(session_, run_order(RunAction::stop));
    EXPECT_EQ(mark(0), 0);
    ASSERT_EQ(session_.questions().size(), 1U);
    EXPECT_EQ(session_.questions()[0].id, "");
}

TEST_F(SessionQuestions, GoThroughOnceMoreFromTheOrdersComeToTheSameBits) {
    Session session(def(), options());
    const CheckpointView begin = *session.checkpoint();
    std::vector<OrderView> orders;
    const auto keep = [&] {
        orders.insert(orders.end(), session.orders().begin(), session.orders().end());
        session.clear_news();
    };
    keep();
    const auto on = [&](int ticks) {
        for (int i = 0; i < ticks; ++i)
            session.tick();
        keep();
    };
    on(30);
    give(session, test::levers(0.3));
    on(100);
    give(session, number(out() + 3), 0, "trainee"); // half of the mark
    on(200);
    give(session, run_order(RunAction::start)); // the second is passed over
    on(50);
    ASSERT_EQ(session.now_tick(), 2 * kCue + 50);

    assess::Assessor assessor;
    exercise::Exercise exercise = exercise::read_checkpoint(begin.data, {}, &assessor);
    Course course(std::move(exercise), std::move(assessor), begin.orders_taken);
    std::size_t next = 0;
    while (course.exercise().tick() < session.now_tick()) {
        for (; next < orders.size() && course.is_next(orders[next]); ++next)
            course.take(orders[next]);
        ASSERT_TRUE(course.step());
    }
    EXPECT_EQ(next, orders.size());
    EXPECT_EQ(course.state_hash(), session.snapshot().state_hash);
    const auto again = course.assessor().result(), live = session.assessor().result();
    EXPECT_EQ(again.assessment_hash, live.assessment_hash);
    EXPECT_EQ(live.criteria[0].milli, 500);
    EXPECT_EQ(live.criteria[1].milli, 0);
    EXPECT_EQ(again.criteria[0].reason, live.criteria[0].reason);
}

} // namespace
} // namespace windlass::run
