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

// Two windlasses, two men: what one says is nothing that the other has said.
TEST(Assessment, AReportOfAConditionIsOfItsSide) {
    const auto holds = [](const char* side, int reported) {
        Course course(lesson(R"({"id": "f", "kind": "final", "that": {)" + std::string(side) +
                             R"("report": "on_the_bottom"}})"));
        course.seen().tackle.emplace_back().side = exercise::Side::starboard;
        course.report({.code = exercise::ReportCode::on_the_bottom, .side = reported});
        course.run(1);
        return course.mark().milli == 1000;
    };
    EXPECT_TRUE(holds("", 0));
    EXPECT_FALSE(holds("", 1));
    EXPECT_TRUE(holds(R"("side": "starboard", )", 1));
    EXPECT_FALSE(holds(R"("side": "starboard", )", 0));
    EXPECT_TRUE(holds(R"("side": "starboard", )", -1)); // of no side: of both
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
    EXPECT_NE(course.mark().reason.find("brake was open"), std::string::npos) << course.mark().reason;
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

// Silence costs the whole mark, and so does a false call, put right or not; a lesson may forgive some: they
// cost half.
TEST(Assessment, FalseCallCostsWhatSilenceCosts) {
    const struct {
        int forgiven, cries, milli;
    } cases[] = {{0, 0, 1000}, {0, 1, 0}, {1, 1, 500}, {1, 2, 0}, {2, 10, 0}};
    for (const auto& one : cases) {
        Course course(lesson(R"({"id": "r", "kind": "report", "report": "on_the_bottom", "false_calls": )" +
                             std::to_string(one.forgiven) + "}"));
        for (int cry = 0; cry < one.cries; ++cry) {
            course.report(exercise::ReportCode::on_the_bottom);
            course.run(10);
        }
        course.event("anchor.on_bottom");
        course.run(5);
        course.report(exercise::ReportCode::on_the_bottom);
        course.run(5);
        EXPECT_EQ(course.mark().milli, one.milli) << one.cries << " cries";
    }
}

// What eye and ear cannot tell apart from the truth is true: 3 s before the touch.
TEST(Assessment, AReportThatIsEarlierThanAnybodyCouldTellIsRight) {
    for (const double before : {0.1, 2.5, 3.5}) {
        Course course(lesson(R"({"id": "r", "kind": "report", "report": "on_the_bottom"})"));
        course.run(10);
        course.report(exercise::ReportCode::on_the_bottom);
        course.run(before);
        course.event("anchor.on_bottom");
        course.run(60);
        EXPECT_EQ(course.mark().milli, before < 3 ? 1000 : 0) << before;
    }
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

// 3 s for the hand are free, nothing is left at 13 s: at 8 s half.
TEST(Assessment, TimeToActIsGradedAndNoCliff) {
    const struct {
        double after;
        int milli;
    } cases[] = {{2, 1000}, {3, 1000}, {8, 500}, {12, 100}, {14, 0}};
    for (const auto& one : cases) {
        Course course(lesson(
            R"({"id": "b", "kind": "state_at", "at": "bottom", "after": 3, "zero": 13, "that": {"brake_position": {"above": 0.9}}})"));
        course.windlass().brake_position = 0;
        course.event("anchor.on_bottom");
        course.run(one.after);
        course.windlass().brake_position = 1;
        course.run(30);
        EXPECT_NEAR(course.mark().milli, one.milli, 1) << one.after;
    }
}

TEST(Assessment, ReasonOfAStateThatCameTooLateSaysByHowMuch) {
    const auto braked = [](double after) {
        Course course(lesson(
            R"({"id": "b", "kind": "state_at", "at": "bottom", "after": 3, "zero": 13, "that": {"brake_position": {"above": 0.9}}})"));
        course.windlass().brake_position = 0;
        course.event("anchor.on_bottom");
        course.run(after);
        course.windlass().brake_position = 1;
        course.run(30);
        return course.mark().reason;
    };
    EXPECT_EQ(braked(2), "0:02 wanted: brake hard on; it was so") << "in time";
    EXPECT_EQ(braked(8), "0:08 wanted: brake hard on; it was so 8 s after \"bottom\", wanted within 3 s: "
                         "50 % of its points lost");
    EXPECT_EQ(braked(40), "0:13 brake was open; wanted: brake hard on: all of its points lost");
}

// Each order wants its figure, when and where it is carried out; one before it is none of it, and a wrong one
// takes away the right one, or half of it where it is put right at once.
TEST(Assessment, AReportOfAFigureBelongsToItsOrder) {
    const auto play = [](const std::vector<std::pair<double, double>>& reports) { // m out, shackles said
        Course course(lesson(
            R"({"id": "r", "kind": "report", "report": "shackles_in_pipe", "orders": ["two", "three"]})",
            R"(, "orders": [{"id": "two", "code": "pay_out", "value": 2, "when": {"time": 10}},
                                   {"id": "three", "code": "pay_out", "value": 3, "when": {"time": 20}}])"));
        std::size_t next = 0;
        for (int half = 0; half < 6; ++half) {
            course.run(5);
            for (const exercise::Order& order : course.due)
                course.seen().bridge_orders.push_back(
                    {.number = static_cast<int>(course.seen().bridge_orders.size()) + 1,
                     .given = std::get<exercise::BridgeOrderGiven>(order)});
            course.due.clear();
            if (next == reports.size()) continue;
            course.chain().cable_out = reports[next].first;
            if (reports[next].second >= 0)
                course.report(exercise::ReportCode::shackles_in_pipe, reports[next].second);
            ++next;
        }
        course.end();
        return course.mark().milli;
    };
    constexpr double kTwo = 55, kThree = 82.5;
    EXPECT_EQ(play({{5, -1}, {5, -1}, {kTwo, 2}, {kTwo, -1}, {kThree, 3}}), 1000);
    EXPECT_EQ(play({{5, 0.2}, {5, 0.2}, {5, -1}, {5, -1}, {kThree, -1}}), 0) << "true, and of no order";
    EXPECT_EQ(play({{5, -1}, {5, -1}, {5, 0.2}, {kTwo, -1}, {kThree, 3}}), 500) << "true, and not there yet";
    EXPECT_EQ(play({{5, -1}, {5, -1}, {kTwo, 2}, {kTwo, 4}}), 500) << "said otherwise of the next";
    EXPECT_EQ(play({{5, -1}, {5, -1}, {kTwo, 2}, {kTwo, 4}, {kThree, 3}}), 750) << "and put right";
    EXPECT_EQ(play({{5, -1}, {5, -1}, {kTwo, 4}, {kTwo, 2}, {kThree, 3}}), 750)
        << "put right as the next order comes";
    EXPECT_EQ(play({{5, -1}, {5, 3}, {kTwo, 2}, {kTwo, -1}, {kThree, 3}}), 750);
}

// The first figure is the answer. One that puts it right at once is an honest man's, and leaves half; who
// goes on has not looked.
TEST(Assessment, AFigureIsPutRightOnceAndIsNotTried) {
    // s after the one before, shackles said; four are out, and are ordered at a minute
    const auto said = [](const std::vector<std::pair<double, double>>& reports) {
        Course course(
            lesson(R"({"id": "r", "kind": "report", "report": "shackles_in_pipe", "orders": ["four"]})",
                   R"(, "orders": [{"id": "four", "code": "pay_out", "value": 4, "when": {"time": 60}}])"));
        course.chain().cable_out = 4 * 27.5 - 1.5;
        const auto run = [&](double seconds) {
            for (int k = 0; k < std::lround(seconds * kRate); ++k) {
                course.run(1.0 / kRate);
                for (const exercise::Order& order : course.due)
                    course.seen().bridge_orders.push_back(
                        {.number = 1, .given = std::get<exercise::BridgeOrderGiven>(order)});
                course.due.clear();
            }
        };
        for (const auto& [after, shackles] : reports) {
            run(after);
            course.report(exercise::ReportCode::shackles_in_pipe, shackles);
        }
        run(1);
        course.end();
        return course.mark().milli;
    };
    EXPECT_EQ(said({{65, 4}}), 1000);
    EXPECT_EQ(said({{65, 4}, {5, 4.2}, {5, 3.8}}), 1000) << "right, and right again";
    EXPECT_EQ(said({{65, 2}, {5, 4}}), 500);
    EXPECT_EQ(said({{65, 2}, {14.9, 4}}), 500);
    EXPECT_EQ(said({{65, 2}, {15.2, 4}}), 0) << "not at once";
    EXPECT_EQ(said({{65, 2}, {5, 4}, {5, 4}}), 500) << "and says it once more";
    EXPECT_EQ(said({{65, 2}, {5, 2.5}, {5, 4}}), 0) << "tries figures";
    EXPECT_EQ(said({{65, 2}, {5, 4}, {5, 6}}), 0);
    EXPECT_EQ(said({{65, 2}, {5, 4}, {5, 6}, {5, 4}}), 0);
    EXPECT_EQ(said({{65, 4}, {5, 2}}), 0) << "what was right is taken back";
    EXPECT_EQ(said({{20, 2}, {45, 4}}), 0) << "before the order, and never put right";
    EXPECT_EQ(said({{20, 2}, {5, 4}, {40, 4}}), 1000) << "put right before it was asked for";
}

// L12 once gave 85 points to who did nothing: limits that nothing came near.
TEST(Assessment, WhatOnlyGuardsEarnsInTheMeasureOfWhatWasDone) {
    const char* text = R"({"id": "l", "kind": "limit", "of": "cable_speed", "max": 3, "weight": 60},
        {"id": "p", "kind": "prohibited", "that": {"clutch": "in"}, "weight": 20},
        {"id": "s", "kind": "final", "that": {"stopper": "on"}, "weight": 10},
        {"id": "b", "kind": "final", "that": {"brake_position": {"above": 0.9}}, "weight": 10})";
    for (const bool acts : {false, true}) {
        Course course(lesson(text));
        course.windlass().clutch = exercise::ClutchState::out;
        course.windlass().brake_position = 1; // which was so, and stays so
        course.windlass().stopper_closed = false;
        course.run(5);
        course.windlass().stopper_closed = acts;
        course.run(5);
        course.end();
        EXPECT_EQ(course.now().tenths, acts ? 1000 : 0);
        EXPECT_EQ(course.now().outcome, acts ? Outcome::achieved : Outcome::not_shown);
    }
}

TEST(Assessment, DeedThatWasSoAlreadyIsDoneByWhoeverHasHeardTheOrder) {
    for (const bool heard : {false, true}) {
        Course course(lesson(R"({"id": "o", "kind": "order", "orders": "out"})",
                             R"(, "orders": [{"id": "out", "code": "gear_out"}])"));
        course.windlass().clutch = exercise::ClutchState::out;
        course.run(1);
        ASSERT_EQ(course.due.size(), 1u);
        course.seen().bridge_orders.push_back(
            {.number = 1, .time = 1, .given = std::get<exercise::BridgeOrderGiven>(course.due[0])});
        course.run(2);
        if (heard) course.seen().bridge_orders[0].state = exercise::BridgeOrderState::repeated;
        course.run(5);
        course.end();
        EXPECT_EQ(course.mark().milli, heard ? 1000 : 0);
    }
}

TEST(Assessment, StatesCanBeSaidByEitherAndNot) {
    Course course(
        R"({"id": "T", "states": {"open": {"brake_position": {"below": 0.1}}, "off": {"stopper": "off"}},
            "moments": {"seen": {"event": "anchor.aweigh"}},
            "criteria": [{"id": "e", "kind": "prohibited", "that": {"either": ["open", "off"]}},
                         {"id": "n", "kind": "prohibited", "that": {"stopper": "off", "not": "seen"}}]})");
    course.windlass().stopper_closed = true;
    course.windlass().brake_position = 1;
    course.run(1);
    EXPECT_EQ(course.mark(0).milli, 1000);
    course.event("anchor.aweigh");
    course.run(1);
    course.windlass().stopper_closed = false;
    course.run(1);
    EXPECT_EQ(course.mark(0).milli, 0);
    EXPECT_EQ(course.mark(1).milli, 1000) << "it has been seen";
}

TEST(Assessment, WhatComesOftenIsCounted) {
    Course course(
        lesson(R"({"id": "p", "kind": "prohibited", "that": {"event": "anchor.aweigh", "times": 3}})"));
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(course.mark().state == CriterionState::not_met, false);
        course.event("anchor.aweigh");
        course.run(1);
    }
    EXPECT_EQ(course.mark().state, CriterionState::not_met);
}

// Neighbours draw other things, the same seed the same, and all lies within the author's bounds.
TEST(Assessment, ChanceIsDrawnFromTheAttemptsSeed) {
    const std::string text =
        R"({"id": "T", "criteria": [{"id": "p", "kind": "prohibited", "that": {"clutch": "in"}}],
        "faults": [{"code": "brake-lining-faded", "severity_between": [0.2, 0.8], "delay": [10, 30], "one_of": "kind"},
                   {"code": "drive-trip", "severity_between": [0.2, 0.8], "delay": [10, 30], "one_of": "kind"}]})";
    const auto attempt = [&](double seed) {
        Course course(text);
        course.draw(seed);
        course.run(60);
        EXPECT_EQ(course.due.size(), 1U) << "one of its kinds";
        const auto fault = std::get<exercise::FaultOrder>(course.due.at(0));
        EXPECT_GE(fault.severity, 0.2);
        EXPECT_LE(fault.severity, 0.8);
        return fault;
    };
    const auto one = attempt(0.5), same = attempt(0.5);
    EXPECT_EQ(one.code, same.code);
    EXPECT_EQ(one.severity, same.severity);
    int other_kind = 0, other_severity = 0;
    for (int k = 0; k < 20; ++k) {
        const auto next = attempt(0.5 + k * 1e-9);
        other_kind += next.code != one.code;
        other_severity += next.severity != one.severity;
    }
    EXPECT_GT(other_kind, 3);
    EXPECT_GT(other_severity, 15);
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

namespace {
const std::string kHinted =
    lesson(R"({"id": "stops", "kind": "prohibited", "that": {"cable_speed": {"above": 3}}})",
           R"(, "hints": [{"id": "runs", "criterion": "stops", "say": "Check her.",
    "when": {"moment": "bottom", "cable_speed": {"above": 1}, "for": 1}}, {"id": "bell", "seat": "bridge",
    "when": {"moment": "bottom", "since": 9, "side": "port"}, "say": "Ring it."}])");

/// She runs after the bottom, twice.
void run_twice(Course& course) {
    course.event("anchor.on_bottom");
    course.windlass().cable_speed = 2;
    course.run(2);
    course.windlass().cable_speed = 0;
    course.run(1);
    course.windlass().cable_speed = 2;
    course.run(2);
}
} // namespace

TEST(Assessment, AHintIsToldOnceInPracticeAndNeverInATest) {
    Course practice(for_practice(kHinted));
    run_twice(practice);
    practice.run(6);
    const Result told = practice.now();
    EXPECT_TRUE(told.practice);
    ASSERT_EQ(told.hints.size(), 2U);
    EXPECT_EQ(told.hints[0].id, "runs");
    EXPECT_EQ(told.hints[0].criterion, "stops");
    EXPECT_EQ(told.hints[0].text, "Check her.");
    EXPECT_TRUE(told.hints[0].forecastle);
    EXPECT_EQ(told.hints[0].tick, 11U) << "of 10 a second, from the first on";
    EXPECT_FALSE(told.hints[1].forecastle);

    Course test(kHinted);
    run_twice(test);
    test.run(6);
    EXPECT_FALSE(test.now().practice);
    EXPECT_TRUE(test.now().hints.empty());
    EXPECT_EQ(test.now().lesson_hash, told.lesson_hash) << "it is one lesson";
    EXPECT_EQ(test.mark().milli, practice.mark().milli) << "a hint costs nothing";
}

} // namespace windlass::assess
