// Questions at a freeze: asked at the cue, judged by what was so then.

#include "tests/lesson/course.hpp"

#include <gmock/gmock.h>

namespace windlass::assess {
namespace {

using exercise::AnswerGiven;
using exercise::AnswerKind;
using testing::HasSubstr;

constexpr const char* kHowMuch =
    R"({"id": "out", "kind": "question", "ask": "How much cable is out?", "of": "shackles", "tolerance": 0.5,)"
    R"( "when": {"cable_out": 55}})";
constexpr const char* kHowLeads =
    R"({"id": "stay", "kind": "question", "ask": "How does she stay?", "seat": "bridge", "when": {"cable_out": 55},)"
    R"( "choices": [{"answer": "long", "that": {"top_angle_deg": {"below": 30}}},)"
    R"( {"answer": "short", "that": {"top_angle_deg": {"above": 28}}},)"
    R"( {"answer": "up and down", "that": {"top_angle_deg": {"above": 75}}}]})";

AnswerGiven number(double value, const char* question = "out") {
    return {.question = question, .kind = AnswerKind::number, .value = value};
}
AnswerGiven choice(int place) {
    return {.question = "stay", .kind = AnswerKind::choice, .choice = place};
}

/// 4 shackles are out, and the question of them is open.
Course asked(const char* question = kHowMuch) {
    Course course(lesson(question));
    course.run(1);
    course.chain().cable_out = 4 * 27.5;
    course.run(0.1);
    return course;
}

struct Answered {
    double value;
    int milli;
    CriterionState state;
};

TEST(Question, ANumberEarnsAllWithinItsToleranceAndHalfWithinTwiceThat) {
    for (const auto& [value, milli, state] :
         {Answered{4, 1000, CriterionState::met}, Answered{4.5, 1000, CriterionState::met},
          Answered{3.5, 1000, CriterionState::met}, Answered{4.75, 500, CriterionState::met},
          Answered{3, 500, CriterionState::met}, Answered{5.1, 0, CriterionState::not_met}}) {
        Course course = asked();
        EXPECT_EQ(course.mark().state, CriterionState::open);
        course.say(number(value));
        EXPECT_EQ(course.mark().milli, milli) << value;
        EXPECT_EQ(course.mark().state, state) << value;
    }
}

TEST(Question, IsAskedOnceAtTheFirstTickAtWhichItsCueHoldsAndOfOneSeat) {
    Course course(lesson(std::string(kHowMuch) + "," + kHowLeads));
    course.run(1);
    EXPECT_EQ(course.open_question(true), -1);
    EXPECT_EQ(course.mark().state, CriterionState::not_in_play);
    course.chain().cable_out = 55;
    course.run(0.1);
    EXPECT_EQ(course.state().questions[0].asked, course.state().tick);
    EXPECT_EQ(course.open_question(true), 0);
    EXPECT_EQ(course.open_question(false), 1);
    course.say(number(2));
    EXPECT_EQ(course.open_question(true), -1);
    EXPECT_EQ(course.open_question(false), 1) << "each has its own";
    course.run(5);
    EXPECT_EQ(course.open_question(true), -1) << "once";
}

TEST(Question, IsJudgedByWhatWasSoAtTheFreezeAndNotByWhatCameOfIt) {
    Course course = asked();
    course.chain().cable_out = 8 * 27.5;
    course.say(number(4));
    EXPECT_EQ(course.mark().milli, 1000);
    EXPECT_THAT(course.mark().reason, HasSubstr("asked at a freeze: 4"));
}

TEST(Question, AChoiceIsRightWhereItsConditionHeldAtTheFreeze) {
    for (const auto& [angle, place, milli] :
         {std::tuple(29, 0, 1000), std::tuple(29, 1, 1000), std::tuple(29, 2, 0), std::tuple(80, 2, 1000),
          std::tuple(80, 0, 0)}) {
        Course course(lesson(kHowLeads));
        course.chain().top_angle = physics::radians_from_degrees(angle);
        course.chain().cable_out = 60;
        course.run(0.1);
        course.say(choice(place));
        EXPECT_EQ(course.mark().milli, milli) << angle << " deg, " << place;
    }
}

TEST(Question, WhatIsNotKnownEarnsNothingWhatIsPassedOverCountsForNobodyAndBothSayWhatWasSo) {
    Course unknowing = asked();
    unknowing.say({.question = "out", .kind = AnswerKind::not_known});
    EXPECT_EQ(unknowing.mark().milli, 0);
    EXPECT_THAT(unknowing.mark().reason, HasSubstr("he could not tell; right: 4 shackles"));
    Course passed = asked();
    passed.say({.question = "out", .kind = AnswerKind::passed_over});
    EXPECT_EQ(passed.mark().state, CriterionState::not_in_play);
    EXPECT_THAT(passed.mark().reason, HasSubstr("not answered; right: 4 shackles"));
    Course ended = asked();
    ended.end();
    EXPECT_EQ(ended.mark().state, CriterionState::not_met);
    EXPECT_EQ(ended.open_question(true), -1);
    Course never(lesson(kHowMuch));
    never.run(5);
    never.end();
    EXPECT_EQ(never.mark().state, CriterionState::not_in_play) << "it never came up";
}

// Who says that it is ready is asked once it is so, and has nothing of the question where it never is.
TEST(Question, ThatIsAskedOnceItIsSoIsLostWhereItNeverIs) {
    const std::string ready =
        R"({"id": "out", "kind": "question", "ask": "How much cable is out?", "of": "shackles", "tolerance": 0.5,)"
        R"( "from": {"report": "anchor_ready"}, "when": {"report": "anchor_ready", "cable_out": 55}})";
    const std::string end = R"(, "end": {"time": 20})";
    Course falsely(lesson(ready, end));
    falsely.run(1);
    EXPECT_EQ(falsely.mark().state, CriterionState::not_in_play);
    falsely.report(exercise::ReportCode::anchor_ready);
    falsely.run(5);
    EXPECT_EQ(falsely.open_question(true), -1) << "the exercise does not hold for it";
    EXPECT_EQ(falsely.mark().state, CriterionState::open);
    EXPECT_THAT(falsely.mark().reason, HasSubstr("not asked yet"));
    falsely.run(20);
    EXPECT_EQ(falsely.mark().state, CriterionState::not_met);
    EXPECT_THAT(falsely.mark().reason, HasSubstr("0:01 never asked, since it was not so: cable out from the "
                                                 "lip at least 55 m: all of its points"));

    Course late(lesson(ready, end));
    late.report(exercise::ReportCode::anchor_ready);
    late.run(5);
    late.chain().cable_out = 4 * 27.5;
    late.run(0.1);
    EXPECT_EQ(late.open_question(true), 0);
    late.say(number(4));
    EXPECT_EQ(late.mark().milli, 1000);

    Course ended(lesson(ready, end));
    ended.report(exercise::ReportCode::anchor_ready);
    ended.run(5);
    ended.end();
    EXPECT_EQ(ended.mark().state, CriterionState::not_in_play) << "it could still have come";
}

TEST(Question, OfALessonThatIsOverAtThatVeryTickIsNobodysLoss) {
    Course course(lesson(kHowMuch, R"(, "end": {"good": {"cable_out": 55}})"));
    course.chain().cable_out = 60;
    course.run(0.1);
    EXPECT_EQ(course.open_question(true), -1);
    EXPECT_EQ(course.mark().state, CriterionState::not_in_play);
}

TEST(Question, AnAnswerToWhatIsNotAskedOrIsAnsweredChangesNothing) {
    Course course = asked();
    course.say(number(4, "in"));
    EXPECT_EQ(course.open_question(true), 0);
    course.say(number(4));
    course.say(number(9));
    EXPECT_EQ(course.mark().milli, 1000);
}

TEST(Question, AnAnswerThatItDoesNotAllowAsADamagedRecordingMayHaveItChangesNothing) {
    Course course(lesson(kHowLeads));
    course.chain().cable_out = 60;
    course.run(0.1);
    for (const AnswerGiven& wrong : {choice(3), choice(-1), choice(1 << 30), number(0, "stay")}) {
        course.say(wrong);
        EXPECT_EQ(course.open_question(false), 0);
    }
    course.say(choice(0));
    EXPECT_EQ(course.mark().milli, 1000);
}

TEST(Question, OfAClockOrACompassGoesRound) {
    Course course(
        lesson(R"({"id": "out", "kind": "question", "ask": "How does she lead?", "of": "lead_clock",)"
               R"( "tolerance": 1, "when": {"cable_out": 55}})"));
    course.chain().lead_clock = 11.5;
    course.chain().cable_out = 60;
    course.run(0.1);
    course.say(number(12));
    EXPECT_EQ(course.mark().milli, 1000);
    Course other(
        lesson(R"({"id": "out", "kind": "question", "ask": "How heavy?", "of": "tension", "unit": "kN",)"
               R"( "tolerance": 20, "when": {"cable_out": 55}})"));
    other.windlass().hawse_tension = 150e3;
    other.chain().cable_out = 60;
    other.run(0.1);
    other.say(number(165));
    EXPECT_EQ(other.mark().milli, 1000);
}

std::string fault_of(const std::string& criterion) {
    try {
        read_lesson(lesson(criterion), {0, 1});
    } catch (const std::exception& error) {
        return error.what();
    }
    return "none";
}

TEST(Question, ThatCannotBeAskedIsRefusedWithPlaceAndRemedy) {
    EXPECT_THAT(
        fault_of(R"({"id": "q", "kind": "question", "ask": "?", "of": "shackles", "when": {"time": 1}})"),
        HasSubstr("/lesson/criteria/0/tolerance: is missing"));
    EXPECT_THAT(fault_of(R"({"id": "q", "kind": "question", "ask": "?", "of": "shackles", "tolerance": 1})"),
                HasSubstr("/lesson/criteria/0/when: is missing"));
    EXPECT_THAT(fault_of(R"({"id": "q", "kind": "question", "ask": "?", "when": {"time": 1}})"),
                HasSubstr("give the one or the other"));
    EXPECT_THAT(fault_of(R"({"id": "q", "kind": "question", "ask": "?", "of": "shackle", "tolerance": 1,)"
                         R"( "when": {"time": 1}})"),
                HasSubstr("the nearest is \"shackles\""));
    EXPECT_THAT(fault_of(R"({"id": "q", "kind": "question", "ask": "?", "of": "surge", "unit": "kN",)"
                         R"( "tolerance": 1, "when": {"time": 1}})"),
                HasSubstr("/unit: \"kN\": surge is in m/s"));
    EXPECT_THAT(
        fault_of(R"({"id": "q", "kind": "question", "ask": "?", "when": {"time": 1},)"
                 R"( "choices": [{"answer": "a", "that": {}}, {"answer": "b", "that": {"time": 1}}]})"),
        HasSubstr("this answer would always be right"));
}

} // namespace
} // namespace windlass::assess
