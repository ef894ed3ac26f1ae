// From when an attempt that went wrong is done again.

#include "recorder/debrief/again.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <utility>

namespace windlass::debrief {
namespace {

/// An attempt of 400 s whose one must was lost. Ticks are tenths of a second.
class LostAttempt : public ::testing::Test {
protected:
    LostAttempt() {
        attempt_.dt = 0.1;
        attempt_.ended = 400;
        attempt_.assessment.emplace().ending(LESSON_DONE);
    }
    /// decided, lost: s of exercise.
    Criterion& lost(CriterionKind kind, double decided_at, double lost_at) {
        Criterion& made = attempt_.assessment->criteria().emplace_back();
        made.code("pay_out");
        made.kind(kind);
        made.state(CRITERION_NOT_MET);
        made.weight(10);
        made.counts(true);
        made.must(true);
        made.tick(static_cast<std::uint64_t>(10 * decided_at));
        made.lost_tick(static_cast<std::uint64_t>(10 * lost_at));
        return made;
    }
    void moves(std::initializer_list<double> times) {
        for (const double time : times)
            attempt_.lever_moves.push_back({.time = time, .side = SIDE_PORT, .by = "ben"});
    }
    void order(double time, BridgeOrderCode code, double value = 0) {
        BridgeOrder given;
        given.number(static_cast<std::int32_t>(attempt_.orders.size() + 1));
        given.time(time);
        given.code(code);
        given.value(value);
        given.repeat_by(code == BRIDGE_ORDER_HOW_MUCH ? time : time + 10);
        attempt_.orders.push_back({given, time});
    }
    /// "levers 12": before what it begins, and from when.
    std::string begins() const {
        const auto again = again_of(attempt_);
        return again ? std::string(name_of(again->before)) + ' ' + std::to_string(std::lround(again->from))
                     : std::string();
    }

    Attempt attempt_;
};

TEST_F(LostAttempt, BeginsBeforeTheHandThatLostIt) {
    lost(CRITERION_LIMIT, 140, 130);
    EXPECT_EQ(begins(), "loss 120") << "nobody knows what lost it";
    moves({20, 90, 91, 92.5, 135});
    EXPECT_EQ(begins(), "levers 80") << "the wheel was spun open from 90 on";
    const auto again = again_of(attempt_);
    EXPECT_EQ(again->lost, "pay out");
    EXPECT_DOUBLE_EQ(again->lost_at, 130);
    EXPECT_DOUBLE_EQ(again->seconds, 10);
    attempt_.lever_moves.clear();
    moves({2});
    EXPECT_EQ(begins(), "loss 120") << "that was long before";
    attempt_.assessment->criteria()[0].lost_tick(55);
    EXPECT_EQ(begins(), "levers 0") << "and not before the attempt began";
    EXPECT_DOUBLE_EQ(again_of(attempt_)->seconds, 2);
}

TEST_F(LostAttempt, OfAnOrderThatWasNotCarriedOutBeginsBeforeItWasGiven) {
    moves({70, 95});
    lost(CRITERION_ORDER, 200, 60);
    EXPECT_EQ(begins(), "order 50");
}

TEST_F(LostAttempt, OfStepsThatWereNotTakenBeginsBeforeTheOrderForThem) {
    order(100, BRIDGE_ORDER_HOLD_ON, 6);
    order(200, BRIDGE_ORDER_SECURE);
    order(220, BRIDGE_ORDER_SECURE); // said again
    order(240, BRIDGE_ORDER_HOW_MUCH);
    order(250, BRIDGE_ORDER_LET_GO);
    attempt_.orders.back().order.state(ORDER_CANCELLED);
    moves({210});
    lost(CRITERION_SEQUENCE, 300, 300);
    EXPECT_EQ(begins(), "order 190");
    attempt_.orders.clear();
    EXPECT_EQ(begins(), "loss 290");
}

TEST_F(LostAttempt, OfStepsOnAnOrderBeginsBeforeThatOrderWhateverCameSince) {
    attempt_.lesson.json =
        R"({"lesson": {"orders": [{"id": "home", "code": "heave"}, {"id": "s", "code": "secure"}],
        "criteria": [{"id": "pay_out", "from": {"given": "s"}}]}})";
    order(100, BRIDGE_ORDER_SECURE);
    order(200, BRIDGE_ORDER_HEAVE);
    lost(CRITERION_SEQUENCE, 300, 300);
    EXPECT_EQ(begins(), "order 90");
    attempt_.orders.erase(attempt_.orders.begin());
    EXPECT_EQ(begins(), "order 190") << "it never came: that which was the last";
}

TEST_F(LostAttempt, OfStepsOnTwoOrdersBeginsBeforeTheLastOfThem) {
    attempt_.lesson.json =
        R"({"lesson": {"orders": [{"id": "p", "code": "secure"}, {"id": "s", "code": "heave"}],
        "criteria": [{"id": "pay_out", "from": {"given": ["p", "s"]}, "within": 60}]}})";
    order(100, BRIDGE_ORDER_SECURE);
    order(200, BRIDGE_ORDER_HEAVE);
    order(250, BRIDGE_ORDER_HOLD_ON, 6);
    lost(CRITERION_SEQUENCE, 300, 300);
    EXPECT_EQ(begins(), "order 190");
}

TEST_F(LostAttempt, OfStepsThatHaveTimeFromAMomentOnBeginsBeforeThatTimeDid) {
    attempt_.lesson.json =
        R"({"lesson": {"criteria": [{"id": "pay_out", "from": {"moment": "rises"}, "within": 120}]}})";
    order(250, BRIDGE_ORDER_HOLD_ON, 6);
    lost(CRITERION_SEQUENCE, 300, 300);
    EXPECT_EQ(begins(), "due 170") << "the order came when it was half over";
}

TEST_F(LostAttempt, SaysWhatElseHadGoneWrongByThen) {
    order(200, BRIDGE_ORDER_SECURE);
    lost(CRITERION_SEQUENCE, 300, 300);
    for (const auto& [code, at] :
         {std::pair{"after", 250}, std::pair{"to_the-bottom", 150}, std::pair{"fall", 33}}) {
        Criterion& other = lost(CRITERION_LIMIT, at, at);
        other.code(code);
        other.must(false);
    }
    const auto again = again_of(attempt_);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->lost, "pay out");
    EXPECT_DOUBLE_EQ(again->from, 190);
    EXPECT_THAT(again->standing, ::testing::ElementsAre("fall", "to the bottom"));
}

TEST_F(LostAttempt, OfWhatNeverWasSoBeginsBeforeTheLastOrderAndOfWhatWasBeforeTheHandThatEndedIt) {
    order(100, BRIDGE_ORDER_HOLD_ON, 6);
    moves({250});
    Criterion& scope = lost(CRITERION_FINAL, 300, 300);
    EXPECT_EQ(begins(), "order 90");
    scope.lost_tick(0);
    EXPECT_EQ(begins(), "order 90") << "the lesson never came to it";
    scope.lost_tick(2600);
    EXPECT_EQ(begins(), "levers 240");
}

TEST_F(LostAttempt, OfAStateThatIsGivenTimeBeginsBeforeThatTimeDid) {
    attempt_.lesson.json =
        R"({"lesson": {"criteria": [{"id": "other"}, {"id": "pay_out", "after": 20, "zero": 60}]}})";
    moves({190});
    Criterion& stopped = lost(CRITERION_STATE_AT, 200, 200);
    EXPECT_EQ(begins(), "due 130") << "what was to be stopped at 140 was not at 200";
    stopped.milli(250);
    EXPECT_EQ(begins(), "due 140") << "it was, 50 s after its moment: nearly too late for any mark";
    attempt_.lesson.json = R"({"lesson": {"criteria": [{"id": "pay_out"}]}})";
    EXPECT_EQ(begins(), "levers 180") << "looked at at once";
}

TEST_F(LostAttempt, OfAReportBeginsBeforeItWasDueOrWasMadeWronglyAndElseBeforeTheLastOrder) {
    order(100, BRIDGE_ORDER_PAY_OUT, 2);
    moves({150});
    Criterion& said = lost(CRITERION_REPORT, 260, 200);
    EXPECT_EQ(begins(), "loss 190") << "it could be made from 200 on";
    said.tick(4000);
    said.lost_tick(4000);
    EXPECT_EQ(begins(), "order 90") << "it never came";
    JudgedReport wrong;
    wrong.criterion("pay_out");
    attempt_.assessment->reports({wrong});
    EXPECT_EQ(begins(), "loss 390") << "it came, and was wrong";
}

TEST_F(LostAttempt, WhereTheBridgeIsJudgedBeginsBeforeItsOrder) {
    attempt_.lesson.json = R"({"lesson": {"bridge": "manned"}})";
    order(110, BRIDGE_ORDER_LET_GO);
    moves({120}); // the mate does as he is told
    lost(CRITERION_PROHIBITED, 130, 130);
    EXPECT_EQ(begins(), "order 100");
    attempt_.orders[0].order.time(5);
    EXPECT_EQ(begins(), "levers 110") << "that was given long before";
}

TEST_F(LostAttempt, ThatWentWrongAtNoMomentIsNotDoneAgain) {
    EXPECT_EQ(begins(), "");
    attempt_.assessment->ending(LESSON_TIME_UP);
    lost(CRITERION_FINAL, 400, 400);
    EXPECT_EQ(begins(), "") << "the time was up";
    attempt_.assessment.reset();
    EXPECT_EQ(begins(), "");
}

} // namespace
} // namespace windlass::debrief
