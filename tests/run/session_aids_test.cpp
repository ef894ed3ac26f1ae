// What a seat may ask for in an attempt for practice: who may, what is recorded of it, and that a hint is
// right and tells nothing that is to come.

#include "server/exercise/checkpoint.hpp"
#include "server/run/course.hpp"
#include "server/run/hint_search.hpp"

#include "tests/run/session_rig.hpp"

namespace windlass::run {
namespace {

using assess::AidKind;
using assess::AidWord;
using assess::LeverKind;
using test::count;
using test::give;
using test::levers;
using test::text_of;

/// The cable is to run no faster than 3 m/s: a must.
exercise::ExerciseDef def(const char* besides = R"("practice": true, "model_run": "scripts/none.json")") {
    exercise::ExerciseDef def;
    def.lesson =
        std::string(R"({"id": "T", )") + besides +
        R"(, "criteria": [{"id": "pace", "kind": "limit", "of": "cable_speed", "max": 3, "grace": 0.5,)"
        R"( "zero": 3, "must": true, "from": {"time": 0.1}}]})";
    return def;
}

AnswerOrder ask(AidKind kind, bool on = true, bool forecastle = true) {
    return {forecastle, assess::write_aid({.kind = kind, .forecastle = forecastle, .on = on})};
}

class SessionAids : public test::SessionTest {
protected:
    SessionOptions with_hands() const {
        SessionOptions options = this->options();
        options.model_hands = [](const Beginning&) { return nullptr; };
        return options;
    }
    static std::string refusal(Session& session, OrderContent order) {
        session.clear_news();
        give(session, std::move(order));
        return text_of(session, "command.refused");
    }
    static void run(Session& session, double seconds) {
        for (int k = 0; k < std::lround(seconds * session.def().tick_rate_hz); ++k)
            session.tick();
    }
    static AidWord search(const Session& session, bool forecastle = true) {
        HintSearch search(session.state(), forecastle);
        while (search.step()) {
        }
        return search.found();
    }
    static unsigned told(const Session& session) {
        unsigned value = 99;
        for (const auto& event : session.events())
            if (event.code == "practice.forecastle") value = static_cast<unsigned>(event.value);
        return value;
    }
};

TEST_F(SessionAids, AreForPracticeAlone) {
    Session test(def(R"("model_run": "scripts/none.json")"), with_hands());
    EXPECT_EQ(count(test, "practice.forecastle"), 0);
    EXPECT_NE(refusal(test, ask(AidKind::ghost)).find("no attempt for practice"), std::string::npos);
    EXPECT_NE(refusal(test, ask(AidKind::hint)).find("no attempt for practice"), std::string::npos);
    Session practice(def(), with_hands());
    EXPECT_EQ(told(practice), aid_ghost | aid_hints);
    EXPECT_EQ(refusal(practice, ask(AidKind::ghost)), "");
    EXPECT_EQ(told(practice), aid_ghost | aid_ghost_on | aid_hints);
}

TEST_F(SessionAids, GhostIsNotToBeHadWhereTheLessonSaysNoOrNobodyPlaysIt) {
    Session forbidden(def(R"("practice": true, "ghost": false, "model_run": "scripts/none.json")"),
                      with_hands());
    EXPECT_NE(refusal(forbidden, ask(AidKind::ghost)).find("not to be had"), std::string::npos);
    Session nobody(def(), options());
    EXPECT_NE(refusal(nobody, ask(AidKind::ghost)).find("not to be had"), std::string::npos);
    Session no_model(def(R"("practice": true)"), with_hands());
    EXPECT_NE(refusal(no_model, ask(AidKind::ghost)).find("not to be had"), std::string::npos);
}

TEST_F(SessionAids, ASeatAsksForItselfAndTellsNothing) {
    Session session(def(), with_hands());
    AnswerOrder of_the_other = ask(AidKind::ghost, true, false);
    of_the_other.of_forecastle = true;
    EXPECT_NE(refusal(session, of_the_other).find("practice/ghost/forecastle"), std::string::npos);
    EXPECT_NE(refusal(session, ask(AidKind::told)).find("practice/hint/forecastle"), std::string::npos);
    AnswerOrder garbled = ask(AidKind::hint);
    garbled.answer.question += "/more";
    EXPECT_NE(refusal(session, garbled).find("practice/hint/forecastle"), std::string::npos);
    EXPECT_FALSE(session.hint_wanted());
}

TEST_F(SessionAids, GhostIsInTheRecordOnceASeatAndAfterARestoreToo) {
    Session session(def(), with_hands());
    for (const bool on : {true, false, true})
        give(session, ask(AidKind::ghost, on));
    give(session, ask(AidKind::ghost, true, false));
    run(session, 0.5);
    const auto hints = session.assessor().result().hints;
    ASSERT_EQ(hints.size(), 2U);
    EXPECT_EQ(hints[0].id, "ghost");
    EXPECT_TRUE(hints[0].forecastle);
    EXPECT_FALSE(hints[1].forecastle);
    EXPECT_TRUE(session.shows_ghost(true));

    assess::Assessor assessor;
    exercise::Exercise exercise = exercise::read_checkpoint(session.state(), {}, &assessor);
    EXPECT_EQ(assessor.result().hints.size(), 2U);
    EXPECT_EQ(assessor.result().assessment_hash, session.assessor().result().assessment_hash);
}

TEST_F(SessionAids, GhostIsToBeHadInAnAttemptThatIsGoneOnWithUnlessAnInstructorIntervened) {
    Session session(def(), with_hands());
    run(session, 0.5);
    const StateOrder before{.from = "before", .checkpoint = session.state()};
    give(session, exercise::Order{exercise::FaultOrder{}});
    EXPECT_EQ(refusal(session, ask(AidKind::ghost)), "") << "here it is known what he did, and when";
    const StateOrder behind{.from = "behind", .checkpoint = session.state()};

    Session elsewhere(def(), with_hands());
    give(elsewhere, before);
    EXPECT_EQ(refusal(elsewhere, ask(AidKind::ghost)), "");
    give(elsewhere, behind);
    EXPECT_NE(refusal(elsewhere, ask(AidKind::ghost)).find("not to be had"), std::string::npos);

    for (const StateOrder& order : {before, behind}) {
        SessionOptions after_loss = with_hands();
        after_loss.resumption = Resumption{.checkpoint = order.checkpoint, .refused = {}, .set_back = {}};
        EXPECT_EQ((told(Session(def(), after_loss)) & aid_ghost) != 0, order.from == "before");
    }
}

TEST_F(SessionAids, HintKeepsWhatWouldBeLost) {
    Session session(def(), options());
    give(session, levers(0.75)); // it begins to render, and gains
    run(session, 0.2);
    give(session, levers(0));
    run(session, 0.2);
    const AidWord found = search(session);
    ASSERT_TRUE(found.lever);
    EXPECT_EQ(found.lever->kind, LeverKind::brake);
    EXPECT_EQ(found.criterion, 0);
    // Done as it was told, two seconds later, and not done.
    for (const bool done : {true, false}) {
        assess::Assessor assessor;
        exercise::Exercise exercise = exercise::read_checkpoint(session.state(), {}, &assessor);
        Course course(std::move(exercise), std::move(assessor), 0);
        for (int tick = 0; tick < 60 * 300; ++tick) {
            if (done && tick == 600)
                course.take({.run = 0, .tick = 0, .number = 0, .source = {}, .command = levers(found.value)});
            course.step();
        }
        const int milli = course.assessor().state().marks[0].milli;
        EXPECT_EQ(milli >= 500, done) << milli;
    }
}

TEST_F(SessionAids, HintSaysThatNothingIsLostWhereNothingIs) {
    Session session(def(), options());
    run(session, 0.5);
    const AidWord found = search(session);
    EXPECT_FALSE(found.lever);
    EXPECT_EQ(found.criterion, -1);
}

TEST_F(SessionAids, HintTellsNothingOfAFaultThatIsArmed) {
    exercise::ExerciseDef with_fault = def();
    with_fault.tackle[0].brake = 0;
    with_fault.tackle[0].clutch_in = true;
    with_fault.faults = {{.code = exercise::FaultCode::clutch_jumps_out,
                          .severity = 1,
                          .trigger = exercise::FaultTrigger::at_time,
                          .trigger_value = 5}};
    Session session(with_fault, options());
    run(session, 1);
    EXPECT_EQ(search(session).criterion, -1);
    run(session, 20); // it is there now, and what it does may be told
    EXPECT_LT(session.assessor().state().marks[0].milli, 500) << "the fault makes the cable run";
}

TEST_F(SessionAids, HintIsGivenToTheSeatThatAskedAndCounted) {
    Session session(def(), options());
    EXPECT_EQ(refusal(session, ask(AidKind::hint)), "");
    EXPECT_EQ(session.hint_wanted(), true);
    EXPECT_NE(refusal(session, ask(AidKind::hint)).find("one at a time"), std::string::npos);
    give(session, levers(0.2));
    session.clear_news();
    session.tell_hint({.kind = AidKind::told,
                       .forecastle = true,
                       .lever = assess::Lever{LeverKind::brake, exercise::Side::port},
                       .value = 1,
                       .criterion = 0});
    EXPECT_EQ(text_of(session, "hint.forecastle"), "The wheel hard on now.");
    EXPECT_FALSE(session.hint_wanted());
    const auto hints = session.assessor().result().hints;
    ASSERT_EQ(hints.size(), 1U);
    EXPECT_EQ(hints[0].criterion, "pace");
    EXPECT_EQ(hints[0].text, "The wheel hard on now.");
    ASSERT_EQ(session.orders().size(), 1U);
    EXPECT_EQ(session.orders()[0].source, kServerName);
}

// The search takes seconds: a hand that has done it meanwhile is not told to.
TEST_F(SessionAids, HintOfWhatIsDoneAlreadyIsNotToldAndAnotherIsLookedFor) {
    Session session(def(), options());
    EXPECT_EQ(refusal(session, ask(AidKind::hint)), "");
    const AidWord hard_on{.kind = AidKind::told,
                          .forecastle = true,
                          .lever = assess::Lever{LeverKind::brake, exercise::Side::port},
                          .value = 1,
                          .criterion = 0};
    give(session, levers(1));
    session.tell_hint(hard_on);
    EXPECT_TRUE(session.hint_wanted());
    give(session, levers(0.2));
    session.tell_hint(hard_on);
    EXPECT_FALSE(session.hint_wanted());
}

// It says what is being lost, and is none to be counted: it helps with nothing.
TEST_F(SessionAids, HintThatKnowsOfNoLeverSaysWhatIsBeingLostAndIsNotCounted) {
    Session session(def(), options());
    const auto told = [&](const AidWord& word) {
        EXPECT_EQ(refusal(session, ask(AidKind::hint)), "");
        session.clear_news();
        session.tell_hint(word);
        EXPECT_FALSE(session.hint_wanted());
        return text_of(session, "hint.forecastle");
    };
    EXPECT_EQ(told({.kind = AidKind::told, .forecastle = true, .criterion = 0}),
              "No single lever is known that would keep what is being lost: pace");
    EXPECT_EQ(told({.kind = AidKind::told, .forecastle = true}),
              "Nothing that a lever keeps is lost in the next minute if everything stays as it is.");
    EXPECT_EQ(told({.kind = AidKind::told, .forecastle = true, .found = false}),
              "There was no time to find out what is being lost: ask again.");
    EXPECT_TRUE(session.assessor().result().hints.empty());
}

// What is said no lever keeps: a report that is missed is nothing to be looked for.
TEST_F(SessionAids, HintLooksForNoReport) {
    exercise::ExerciseDef said = def();
    said.lesson = R"({"id": "T", "practice": true, "criteria": [{"id": "drags", "kind": "report",)"
                  R"( "report": "brake_does_not_hold", "truth": {"time": 1}, "full": 5, "half": 10}]})";
    Session session(said, options());
    run(session, 0.5);
    EXPECT_EQ(search(session).criterion, -1);
}

TEST_F(SessionAids, HintsInAnAttemptHaveAnEnd) {
    Session session(def(), options());
    int given = 0;
    std::string refused;
    while (given < 99 && (refused = refusal(session, ask(AidKind::hint))).empty()) {
        session.tell_hint({.kind = AidKind::told, .forecastle = true});
        ++given;
    }
    EXPECT_EQ(given, 12);
    EXPECT_NE(refused.find("12 hints"), std::string::npos) << refused;
}

} // namespace
} // namespace windlass::run
