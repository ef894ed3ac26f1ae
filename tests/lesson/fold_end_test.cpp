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

// One word that was left out fails no lesson that was safe; what was not shown is not called achieved for it.
TEST(Assessment, ObjectiveIsAchievedFromTheLessonsPassOnAndBelowHalfFailsTheLesson) {
    const auto worked = [](bool stopper, bool brake, const char* pass = "") {
        Course course(lesson(
            R"({"id": "a", "kind": "final", "that": {"stopper": "on"}, "weight": 60, "objective": "run"},
               {"id": "b", "kind": "final", "that": {"brake_position": {"above": 0.9}}, "weight": 40,
                "objective": "run"},
               {"id": "c", "kind": "final", "that": {"clutch": "out"}, "weight": 100})",
            std::string(R"(, "objectives": [{"id": "run", "text": "runs")") + pass + "}]"));
        course.windlass().stopper_closed = false;
        course.windlass().brake_position = 0;
        course.windlass().clutch = exercise::ClutchState::in;
        course.run(1);
        course.windlass().stopper_closed = stopper;
        course.windlass().brake_position = brake ? 1 : 0;
        course.windlass().clutch = exercise::ClutchState::out;
        course.run(1);
        course.end();
        return course.now();
    };
    const Result short_of = worked(true, false);
    EXPECT_EQ(short_of.objectives[0].pass, 70) << "the lesson's";
    EXPECT_EQ(short_of.objectives[0].tenths, 600);
    EXPECT_EQ(short_of.objectives[0].outcome, Outcome::not_yet);
    EXPECT_EQ(short_of.outcome, Outcome::achieved);
    EXPECT_EQ(short_of.tenths, 800) << "and is not halved";
    EXPECT_EQ(worked(true, false, R"(, "pass": 60)").objectives[0].outcome, Outcome::achieved);
    const Result missed = worked(false, true);
    EXPECT_EQ(missed.objectives[0].outcome, Outcome::not_yet);
    EXPECT_EQ(missed.outcome, Outcome::not_yet) << "with 70 points";
    EXPECT_EQ(missed.tenths, 350);
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
    EXPECT_EQ(course.mark(1).reason, "0:42 at the end not so since 0:12: stopper open; wanted: stopper "
                                     "closed: all of its points lost");
    EXPECT_EQ(course.mark(2).reason,
              "0:42 at the end brake was 50 % on; wanted: brake hard on: all of its points lost");
    EXPECT_EQ(course.mark(2).lost_tick, 420U) << "what never was so is missed at the end";
    EXPECT_EQ(course.mark(3).lost_tick, 0U);
    EXPECT_EQ(course.mark(3).reason, "it never was so, and must not be: clutch in");
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
                                    "0:10; cable's speed above 6 m/s leaves nothing: all of its points lost")
        << "with whose speed it is: pages show it in another unit";
}

TEST(Assessment, ReasonOfALimitNamesTheTimeThatIsAllowed) {
    Course course(lesson(
        R"({"id": "v", "kind": "limit", "of": "motor_load", "max": 289000, "grace": 100, "zero": 200})"));
    course.run(10);
    course.windlass().motor_load = 500e3;
    course.run(37.4);
    course.windlass().motor_load = 0;
    course.run(5);
    course.end();
    EXPECT_EQ(course.mark().milli, 1000);
    EXPECT_EQ(course.mark().reason, "0:10 through the clutch 500 kN, at most 289 kN; beyond it for 37.4 s in "
                                    "all, from 0:10, 100 s are allowed");
}

// What is wanted of a ship under way is not asked of one that never weighed.
TEST(Assessment, WhatIsWantedAtTheEndFromAMomentOnIsNotShownWhereThatNeverCame) {
    const auto ended = [](bool comes) {
        Course course(lesson(
            R"({"id": "s", "kind": "final", "that": {"stopper": "on"}, "from": {"moment": "bottom"}})"));
        course.run(10);
        if (comes) course.event("anchor.on_bottom");
        course.run(10);
        course.end();
        return course.mark();
    };
    EXPECT_EQ(ended(false).state, CriterionState::not_in_play);
    EXPECT_FALSE(ended(false).counts);
    EXPECT_EQ(ended(true).state, CriterionState::not_met);
    EXPECT_EQ(ended(true).reason,
              "0:20 at the end stopper open; wanted: stopper closed: all of its points lost");
}

// A heap that is left lying is no less for a lesson that was over sooner.
TEST(Assessment, WhatIsToBePutRightAndLiesAtTheEndLeavesNothing) {
    enum class Over { good, time, accident, by_hand };
    const auto left = [](double beyond, double within_again, Over over, bool put_right = true) {
        Course course(lesson(std::string(
                                 R"({"id": "v", "kind": "limit", "of": "cable_out", "max": 30, "grace": 20,
            "zero": 60)") + (put_right ? R"(, "put_right": true})" : "}"),
                             R"(, "end": {"good": {"event": "anchor.brought_up"}, "time": 100,
            "abort": ["cable.lost"]})"));
        course.chain().cable_out = 40;
        course.run(beyond);
        if (within_again > 0) course.chain().cable_out = 20;
        course.run(within_again);
        if (over == Over::good) course.event("anchor.brought_up");
        if (over == Over::accident) course.event("cable.lost");
        if (over == Over::by_hand) course.end();
        course.run(over == Over::time ? 100 : 1);
        EXPECT_NE(course.state().ending, Ending::none);
        return course.mark();
    };
    EXPECT_EQ(left(40, 5, Over::good).milli, 500) << "and gone again";
    EXPECT_EQ(left(30, 0, Over::good).milli, 0) << "which is sooner, and lies";
    EXPECT_NE(left(30, 0, Over::good).reason.find("still so at the end leaves nothing"), std::string::npos);
    EXPECT_EQ(left(30, 0, Over::good, false).milli, 747) << "of a limit that does not say so";
    EXPECT_EQ(left(10, 0, Over::good).milli, 1000) << "for no longer than is forgiven";
    EXPECT_EQ(left(10, 0, Over::accident).milli, 0) << "that ended it: nobody is forgiven for that";
    EXPECT_EQ(left(10, 5, Over::accident).milli, 1000);
    EXPECT_EQ(left(40, 5, Over::time).milli, 500);
    EXPECT_EQ(left(30, 0, Over::by_hand).milli, 750) << "as far as it went";
}

// What may still come is not lost; the limit that was broken is, whatever comes.
TEST(Assessment, ReasonOfWhatIsOpenSaysLostOnlyOfWhatIsLostForGood) {
    Course course(lesson(
        R"({"id": "s", "kind": "final", "that": {"stopper": "on"}},
           {"id": "v", "kind": "limit", "of": "cable_speed", "max": 3},
           {"id": "r", "kind": "report", "report": "foul_anchor"})"));
    course.windlass().stopper_closed = false;
    course.windlass().cable_speed = 4;
    course.run(5);
    EXPECT_EQ(course.mark(0).state, CriterionState::open);
    EXPECT_EQ(course.mark(0).reason, "");
    EXPECT_EQ(course.mark(1).state, CriterionState::open);
    EXPECT_NE(course.mark(1).reason.find(" % of its points lost"), std::string::npos)
        << course.mark(1).reason;
    EXPECT_EQ(course.mark(2).reason.find("lost"), std::string::npos) << course.mark(2).reason;
    course.end();
    EXPECT_NE(course.mark(0).reason.find(": all of its points lost"), std::string::npos)
        << course.mark(0).reason;
}

// What was wrong stands before what was wanted: of many wants the last are cut.
TEST(Assessment, ReasonOfAStateSaysFirstWhatWasNotSo) {
    Course course(lesson(
        R"({"id": "s", "kind": "state_at", "at": "bottom", "that": {"cable_speed": {"above": -0.05, "below": 0.05},
        "brake_position": {"above": 0.95}, "engine": {"above": -0.03, "below": 0.03},
        "piled": {"below": 2}, "height_above_bottom": {"below": 1}, "dragged": {"below": 5},
        "stopper": "on", "clutch": "out"}})"));
    course.windlass().brake_position = 1;
    course.windlass().clutch = exercise::ClutchState::out;
    course.run(1);
    course.event("anchor.on_bottom");
    course.run(1);
    const std::string reason = course.mark().reason;
    EXPECT_EQ(reason.find("0:01 stopper open; wanted: "), 0U) << reason;
    EXPECT_NE(reason.find(" ...: all of its points lost"), reason.npos) << reason;
}

// The lesson is over before anybody has looked: no figure is told that nobody has read.
TEST(Assessment, StateThatTheEndCutsOffLateHasNoFigure) {
    Course course(lesson(
        R"({"id": "s", "kind": "state_at", "at": "bottom", "after": 2, "zero": 60, "that": {"shackles": {"above": 5}}})"));
    course.event("anchor.on_bottom");
    course.chain().cable_out = 3 * 27.5;
    course.run(10);
    course.end();
    EXPECT_EQ(course.mark().reason.find("0 shackles"), std::string::npos) << course.mark().reason;
    EXPECT_NE(course.mark().reason.find("; wanted: cable out from the lip above 5 shackles"),
              std::string::npos)
        << course.mark().reason;
}

// A mate reads it: no name of a figure, no share of a scale.
TEST(Assessment, ConditionsAreSaidAsOnDeck) {
    const auto wanted = [](const std::string& that) {
        Course course(lesson(R"({"id": "s", "kind": "final", "that": {)" + that + "}}"));
        course.windlass().brake_position = 0.5;
        course.chain().cable_out = -0.04;
        course.run(1);
        course.end();
        const std::string reason = course.mark().reason;
        return reason.substr(0, reason.find(": all of its"));
    };
    EXPECT_EQ(wanted(R"("brake_position": {"below": 0.2})"),
              "0:01 at the end brake was 50 % on; wanted: brake open");
    EXPECT_EQ(wanted(R"("brake_position": {"above": 0.95}, "speed_lever": {"above": -0.05, "below": 0.05})"),
              "0:01 at the end brake was 50 % on; wanted: brake hard on, speed lever at zero");
    EXPECT_EQ(wanted(R"("speed_lever": {"above": 0.3})"),
              "0:01 at the end speed lever was at zero; wanted: speed lever above 30 % heave");
    EXPECT_EQ(wanted(R"("tripped": true)"),
              "0:01 at the end the motor has not tripped; wanted: the motor has tripped");
    EXPECT_EQ(wanted(R"("shackles": {"above": 5.75, "below": 6.25})"),
              "0:01 at the end cable out from the lip was 0 shackles; wanted: cable out from the lip between "
              "5.75 and 6.25 shackles");
}

TEST(Assessment, OneStepIsNoCourseOfSteps) {
    const std::string one = lesson(
        R"({"id": "s", "kind": "sequence", "from": {"moment": "bottom"}, "steps": [{"stopper": "on"}]})");
    Course course(one);
    course.windlass().stopper_closed = true;
    course.event("anchor.on_bottom");
    course.run(1);
    EXPECT_EQ(course.mark().reason, "0:00 it was so: stopper closed");
    Course late(one);
    late.event("anchor.on_bottom");
    late.run(10);
    late.end();
    EXPECT_EQ(late.mark().reason,
              "0:10 it was not so in 9.9 s; wanted: stopper closed: all of its points lost");
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

// L27 once gave 25 points to a crew that repeated two orders and did nothing: it never came to the rest.
TEST(Assessment, MustThatALessonNeverCameToEarnsNothingOfTheWhole) {
    const std::string text = lesson(
        R"({"id": "a", "kind": "final", "that": {"stopper": "on"}, "weight": 10},
           {"id": "b", "kind": "state_at", "at": "bottom", "that": {"brake_position": {"above": 0.9}},
            "weight": 90, "must": true})",
        R"(, "end": {"time": 10})");
    const auto work = [](Course& course) {
        course.windlass().stopper_closed = false;
        course.windlass().brake_position = 0;
        course.run(1);
        course.windlass().stopper_closed = true;
        course.run(1);
    };
    Course course(text);
    work(course);
    course.run(10);
    EXPECT_EQ(course.now().tenths, 50) << "half of ten in a hundred";
    EXPECT_EQ(course.now().outcome, Outcome::not_shown);
    EXPECT_EQ(course.mark(1).state, CriterionState::not_in_play);
    EXPECT_TRUE(course.mark(1).counts);
    EXPECT_EQ(course.mark(1).reason, "it never came to that: all of its points lost; a must");
    Course early(text);
    work(early);
    early.end();
    EXPECT_EQ(early.now().tenths, 500) << "ended early it is marked as far as it went";
    EXPECT_FALSE(early.mark(1).counts);
}

TEST(Assessment, WhatOnlyGuardsEarnsNothingWhereNothingWasBegun) {
    Course course(lesson(
        R"({"id": "p", "kind": "prohibited", "that": {"clutch": "in"}},
           {"id": "b", "kind": "state_at", "at": "bottom", "that": {"stopper": "on"}, "must": true})"));
    course.windlass().clutch = exercise::ClutchState::out;
    course.windlass().stopper_closed = false;
    course.run(5);
    course.end();
    EXPECT_EQ(course.mark(0).milli, 1000);
    EXPECT_EQ(course.now().tenths, 0);
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

// Who confirms a criterion, or the whole, changes nothing of what stands.
TEST(Assessment, ConfirmedOnceMoreAnAssessorsWordStands) {
    using exercise::AssessorVerdict;
    Course course(lesson(R"({"id": "a", "kind": "final", "that": {"stopper": "on"}},
                            {"id": "b", "kind": "final", "that": {"brake_position": {"above": 0.9}}})"));
    course.windlass().stopper_closed = false;
    course.windlass().brake_position = 0;
    course.run(1);
    course.end();
    course.say(
        {.criterion = "a", .verdict = AssessorVerdict::points, .milli = 400, .note = "in part", .by = "Ann"});
    EXPECT_EQ(course.now().tenths, 200);
    for (const char* criterion : {"", "a", "b", ""})
        course.say({.criterion = criterion,
                    .verdict = AssessorVerdict::confirmed,
                    .note = "as it stands",
                    .by = "Ben"});
    EXPECT_EQ(course.mark(0).counted, 400);
    EXPECT_EQ(course.mark(1).counted, 0) << "as it was computed";
    EXPECT_EQ(course.now().tenths, 200);
}

TEST(Assessment, ConfirmedAMustThatTheLessonNeverCameToIsNotExcused) {
    Course course(lesson(
        R"({"id": "a", "kind": "final", "that": {"stopper": "on"}},
           {"id": "b", "kind": "state_at", "at": "bottom", "that": {"brake_position": {"above": 0.9}}, "must": true})",
        R"(, "end": {"time": 2})"));
    course.windlass().stopper_closed = true;
    course.run(5);
    const Result before = course.now();
    EXPECT_EQ(before.outcome, Outcome::not_shown);
    course.say({.criterion = "b",
                .verdict = exercise::AssessorVerdict::confirmed,
                .note = "as it stands",
                .by = "Ben"});
    EXPECT_TRUE(course.mark(1).counts);
    EXPECT_EQ(course.now().tenths, before.tenths);
    EXPECT_EQ(course.now().outcome, before.outcome);
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

TEST(Assessment, NoteThatDoesNotFitTheWireSaysThatItIsCut) {
    Course course(lesson(R"({"id": "a", "kind": "final", "that": {"stopper": "on"}})"));
    course.windlass().stopper_closed = false;
    course.run(1);
    course.end();
    course.say({.criterion = "a",
                .verdict = exercise::AssessorVerdict::met,
                .note = std::string(256, 'x'),
                .by = "Ann"});
    EXPECT_EQ(course.mark().reason.size(), 256U);
    EXPECT_TRUE(course.mark().reason.ends_with("x ...")) << course.mark().reason;
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

// Whatever the bridge waits for meanwhile: who runs onto the danger hears that, and no more of the cable.
TEST(Assessment, AccidentThatNoEventTellsEndsItAsNotYetInItsOwnWords) {
    Course course(lesson(R"({"id": "a", "kind": "final", "that": {"stopper": "on"}})",
                         R"(, "end": {"good": {"event": "anchor.brought_up"}, "abort": ["cable.lost"],
                "accidents": [{"when": {"ship_y": 315}, "say": "she has run onto the danger"}]})"));
    course.windlass().stopper_closed = true;
    course.seen().ship.position.y() = 314.9;
    course.run(1);
    EXPECT_FALSE(course.now().finished);
    course.seen().ship.position.y() = 315;
    course.event("anchor.brought_up");
    course.run(0.1);
    EXPECT_TRUE(course.now().finished);
    EXPECT_EQ(course.now().ending, Ending::abort);
    EXPECT_EQ(course.now().outcome, Outcome::not_yet);
    EXPECT_EQ(course.now().abort, "she has run onto the danger");
}

} // namespace windlass::assess
