// The fold over made pictures: what points, musts and an assessor's word come to at the lesson's end.

#include "tests/lesson/course.hpp"

#include <gtest/gtest.h>

namespace windlass::assess {

// Half a mark meets a must: for the criterion, its objective and the lesson alike.
TEST(Assessment, MustIsMetFromHalfOnForEverybody) {
    for (const double beyond : {4.9, 5.1}) { // s, of 10 that take all
        Course course(
            R"({"id": "T", "pass": 0, "objectives": [{"id": "run", "text": "runs", "pass": 0}], "criteria": [
                {"id": "v", "kind": "limit", "of": "cable_speed", "max": 3, "must": true, "objective": "run"}]})");
        course.windlass().cable_speed = 4;
        course.run(beyond);
        course.windlass().cable_speed = 1;
        course.run(1);
        course.end();
        const Result result = course.now();
        const bool met = beyond < 5;
        EXPECT_EQ(result.criteria[0].met, met) << result.criteria[0].milli;
        EXPECT_EQ(result.criteria[0].state, met ? CriterionState::met : CriterionState::not_met);
        EXPECT_EQ(result.objectives[0].outcome, met ? Outcome::achieved : Outcome::not_yet);
        EXPECT_EQ(result.outcome, met ? Outcome::achieved : Outcome::not_yet);
    }
}

// Where to look is where it went wrong, not where the lesson ended.
TEST(Assessment, WhatWentWrongIsFoundWhereItFirstDid) {
    Course course(lesson(R"({"id": "v", "kind": "limit", "of": "cable_speed", "max": 3},
                            {"id": "s", "kind": "final", "that": {"stopper": "on"}},
                            {"id": "b", "kind": "final", "that": {"brake_position": {"above": 0.9}}},
                            {"id": "p", "kind": "prohibited", "that": {"clutch": "in"}})"));
    course.windlass().stopper_closed = true;
    course.windlass().brake_position = 0.5;
    course.windlass().clutch = exercise::ClutchState::out;
    course.run(10);
    course.windlass().cable_speed = 4;
    course.run(1);
    course.windlass().cable_speed = 5;
    course.run(1);
    course.windlass().cable_speed = 0;
    course.windlass().stopper_closed = false;
    course.run(30);
    course.end();
    EXPECT_EQ(course.mark(0).lost_tick, 101U);
    EXPECT_EQ(course.mark(0).tick, 420U) << "which is the end";
    EXPECT_EQ(course.mark(1).lost_tick, 121U) << "since when it is off";
    EXPECT_EQ(course.mark(1).reason,
              "0:42 wanted at the end: chain stopper closed; it was not, since 0:12: 10 of 10 points lost");
    EXPECT_EQ(course.mark(2).reason,
              "0:42 wanted at the end: brake hand-wheel (0 open, 1 hard on) above 0.9; it was 0.5, and never "
              "was so: 10 of 10 points lost");
    EXPECT_EQ(course.mark(2).lost_tick, 420U) << "what never was so is missed at the end";
    EXPECT_EQ(course.mark(3).lost_tick, 0U);
    EXPECT_EQ(course.mark(3).reason, "it never was so, and must not be: dog clutch in");
}

TEST(Assessment, ReasonOfALimitSaysForHowLongInAllAndWhatLeavesNothing) {
    Course course(lesson(R"({"id": "v", "kind": "limit", "of": "cable_speed", "max": 3, "fail_above": 6})"));
    const auto runs = [&](double speed, double seconds) {
        course.windlass().cable_speed = speed;
        course.run(seconds);
    };
    runs(0, 10);
    runs(4, 1);
    runs(0, 5);
    runs(7, 1);
    runs(0, 5);
    course.end();
    EXPECT_EQ(course.mark().reason, "0:16 cable's speed 7 m/s, at most 3 m/s; beyond it for 2 s in all, from "
                                    "0:10; nothing is left above 6 m/s: 10 of 10 points lost");
}

TEST(Assessment, ExerciseThatIsEndedEarlyHasNobodysWord) {
    Course course(
        lesson(R"({"id": "a", "kind": "final", "that": {}})", R"(, "end": {"good": {"moment": "bottom"}})"));
    course.run(1);
    course.say({.verdict = exercise::AssessorVerdict::ended,
                .note = "exercise ended: set duration",
                .by = "server"});
    EXPECT_TRUE(course.now().finished);
    EXPECT_EQ(course.now().ending, Ending::instructor);
    EXPECT_EQ(course.now().abort, "ended before its lesson was done");
    EXPECT_FALSE(course.state().confirmed);
    course.say({.verdict = exercise::AssessorVerdict::confirmed, .note = "as it stands", .by = "Ann"});
    EXPECT_TRUE(course.state().confirmed);
}

TEST(Assessment, PointsCannotBuyOffAMust) {
    Course course(
        lesson(R"({"id": "a", "kind": "final", "that": {"stopper": "on"}, "weight": 1, "must": true},
                            {"id": "b", "kind": "final", "that": {"brake_position": {"above": 0.9}}, "weight": 99})"));
    course.windlass().stopper_closed = false;
    course.windlass().brake_position = 0;
    course.run(1);
    course.windlass().brake_position = 1;
    course.run(1);
    course.end();
    EXPECT_EQ(course.now().tenths, 495) << "and halves what the rest has earned";
    EXPECT_EQ(course.now().outcome, Outcome::not_yet);
}

TEST(Assessment, WhatNeverCameIntoPlayIsNotShown) {
    Course course(lesson(
        R"({"id": "a", "kind": "limit", "of": "tension", "max": 1, "from": {"moment": "bottom"}, "must": true},
                            {"id": "b", "kind": "final", "that": {}})"));
    course.run(1);
    course.end();
    EXPECT_EQ(course.now().tenths, 500) << "half of what was: the must was not shown";
    EXPECT_EQ(course.now().outcome, Outcome::not_shown);
}

// What no figure says is the assessor's: until he speaks it neither earns nor costs.
TEST(Assessment, RubricCountsOnceTheAssessorHasSpoken) {
    Course course(lesson(R"({"id": "a", "kind": "final", "that": {"stopper": "on"}},
                            {"id": "stance", "kind": "rubric"})"));
    course.windlass().stopper_closed = false;
    course.run(1);
    course.windlass().stopper_closed = true;
    course.run(1);
    course.end();
    EXPECT_EQ(course.now().tenths, 1000);
    EXPECT_FALSE(course.mark(1).counts);
    course.say({.criterion = "stance",
                .verdict = exercise::AssessorVerdict::not_met,
                .note = "stood in the cable's line",
                .by = "Ann"});
    EXPECT_EQ(course.now().tenths, 500);
    EXPECT_EQ(course.now().tenths_computed, 1000);
    EXPECT_FALSE(course.mark(1).met);
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
