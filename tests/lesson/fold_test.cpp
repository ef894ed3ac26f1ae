// The fold over made pictures: what each kind of criterion makes of a course that is known to the second.

#include "tests/lesson/course.hpp"

#include <gtest/gtest.h>

namespace windlass::assess {

// 2 s of 3.0 that are forgiven, nothing left at 12 s: 5 s beyond grace of 10 are half.
TEST(Assessment, LimitForgivesItsGraceAndThenTakesAwayEvenly) {
    Course course(
        lesson(R"({"id": "v", "kind": "limit", "of": "cable_speed", "max": 3, "grace": 2, "zero": 12})"));
    course.windlass().cable_speed = 2.9;
    course.run(60);
    EXPECT_EQ(course.mark().milli, 1000);
    course.windlass().cable_speed = 4;
    course.run(2);
    EXPECT_EQ(course.mark().milli, 1000);
    course.run(5);
    EXPECT_EQ(course.mark().milli, 500);
    EXPECT_DOUBLE_EQ(course.mark().worst, 4);
    EXPECT_DOUBLE_EQ(course.mark().time_outside, 7);
    course.windlass().cable_speed = 1;
    course.run(60);
    EXPECT_EQ(course.mark().milli, 500);
    course.windlass().cable_speed = 4;
    course.run(5);
    EXPECT_EQ(course.mark().milli, 0);
}

TEST(Assessment, NothingIsLeftOnceALimitIsPassedByTooMuch) {
    Course course(lesson(
        R"({"id": "v", "kind": "limit", "of": "cable_speed", "max": 3, "fail_above": 5, "zero": 60})"));
    course.windlass().cable_speed = 5.1;
    course.run(0.1);
    EXPECT_EQ(course.mark().milli, 0);
}

TEST(Assessment, LimitBeforeItsTimeDoesNotCount) {
    Course course(lesson(
        R"({"id": "v", "kind": "limit", "of": "cable_speed", "max": 3, "from": {"moment": "bottom", "since": 3}})"));
    course.windlass().cable_speed = 6;
    course.run(20);
    EXPECT_EQ(course.mark().state, CriterionState::not_in_play);
    course.event("anchor.on_bottom");
    course.run(2.5);
    EXPECT_EQ(course.mark().state, CriterionState::not_in_play);
    course.run(1);
    EXPECT_EQ(course.mark().state, CriterionState::open);
    EXPECT_LT(course.mark().milli, 1000);
}

// MARS 201410: stopper, brake, and then the clutch.
TEST(Assessment, StepsInAnotherOrderAreSteppedOverOnce) {
    const std::string steps = lesson(
        R"({"id": "s", "kind": "sequence", "steps": [{"stopper": "on"}, {"brake_position": {"above": 0.9}}, {"clutch": "out"}], "must": true})");
    for (const bool right : {true, false}) {
        Course course(steps);
        course.windlass().brake_position = 0;
        course.windlass().clutch = exercise::ClutchState::in;
        course.run(1);
        course.windlass().stopper_closed = true;
        course.run(1);
        if (!right) course.windlass().clutch = exercise::ClutchState::out;
        course.run(1);
        course.windlass().brake_position = 1;
        course.run(1);
        course.windlass().clutch = exercise::ClutchState::out;
        course.run(1);
        course.end();
        EXPECT_EQ(course.mark().state, right ? CriterionState::met : CriterionState::not_met);
        EXPECT_EQ(course.now().outcome, right ? Outcome::achieved : Outcome::not_yet);
    }
}

TEST(Assessment, StateAtAMomentIsLookedAtThenAndNotLater) {
    Course course(lesson(
        R"({"id": "b", "kind": "state_at", "at": "bottom", "after": 5, "that": {"brake_position": {"above": 0.9}}})"));
    course.windlass().brake_position = 0;
    course.event("anchor.on_bottom");
    course.run(5.5);
    course.windlass().brake_position = 1;
    course.run(10);
    EXPECT_EQ(course.mark().state, CriterionState::not_met);
    EXPECT_NE(course.mark().reason.find("hand-wheel"), std::string::npos) << course.mark().reason;
}

TEST(Assessment, AnchorBallThatWasNotShownOnceSheIsBroughtUpIsMissed) {
    for (const bool hoisted : {true, false}) {
        Course course(lesson(
            R"({"id": "ball", "kind": "state_at", "at": "bottom", "after": 60, "that": {"anchor_ball": true, "anchor_lights": false}})"));
        course.event("anchor.on_bottom");
        course.run(30);
        course.seen().lights_and_shapes.anchor_ball = hoisted;
        course.run(31);
        EXPECT_EQ(course.mark().state, hoisted ? CriterionState::met : CriterionState::not_met);
        if (!hoisted) {
            EXPECT_NE(course.mark().reason.find("anchor ball"), std::string::npos) << course.mark().reason;
        }
    }
}

TEST(Assessment, StateThatTheEndCutsOffIsNotInPlay) {
    Course course(lesson(
        R"({"id": "b", "kind": "state_at", "at": "bottom", "after": 5, "that": {"brake_position": {"above": 0.9}}})"));
    course.event("anchor.on_bottom");
    course.run(2);
    course.end();
    EXPECT_EQ(course.mark().state, CriterionState::not_in_play);
}

// The table of docs/lessons.md: 15 s after it was so the whole mark, 30 s half, before it nothing.
TEST(Assessment, ReportOfWhatHappenedIsTimedAgainstIt) {
    const struct {
        double after;
        int milli;
    } cases[] = {{1, 1000}, {14.8, 1000}, {15.3, 500}, {29.8, 500}, {30.3, 0}};
    for (const auto& one : cases) {
        Course course(lesson(R"({"id": "r", "kind": "report", "report": "on_the_bottom"})"));
        course.run(10);
        course.event("anchor.on_bottom");
        course.run(one.after);
        course.report(exercise::ReportCode::on_the_bottom);
        course.run(60);
        EXPECT_EQ(course.mark().milli, one.milli) << one.after;
    }
}

TEST(Assessment, WrongReportThatIsTakenBackCostsHalf) {
    Course course(lesson(R"({"id": "r", "kind": "report", "report": "on_the_bottom"})"));
    course.report(exercise::ReportCode::on_the_bottom);
    course.run(10);
    course.event("anchor.on_bottom");
    course.run(5);
    course.report(exercise::ReportCode::on_the_bottom);
    course.run(5);
    EXPECT_EQ(course.mark().milli, 500);
}

TEST(Assessment, ReportOfWhatNeverHappenedIsAFalseCall) {
    Course course(lesson(R"({"id": "r", "kind": "report", "report": "dragging"})"));
    course.report(exercise::ReportCode::dragging);
    course.run(5);
    course.end();
    EXPECT_EQ(course.mark().state, CriterionState::not_met);
}

// Mark at the water's surface: cable_out less the hawse pipe's height. Half a shackle either way is right.
TEST(Assessment, ShacklesReportedAreComparedWithThoseThatAreOut) {
    const struct {
        double said;
        int milli;
    } cases[] = {{4, 1000}, {4.49, 1000}, {3.51, 1000}, {4.51, 500}, {4.99, 500}, {5.01, 0}, {2.99, 0}};
    for (const auto& one : cases) {
        Course course(lesson(R"({"id": "r", "kind": "report", "report": "shackles_in_water"})"));
        course.chain().cable_out = 4 * 27.5 + 6;
        course.seen().tackle[0].hawse.z() = 6;
        course.report(exercise::ReportCode::shackles_in_water, one.said);
        course.run(1);
        EXPECT_EQ(course.mark().milli, one.milli) << one.said;
    }
}

TEST(Assessment, AnOrderThatNobodyWouldHearWaitsForTheVhf) {
    Course course(
        R"({"id": "T", "orders": [{"id": "a", "code": "pay_out", "value": 2, "when": {"time": 1}}],
            "criteria": [{"id": "p", "kind": "prohibited", "that": {"clutch": "in"}}]})");
    course.seen().environment.now.visibility = 5000;
    course.seen().faults.push_back({.order = {.code = exercise::FaultCode::vhf_lost},
                                    .phase = exercise::FaultPhase::active,
                                    .severity_now = 1});
    course.run(5);
    EXPECT_TRUE(course.due.empty());
    course.seen().faults.clear();
    course.run(0.1);
    EXPECT_EQ(course.due.size(), 1U);
}

TEST(Assessment, ProhibitedActIsProhibitedOnce) {
    Course course(lesson(
        R"({"id": "p", "kind": "prohibited", "that": {"stopper": "off", "brake_position": {"below": 0.5}, "for": 2}})"));
    course.windlass().stopper_closed = false;
    course.windlass().brake_position = 0;
    course.run(1.5);
    course.windlass().brake_position = 1;
    course.run(1);
    EXPECT_EQ(course.mark().milli, 1000);
    course.windlass().brake_position = 0;
    course.run(3);
    course.windlass().brake_position = 1;
    course.run(3);
    EXPECT_EQ(course.mark().milli, 0);
}

TEST(Assessment, LessonGivesItsOrdersInTheirSequence) {
    Course course(lesson(
        R"({"id": "o", "kind": "order", "orders": ["in", "out"]})",
        R"(, "orders": [{"id": "in", "code": "gear_in", "when": {"time": 5}}, {"id": "out", "code": "gear_out"}])"));
    course.run(4.8);
    EXPECT_TRUE(course.due.empty());
    course.run(0.3);
    ASSERT_EQ(course.due.size(), 1u);
    const auto given = std::get<exercise::BridgeOrderGiven>(course.due[0]);
    EXPECT_EQ(given.code, exercise::BridgeOrderCode::gear_in);
    course.seen().bridge_orders.push_back(
        {.number = 1, .time = 5, .repeat_by = 15, .do_by = 25, .given = given});
    course.run(5);
    EXPECT_EQ(course.due.size(), 1u); // it is not carried out yet
    course.seen().bridge_orders[0].state = exercise::BridgeOrderState::repeated;
    course.windlass().clutch = exercise::ClutchState::in;
    course.run(3);
    ASSERT_EQ(course.due.size(), 2u);
    EXPECT_EQ(std::get<exercise::BridgeOrderGiven>(course.due[1]).code, exercise::BridgeOrderCode::gear_out);
    EXPECT_EQ(course.mark().milli, 1000);
}

TEST(Assessment, OrderRepeatedWronglyAndDoneLateKeepsHalf) {
    Course course(lesson(R"({"id": "o", "kind": "order", "orders": "in"})",
                         R"(, "orders": [{"id": "in", "code": "gear_in"}])"));
    course.windlass().clutch = exercise::ClutchState::out;
    course.run(1);
    ASSERT_EQ(course.due.size(), 1u);
    course.seen().bridge_orders.push_back({.number = 1,
                                           .time = 1,
                                           .repeat_by = 11,
                                           .do_by = 21,
                                           .given = std::get<exercise::BridgeOrderGiven>(course.due[0]),
                                           .state = exercise::BridgeOrderState::misrepeated});
    course.run(2);
    course.seen().bridge_orders[0].state = exercise::BridgeOrderState::repeated;
    course.run(30);
    course.windlass().clutch = exercise::ClutchState::in;
    course.run(5);
    course.end();
    EXPECT_EQ(course.mark().milli, 500); // 200 of 400 for the repeat, 300 of 600 for the deed
}

TEST(Assessment, PointsCannotBuyOffAMust) {
    Course course(
        lesson(R"({"id": "a", "kind": "final", "that": {"stopper": "on"}, "weight": 1, "must": true},
                            {"id": "b", "kind": "final", "that": {"brake_position": {"above": 0.9}}, "weight": 99})"));
    course.windlass().stopper_closed = false;
    course.windlass().brake_position = 1;
    course.run(1);
    course.end();
    EXPECT_EQ(course.now().tenths, 990);
    EXPECT_EQ(course.now().outcome, Outcome::not_yet);
}

TEST(Assessment, WhatNeverCameIntoPlayIsNotShown) {
    Course course(lesson(
        R"({"id": "a", "kind": "limit", "of": "tension", "max": 1, "from": {"moment": "bottom"}, "must": true},
                            {"id": "b", "kind": "final", "that": {}})"));
    course.run(1);
    course.end();
    EXPECT_EQ(course.now().tenths, 1000);
    EXPECT_EQ(course.now().outcome, Outcome::not_shown);
}

TEST(Assessment, AssessorsWordStandsBesideTheComputedMark) {
    Course course(lesson(R"({"id": "a", "kind": "final", "that": {"stopper": "on"}})"));
    course.windlass().stopper_closed = false;
    course.run(1);
    course.end();
    const std::uint64_t before = course.now().assessment_hash;
    course.say({.criterion = "a",
                .verdict = exercise::AssessorVerdict::met,
                .note = "stopper was reported jammed",
                .by = "Ann"});
    EXPECT_EQ(course.now().tenths_computed, 0);
    EXPECT_EQ(course.now().tenths, 1000);
    EXPECT_EQ(course.mark().state, CriterionState::overridden);
    EXPECT_NE(course.mark().reason.find("Ann: stopper was reported jammed"), std::string::npos);
    EXPECT_NE(course.now().assessment_hash, before);
}

TEST(Assessment, NothingChangesOnceTheLessonIsOver) {
    Course course(lesson(R"({"id": "a", "kind": "limit", "of": "cable_speed", "max": 3})",
                         R"(, "end": {"good": {"moment": "bottom"}, "time": 100})"));
    course.event("anchor.on_bottom");
    course.run(1);
    const std::uint64_t hash = course.now().assessment_hash;
    course.windlass().cable_speed = 9;
    course.run(10);
    EXPECT_EQ(course.now().assessment_hash, hash);
    EXPECT_EQ(course.now().tenths, 1000);
}

TEST(Assessment, LossOfTheCableEndsItAsNotYet) {
    Course course(
        lesson(R"({"id": "a", "kind": "final", "that": {}})", R"(, "end": {"abort": ["cable.lost"]})"));
    course.event("cable.lost");
    course.run(0.1);
    EXPECT_TRUE(course.now().finished);
    EXPECT_EQ(course.now().outcome, Outcome::not_yet);
    EXPECT_EQ(course.now().abort, "cable.lost");
}

} // namespace windlass::assess
