// The fold over made pictures: what the lesson's bridge orders, and what becomes of it.

#include "tests/lesson/course.hpp"

#include <gtest/gtest.h>

namespace windlass::assess {
namespace {

/// The bridge gives the first order that is due, at 1 s and to be repeated within ten.
void give_first(Course& course, exercise::BridgeOrderState state, double do_by = 0) {
    course.seen().bridge_orders.push_back({.number = 1,
                                           .time = 1,
                                           .repeat_by = 11,
                                           .do_by = do_by,
                                           .given = std::get<exercise::BridgeOrderGiven>(course.due.at(0)),
                                           .state = state});
}

} // namespace

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
    give_first(course, exercise::BridgeOrderState::misrepeated, 21);
    course.run(2);
    course.seen().bridge_orders[0].state = exercise::BridgeOrderState::repeated;
    course.run(38); // 40 s after it was given: twice as long as he had
    course.windlass().clutch = exercise::ClutchState::in;
    course.run(5);
    course.end();
    EXPECT_EQ(course.mark().milli, 500); // 200 of 400 for the repeat, 300 of 600 for the deed
}

// Both gears at the first order, one of them at the second.
TEST(Assessment, OrderToBothIsCarriedOutByBoth) {
    Course course(lesson(R"({"id": "o", "kind": "order", "orders": ["in", "out"]})",
                         R"(, "orders": [{"id": "in", "code": "gear_in", "side": "both"},
                                         {"id": "out", "code": "gear_out", "side": "both"}])"));
    course.seen().tackle.emplace_back();
    course.seen().tackle[1].side = exercise::Side::starboard;
    auto& port = course.seen().tackle[0].windlass;
    auto& starboard = course.seen().tackle[1].windlass;
    port.clutch = starboard.clutch = exercise::ClutchState::out;
    course.run(1);
    ASSERT_EQ(course.due.size(), 1u);
    const auto give = [&](int number) {
        course.seen().bridge_orders.push_back(
            {.number = number,
             .time = course.seen().time,
             .given = std::get<exercise::BridgeOrderGiven>(course.due.back()),
             .state = exercise::BridgeOrderState::repeated});
    };
    give(1);
    port.clutch = exercise::ClutchState::in;
    course.run(5);
    ASSERT_EQ(course.now().orders.size(), 1U);
    EXPECT_EQ(course.now().orders[0].tick, 0U) << "starboard has done nothing";
    port.clutch = exercise::ClutchState::out; // he has done it, whatever he does after
    starboard.clutch = exercise::ClutchState::in;
    course.run(5);
    EXPECT_EQ(course.now().orders[0].tick, 61U) << "when the second had";
    ASSERT_EQ(course.due.size(), 2u);
    give(2);
    course.run(20); // port is out of gear
    course.end();
    EXPECT_EQ(course.mark().milli, 700); // 400 for the repeat and 600 for the deed, and 400 of the second
    EXPECT_NE(course.mark().reason.find("\"put both windlasses out of gear\" not carried out by starboard"),
              std::string::npos)
        << course.mark().reason;
    EXPECT_EQ(course.mark().lost_tick, 111U) << "when it was given";
}

TEST(Assessment, OrderToBothThatNeitherCarriedOutNamesBoth) {
    Course course(lesson(R"({"id": "o", "kind": "order", "orders": ["in"]})",
                         R"(, "orders": [{"id": "in", "code": "gear_in", "side": "both"}])"));
    course.seen().tackle.emplace_back();
    course.seen().tackle[1].side = exercise::Side::starboard;
    for (exercise::TackleView& tackle : course.seen().tackle)
        tackle.windlass.clutch = exercise::ClutchState::out;
    course.run(1);
    ASSERT_EQ(course.due.size(), 1u);
    course.seen().bridge_orders.push_back({.number = 1,
                                           .time = course.seen().time,
                                           .given = std::get<exercise::BridgeOrderGiven>(course.due.back()),
                                           .state = exercise::BridgeOrderState::repeated});
    course.run(5);
    course.end();
    EXPECT_NE(course.mark().reason.find("not carried out by port or starboard"), std::string::npos)
        << course.mark().reason;
}

// Nobody holds on at six who has seven out: he can walk one back, or call the order unsafe.
TEST(Assessment, OrderToHoldOnIsNotCarriedOutWithMoreOutThanItSays) {
    for (const double shackles : {5.5, 5.9, 6.2, 6.5, 7.0}) {
        Course course(lesson(R"({"id": "o", "kind": "order", "orders": "hold"})",
                             R"(, "orders": [{"id": "hold", "code": "hold_on", "value": 6}])"));
        course.run(1);
        ASSERT_EQ(course.due.size(), 1u);
        give_first(course, exercise::BridgeOrderState::repeated);
        course.windlass().cable_speed = 1;
        course.run(2);
        course.windlass().cable_speed = 0;
        course.windlass().brake_position = 1;
        course.chain().cable_out = shackles * 27.5;
        course.run(10);
        const bool near = std::abs(shackles - 6) < 0.25;
        EXPECT_EQ(course.now().orders.at(0).tick > 0, near) << shackles;
        course.end();
        EXPECT_EQ(course.mark().milli, near ? 1000 : 400) << shackles << ": " << course.mark().reason;
    }
}

// One jerk of the lever heaves no four shackles in, nor walks them out.
TEST(Assessment, CableThatOnlyBeginsToComeIsNotHoveOrWalkedToItsMark) {
    for (const auto& [code, speed] : {std::pair("heave_to", -0.1), std::pair("walk_back", 0.1)}) {
        Course course(
            lesson(R"({"id": "o", "kind": "order", "orders": "heave"})",
                   std::string(R"(, "orders": [{"id": "heave", "code": ")") + code + R"(", "value": 3}])"));
        course.chain().cable_out = (speed < 0 ? 5 : 1) * 27.5;
        course.run(1);
        ASSERT_EQ(course.due.size(), 1u);
        give_first(course, exercise::BridgeOrderState::repeated);
        course.windlass().clutch = exercise::ClutchState::in;
        course.windlass().cable_speed = speed;
        course.run(10);
        EXPECT_EQ(course.now().orders.at(0).tick, 0U) << code;
        course.windlass().cable_speed = 0;
        course.chain().cable_out = 3 * 27.5;
        course.run(10);
        EXPECT_GT(course.now().orders.at(0).tick, 0U) << code;
    }
}

// Against a closed bar it comes in by the bar's play, and stands.
TEST(Assessment, CableThatComesInAgainstAClosedBarIsNotHove) {
    Course course(lesson(R"({"id": "o", "kind": "order", "orders": "heave"},
                            {"id": "r", "kind": "report", "report": "heaving"})",
                         R"(, "orders": [{"id": "heave", "code": "heave"}])"));
    course.windlass().stopper_closed = true;
    course.run(1);
    ASSERT_EQ(course.due.size(), 1u);
    give_first(course, exercise::BridgeOrderState::repeated);
    course.windlass().cable_speed = -0.06;
    course.run(2);
    course.windlass().cable_speed = 0;
    course.run(10);
    EXPECT_EQ(course.now().orders.at(0).tick, 0U);
    EXPECT_EQ(course.mark(1).state, CriterionState::not_in_play) << "there is nothing to report";
    course.windlass().stopper_closed = false;
    course.windlass().cable_speed = -0.06;
    course.run(2);
    EXPECT_GT(course.now().orders.at(0).tick, 0U);
    EXPECT_EQ(course.mark(1).state, CriterionState::open);
}

// Checked for two seconds at the second mark and let go on to the third, it was not paid out to two.
TEST(Assessment, CableThatPausesAtItsMarkHasNotBeenPaidOutToIt) {
    Course course(lesson(R"({"id": "o", "kind": "order", "orders": "pay"})",
                         R"(, "orders": [{"id": "pay", "code": "pay_out", "value": 2}])"));
    course.run(1);
    ASSERT_EQ(course.due.size(), 1u);
    give_first(course, exercise::BridgeOrderState::repeated);
    const auto runs_on = [&] {
        course.windlass().cable_speed = 1;
        course.run(1);
        course.windlass().cable_speed = 0;
    };
    runs_on();
    course.chain().cable_out = 2 * 27.5;
    course.run(2);
    runs_on();
    course.chain().cable_out = 3 * 27.5;
    course.run(10);
    EXPECT_EQ(course.now().orders.at(0).tick, 0U);
    course.chain().cable_out = 2 * 27.5;
    course.run(4);
    EXPECT_EQ(course.now().orders.at(0).tick, 151U) << "since when it has stood there";
}

TEST(Assessment, OrderThatIsNeverRepeatedSaysSo) {
    Course course(lesson(R"({"id": "o", "kind": "order", "orders": "in"})",
                         R"(, "orders": [{"id": "in", "code": "gear_in"}])"));
    course.run(1);
    ASSERT_EQ(course.due.size(), 1u);
    give_first(course, exercise::BridgeOrderState::not_repeated);
    course.run(1);
    course.windlass().clutch = exercise::ClutchState::in;
    course.run(20);
    course.end();
    EXPECT_EQ(course.mark().reason, "0:01 \"put port windlass in gear\" not repeated back within 10 s, "
                                    "carried out after 1 s: 40 % of its points lost");
}

// Nobody had the time that the order gives him: it is told how far it came.
TEST(Assessment, OrderThatHadNotItsTimeSaysUntilWhenItWasNotCarriedOut) {
    const auto reason = [](double next, double end) {
        Course course(lesson(R"({"id": "o", "kind": "order", "orders": "walk"})",
                             R"(, "orders": [{"id": "walk", "code": "walk_out", "value": 33},
                                {"id": "let-go", "code": "let_go", "when": {"time": )" +
                                 std::to_string(next) + "}}]"));
        course.run(1);
        const auto give = [&](int number) {
            course.seen().bridge_orders.push_back(
                {.number = number,
                 .time = course.seen().time,
                 .do_by = course.seen().time + 100,
                 .given = std::get<exercise::BridgeOrderGiven>(course.due.back()),
                 .state = exercise::BridgeOrderState::repeated});
        };
        give(1);
        course.run(next + 0.5 - 1);
        if (course.due.size() > 1) give(2);
        course.run(end - next - 0.5);
        course.end();
        return course.mark().reason;
    };
    EXPECT_NE(reason(60, 70).find("not carried out before the bridge ordered \"let go port anchor\" at 1:00"),
              std::string::npos)
        << reason(60, 70);
    EXPECT_NE(reason(120, 130).find("not carried out within 100 s"), std::string::npos) << reason(120, 130);
    EXPECT_NE(reason(500, 510).find("not carried out within 100 s"), std::string::npos) << reason(500, 510);
    Course ended(lesson(R"({"id": "o", "kind": "order", "orders": "in"})",
                        R"(, "orders": [{"id": "in", "code": "gear_in"}])"));
    ended.windlass().clutch = exercise::ClutchState::out;
    ended.run(1);
    give_first(ended, exercise::BridgeOrderState::repeated, 101);
    ended.run(49);
    ended.end();
    EXPECT_NE(ended.mark().reason.find("not carried out before the lesson ended at 0:50"), std::string::npos)
        << ended.mark().reason;
}

// He who says nothing to it has not shown that he heard it.
TEST(Assessment, OrderForWhatIsSoAlreadyEarnsNothingByItself) {
    Course course(lesson(R"({"id": "o", "kind": "order", "orders": "in"})",
                         R"(, "orders": [{"id": "in", "code": "gear_in"}])"));
    course.windlass().clutch = exercise::ClutchState::in;
    course.run(1);
    ASSERT_EQ(course.due.size(), 1u);
    give_first(course, exercise::BridgeOrderState::not_repeated);
    course.run(20);
    course.end();
    EXPECT_EQ(
        course.mark().reason,
        "0:01 \"put port windlass in gear\" not repeated back within 10 s; it was so already when it was "
        "given, and nothing was said to it: all of its points lost");
}

} // namespace windlass::assess
