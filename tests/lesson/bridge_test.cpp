// The bridge of a lesson over made pictures: what it says to what it hears, and when it gives up.

#include "common/json_file.hpp"
#include "server/assess/bridge.hpp"
#include "tests/lesson/course.hpp"
#include "words/words.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>

namespace windlass::assess {

namespace {

using exercise::BridgeOrderCode;
using exercise::BridgeOrderState;
using exercise::ReportCode;

/// A bridge's exercise: what it orders stands in the list, repeated back as a test says.
class Bridge : public Course {
public:
    using Course::Course;

    /// Brake hard on, stopper on, gear out.
    void secure() {
        windlass().brake_position = 1;
        windlass().stopper_closed = true;
        windlass().clutch = exercise::ClutchState::out;
    }

    /// Runs on, each order put into the list as it is given.
    void on(double seconds, BridgeOrderState repeated = BridgeOrderState::repeated) {
        for (int k = 0; k < std::lround(seconds * kRate); ++k) {
            run(1.0 / kRate);
            for (const exercise::Order& order : due)
                if (const auto* given = std::get_if<exercise::BridgeOrderGiven>(&order)) {
                    said.push_back(*given);
                    seen().bridge_orders.push_back({.number = static_cast<int>(said.size()),
                                                    .tick = seen().tick,
                                                    .time = seen().time,
                                                    .repeat_by = seen().time + 10,
                                                    .do_by = seen().time + 30,
                                                    .given = *given,
                                                    .state = repeated});
                }
            due.clear();
        }
    }

    std::vector<exercise::BridgeOrderGiven> said;
};

const std::string kPayOut = R"({"id": "T", "patience": 60, "orders": [
    {"id": "two", "code": "pay_out", "value": 2, "when": {"time": 1}},
    {"id": "three", "code": "pay_out", "value": 3},
    {"id": "secure", "code": "secure"}],
  "criteria": [{"id": "o", "kind": "order", "orders": ["two", "three", "secure"]}],
  "end": {"good": {"answered": "secure"}, "time": 3000}})";

} // namespace

TEST(Bridge, OrdersByWhatItHearsAndNotByWhatIsSo) {
    Bridge bridge(kPayOut);
    bridge.chain().cable_out = 2 * 27.5; // it is done, and nobody says so
    bridge.on(20);
    ASSERT_EQ(bridge.said.size(), 1U);
    bridge.chain().cable_out = 5;
    bridge.report(ReportCode::shackles_in_pipe, 2); // it is not, and is said to be
    bridge.on(1);
    ASSERT_EQ(bridge.said.size(), 2U);
    EXPECT_EQ(bridge.said[1].value, 3);
}

TEST(Bridge, AsksHowMuchIsOutThreeTimesAndThenGivesUp) {
    Bridge bridge(kPayOut);
    bridge.on(600);
    ASSERT_EQ(bridge.said.size(), 4U);
    for (std::size_t k = 1; k < 4; ++k)
        EXPECT_EQ(bridge.said[k].code, BridgeOrderCode::how_much);
    EXPECT_TRUE(bridge.now().finished);
    EXPECT_EQ(bridge.now().ending, Ending::time);
    EXPECT_NE(bridge.now().abort.find("no answer to"), std::string::npos) << bridge.now().abort;
}

TEST(Bridge, SaysBeforehandWhenItGivesUp) {
    for (const auto repeated : {BridgeOrderState::given, BridgeOrderState::repeated}) {
        Bridge bridge(kPayOut);
        std::vector<std::int64_t> told;
        while (bridge.state().ending == Ending::none && bridge.state().tick < 6000) {
            bridge.on(0.1, repeated);
            const std::int64_t at = gives_up_at(bridge.taught(), bridge.state(), kRate);
            if (at >= 0) told.push_back(at);
        }
        ASSERT_FALSE(told.empty());
        EXPECT_EQ(bridge.state().ending, Ending::time);
        EXPECT_EQ(told.front(), bridge.state().ended) << "from the first time that it asks";
        EXPECT_EQ(told.back(), bridge.state().ended);
    }
    Bridge heard(kPayOut);
    heard.on(70);
    ASSERT_GT(heard.state().asked, 0);
    heard.report(ReportCode::shackles_in_pipe, 2);
    heard.on(0.2);
    EXPECT_EQ(gives_up_at(heard.taught(), heard.state(), kRate), -1);
}

// Who has said nothing yet is given time to find his way about; later he is called every ten seconds, told
// when it is the last time, and has half a minute to answer that.
TEST(Bridge, SaysThatItsLastCallIsTheLastAndHasMorePatienceWithAFirstWord) {
    const auto calls = [](bool has_spoken) {
        Bridge bridge(R"({"id": "T", "patience": 60, "orders": [
            {"id": "stand-by", "code": "stand_by", "when": {"time": 1}},
            {"id": "let-go", "code": "let_go", "when": {"answered": "stand-by"}}],
          "criteria": [{"id": "o", "kind": "order", "orders": ["stand-by", "let-go"]}]})");
        if (has_spoken) {
            bridge.on(2);
            bridge.report(ReportCode::standing_by);
        }
        std::vector<std::pair<long, std::string>> made; // at s
        for (std::size_t heard = bridge.said.size(); !bridge.now().finished && bridge.seen().time < 300;) {
            bridge.on(0.1, BridgeOrderState::given);
            for (; heard < bridge.said.size(); ++heard)
                made.emplace_back(std::lround(bridge.seen().time), bridge.said[heard].text);
        }
        made.emplace_back(std::lround(bridge.seen().time), "over");
        return made;
    };
    const std::string last = "I say again; this is my last call, then I send another man forward";
    const std::vector<std::pair<long, std::string>> first{
        {1, ""}, {31, "I say again"}, {61, "I say again"}, {91, last}, {121, "over"}};
    EXPECT_EQ(calls(false), first);
    const std::vector<std::pair<long, std::string>> second{
        {2, ""}, {12, "I say again"}, {22, "I say again"}, {32, last}, {62, "over"}};
    EXPECT_EQ(calls(true), second);
}

// "Put in gear" was repeated back, and she is in gear: how should he know that the bridge waits for a word?
TEST(Bridge, CallsForTheReportThatItWaitsForAndSaysInTheEndThatItHeardNone) {
    Bridge bridge(R"({"id": "T", "patience": 60, "orders": [
        {"id": "gear", "code": "gear_in", "when": {"time": 1}}, {"id": "heave", "code": "heave"}],
      "criteria": [{"id": "o", "kind": "order", "orders": ["gear", "heave"]}], "end": {"time": 3000}})");
    bridge.on(600);
    ASSERT_EQ(bridge.said.size(), 4U);
    EXPECT_EQ(bridge.said[0].text, "");
    EXPECT_EQ(bridge.said[1].text, "I say again; report \"ready\" when it is so");
    EXPECT_EQ(bridge.said[3].text.find(bridge.said[1].text + "; this is my last call"), 0U)
        << bridge.said[3].text;
    EXPECT_TRUE(bridge.now().finished);
    EXPECT_EQ(bridge.now().abort, "the bridge heard no \"ready\" after \"put port windlass in gear\"");

    Bridge other(kPayOut); // of a length it asks, and that says what it wants to hear
    other.on(70);
    ASSERT_GT(other.said.size(), 1U);
    EXPECT_EQ(other.said[1].code, BridgeOrderCode::how_much);
    EXPECT_EQ(other.said[1].text, "");
}

// What it calls for, it takes for an answer.
TEST(Bridge, TakesTheReportThatItCallsForAsAnAnswer) {
    for (const char* order :
         {R"("stand_by")", R"("clear_away")", R"("walk_out", "value": 33)", R"("let_go")", R"("gear_in")",
          R"("heave")", R"("secure")", R"("buoy_cable")", R"("slip")", R"("clear_anchor")"}) {
        Bridge bridge(R"({"id": "T", "patience": 60, "orders": [
            {"id": "one", "when": {"time": 1}, "code": )" +
                      std::string(order) + R"(}, {"id": "two", "code": "stand_clear"}],
          "criteria": [{"id": "o", "kind": "order", "orders": ["one", "two"]}], "end": {"time": 9000}})");
        for (int k = 0; k < 120 && bridge.said.size() < 2; ++k)
            bridge.on(1);
        ASSERT_EQ(bridge.said.size(), 2U) << order;
        const std::string& text = bridge.said[1].text;
        const std::size_t from = text.find('"') + 1;
        const std::string label = text.substr(from, text.find('"', from) - from);
        const auto report = std::ranges::find(words::kReportCode, label, &words::Report::label);
        ASSERT_NE(report, words::kReportCode.end()) << text;
        bridge.report(static_cast<ReportCode>(report - words::kReportCode.begin()));
        bridge.on(1);
        EXPECT_EQ(bridge.said.back().code, BridgeOrderCode::stand_clear) << text;
    }
}

// Who has stopped before he is told to has nothing left to do, and may be at another work: at the anchor
// ball, say. Who still heaves is called every ten seconds.
TEST(Bridge, IsInNoHurryWithTheWordOfWhatItSeesDone) {
    const auto calls = [](double cable_speed) {
        Bridge bridge(R"({"id": "T", "patience": 60, "orders": [
            {"id": "heave", "code": "heave", "when": {"time": 1}},
            {"id": "stop", "code": "stop_heaving", "when": {"answered": "heave", "since": 20}}],
          "criteria": [{"id": "o", "kind": "order", "orders": ["heave", "stop"]}]})");
        bridge.windlass().cable_speed = -0.15;
        bridge.windlass().speed_lever = 0.8;
        bridge.on(4);
        bridge.report(ReportCode::heaving);
        bridge.on(10);
        bridge.windlass().cable_speed = cable_speed;
        bridge.windlass().speed_lever = cable_speed < 0 ? 0.8 : 0;
        std::vector<double> at; // s
        std::int64_t foretold = -1;
        while (!bridge.now().finished && bridge.seen().time < 300) {
            const std::size_t before = bridge.said.size();
            bridge.on(0.1, BridgeOrderState::given);
            if (bridge.said.size() > before) at.push_back(bridge.seen().time);
            const std::int64_t gives_up = gives_up_at(bridge.taught(), bridge.state(), kRate);
            if (gives_up >= 0) foretold = gives_up;
        }
        EXPECT_EQ(foretold, bridge.state().ended);
        at.push_back(bridge.seen().time);
        std::vector<long> apart; // s
        for (std::size_t k = 1; k < at.size(); ++k)
            apart.push_back(std::lround(at[k] - at[k - 1]));
        return apart;
    };
    EXPECT_EQ(calls(0), (std::vector<long>{30, 30, 30, 30}));
    EXPECT_EQ(calls(-0.15), (std::vector<long>{10, 10, 10, 30}));
}

TEST(Bridge, RenewsAnOrderThatWasCarriedOutInPart) {
    Bridge bridge(kPayOut);
    bridge.on(10);
    bridge.report(ReportCode::shackles_in_pipe, 1);
    bridge.on(20);
    ASSERT_EQ(bridge.said.size(), 2U);
    EXPECT_EQ(bridge.said[1].code, BridgeOrderCode::pay_out);
    EXPECT_EQ(bridge.said[1].value, 2);
    EXPECT_EQ(bridge.said[1].text, "not enough yet");
}

TEST(Bridge, DoesNotOrderWhatIsReportedDone) {
    Bridge bridge(kPayOut);
    bridge.on(10);
    bridge.chain().cable_out = 3 * 27.5;
    bridge.report(ReportCode::shackles_in_pipe, 3);
    bridge.on(5);
    ASSERT_EQ(bridge.said.size(), 2U);
    EXPECT_EQ(bridge.said[1].code, BridgeOrderCode::secure);
    bridge.secure();
    bridge.on(2);
    bridge.report(ReportCode::secured);
    bridge.on(1);
    EXPECT_EQ(bridge.now().ending, Ending::good);
    EXPECT_EQ(bridge.now().orders.size(), 2U)
        << "three shackles were not ordered, and are nobody's to carry out";
}

// L30's end: who says "secured" with the gear still in, and takes it out then, has what she is to be left in.
TEST(Bridge, WaitsForWhatIsSaidToBeSecuredBeforeTheLessonEndsAndNotForLong) {
    const auto said_with_gear_in = [] {
        Bridge bridge(
            R"({"id": "T", "patience": 60, "orders": [{"id": "secure", "code": "secure", "when": {"time": 1}}],
          "criteria": [{"id": "up", "kind": "final",
            "that": {"brake_position": {"above": 0.95}, "stopper": "on", "clutch": "out"}}],
          "end": {"good": {"answered": "secure", "since": 5}, "time": 3000}})");
        bridge.secure();
        bridge.windlass().clutch = exercise::ClutchState::in;
        bridge.on(3);
        bridge.report(ReportCode::secured);
        bridge.on(10);
        EXPECT_FALSE(bridge.now().finished);
        return bridge;
    };
    Bridge soon = said_with_gear_in();
    soon.windlass().clutch = exercise::ClutchState::out;
    soon.on(2);
    EXPECT_EQ(soon.now().ending, Ending::good);
    EXPECT_EQ(soon.mark().milli, 1000) << soon.mark().reason;
    Bridge never = said_with_gear_in();
    never.on(6);
    EXPECT_EQ(never.now().ending, Ending::good);
    EXPECT_EQ(never.mark().milli, 0);
}

// Who says six as soon as he has let go is not asked for two, three, four and five, and has not done them.
TEST(Bridge, WhatItLeavesOutBecauseOfALieIsLost) {
    Bridge bridge(R"({"id": "T", "patience": 60, "orders": [
        {"id": "let-go", "code": "let_go", "when": {"time": 1}},
        {"id": "two", "code": "pay_out", "value": 2, "when": {"time": 30}},
        {"id": "three", "code": "pay_out", "value": 3}, {"id": "four", "code": "pay_out", "value": 4},
        {"id": "hold", "code": "hold_on", "value": 6, "when": {"time": 40}}],
      "criteria": [{"id": "o", "kind": "order", "orders": ["two", "three", "four", "hold"]},
        {"id": "r", "kind": "report", "report": "shackles_in_pipe", "orders": ["two", "three", "four", "hold"]}],
      "end": {"time": 3000}})");
    bridge.on(5);
    bridge.report(ReportCode::shackles_in_pipe, 6); // 5 m are out
    bridge.on(36);
    ASSERT_EQ(bridge.said.size(), 2U) << "it believes what it hears";
    EXPECT_EQ(bridge.said[1].code, BridgeOrderCode::hold_on);
    bridge.chain().cable_out = 6 * 27.5;
    bridge.windlass().brake_position = 1;
    bridge.on(10);
    bridge.report(ReportCode::shackles_in_pipe, 6);
    bridge.on(1);
    bridge.end();
    EXPECT_LE(bridge.mark(0).milli, 250) << "one of four at most";
    EXPECT_NE(bridge.mark(0).reason.find("not given, since more cable was reported than was out"),
              std::string::npos)
        << bridge.mark(0).reason;
    EXPECT_EQ(bridge.mark(1).milli, 0) << "three that were not asked for, and the lie takes the fourth";
}

TEST(Bridge, AWrongReportBeforeTheFirstOrderTakesThatOfTheFirst) {
    Bridge bridge(R"({"id": "T", "orders": [
        {"id": "two", "code": "pay_out", "value": 2, "when": {"time": 30}},
        {"id": "three", "code": "pay_out", "value": 3, "when": {"time": 60}}],
      "criteria": [{"id": "r", "kind": "report", "report": "shackles_in_pipe", "orders": ["two", "three"]}],
      "end": {"time": 3000}})");
    bridge.on(5);
    bridge.report(ReportCode::shackles_in_pipe, 6); // 5 m are out
    bridge.on(30);
    bridge.chain().cable_out = 2 * 27.5;
    bridge.report(ReportCode::shackles_in_pipe, 2);
    bridge.on(30);
    bridge.chain().cable_out = 3 * 27.5;
    bridge.report(ReportCode::shackles_in_pipe, 3);
    bridge.on(1);
    EXPECT_EQ(bridge.mark().milli, 500);
}

TEST(Bridge, HasAWrongRepeatPutRight) {
    Bridge bridge(kPayOut);
    bridge.on(5, BridgeOrderState::misrepeated);
    ASSERT_GE(bridge.said.size(), 2U);
    EXPECT_EQ(bridge.said[1].code, BridgeOrderCode::pay_out);
    EXPECT_EQ(bridge.said[1].text, "that is wrong; I say again");
    bridge.on(30, BridgeOrderState::misrepeated);
    EXPECT_TRUE(bridge.now().finished) << "nobody goes on with a man who does not hear what is said";
}

// Silence is answered late, however soon after it was asked a second time; a wrong word that is put right is
// not.
TEST(Bridge, CountsARepeatFromWhenItFirstGaveTheOrder) {
    const auto reason = [](BridgeOrderState first) {
        Bridge bridge(kPayOut);
        bridge.on(1.5, first);
        bridge.on(40, BridgeOrderState::repeated); // each that is given from now on, at once
        EXPECT_GE(bridge.said.size(), 2U);
        bridge.end();
        return bridge.mark().reason;
    };
    const std::string silent = reason(BridgeOrderState::not_repeated),
                      wrong = reason(BridgeOrderState::misrepeated);
    EXPECT_NE(silent.find("repeated back after"), std::string::npos) << silent;
    EXPECT_NE(wrong.find("repeated back wrongly"), std::string::npos) << wrong;
    EXPECT_EQ(wrong.find("repeated back after"), std::string::npos) << wrong;
}

// Between the order that it gives again and the next wrong repeat it has not been understood either.
TEST(Bridge, DoesNotGoOnFromAnOrderThatWasMisunderstood) {
    Bridge bridge(kPayOut);
    bridge.on(2, BridgeOrderState::misrepeated);
    bridge.on(2, BridgeOrderState::given);
    ASSERT_EQ(bridge.said.size(), 2U);
    bridge.report(ReportCode::shackles_in_pipe, 2); // it is done all the same
    bridge.on(4, BridgeOrderState::given);
    EXPECT_EQ(bridge.said.size(), 2U);
}

TEST(Bridge, AsksForTheReportThatItWaitsFor) {
    Bridge bridge(R"({"id": "T", "patience": 60, "orders": [
        {"id": "clear", "code": "stand_clear", "when": {"time": 1}},
        {"id": "secure", "code": "secure", "when": {"report": "brought_up", "ship_speed": {"below": 0.2}}}],
      "criteria": [{"id": "o", "kind": "order", "orders": ["clear", "secure"]}], "end": {"time": 3000}})");
    bridge.report(ReportCode::brought_up); // of what, before anything was ordered?
    bridge.on(40);
    EXPECT_EQ(bridge.said.size(), 1U);
    bridge.on(40);
    ASSERT_EQ(bridge.said.size(), 2U);
    EXPECT_EQ(bridge.said[1].code, BridgeOrderCode::brought_up);
    bridge.report(ReportCode::brought_up);
    bridge.on(1);
    ASSERT_EQ(bridge.said.size(), 3U);
    EXPECT_EQ(bridge.said[2].code, BridgeOrderCode::secure);
}

// Two hands are told at once, and what follows hangs on both: the one who says nothing is asked.
TEST(Bridge, AsksNothingWhileMenForwardAreAtTheirWork) {
    Bridge bridge(kPayOut);
    exercise::DeckWorkView& men = bridge.seen().tackle[0].deck_work;
    men = {.set = exercise::DeckWork::clear_anchor, .left = 480};
    bridge.on(480);
    EXPECT_EQ(bridge.said.size(), 1U); // the order alone
    men.left = 0;
    bridge.on(29); // as long as after a word of theirs
    EXPECT_EQ(bridge.said.size(), 1U);
    bridge.on(2);
    EXPECT_EQ(bridge.said.size(), 2U);
}

TEST(Bridge, AsksWhatMenForwardWaitForWhoCannotGoOn) {
    Bridge bridge(kPayOut);
    bridge.seen().tackle[0].deck_work = {
        .set = exercise::DeckWork::clear_anchor, .left = 480, .waits = words::DeckHindrance::stopper_off};
    bridge.on(120);
    EXPECT_GT(bridge.said.size(), 1U);
}

TEST(Bridge, ThatGaveUpOverAQuestionOfItsOwnSaysWhich) {
    Bridge bridge(R"({"id": "T", "patience": 60, "orders": [
        {"id": "leading", "code": "how_leading", "when": {"time": 1}},
        {"id": "secure", "code": "secure", "when": {"report": "brought_up"}}],
      "criteria": [{"id": "o", "kind": "order", "orders": ["leading", "secure"]}], "end": {"time": 3000}})");
    bridge.on(5);
    bridge.report({.code = ReportCode::lead, .side = 0, .lead = 12});
    bridge.on(600);
    EXPECT_TRUE(bridge.now().finished);
    EXPECT_EQ(bridge.now().abort, "the bridge had no answer to \"is she brought up?\"");
}

namespace {

/// What comes next hangs on a report for which the bridge has no question: it asks how much cable is out.
std::string waits_to_secure(int patience) {
    return R"({"id": "T", "patience": )" + std::to_string(patience) + R"(, "orders": [
    {"id": "clear", "code": "stand_clear", "when": {"time": 1}},
    {"id": "secure", "code": "secure", "when": {"report": "clear_anchor"}}],
  "criteria": [{"id": "o", "kind": "order", "orders": ["clear", "secure"]}], "end": {"time": 3000}})";
}
const std::string kWaitsToSecure = waits_to_secure(60);

} // namespace

// With L04's patience: it knows that there is somebody who speaks, and need not wait for him as for a silent
// man. However often he says it.
TEST(Bridge, TakesWhatIsNotSoForNoAnswerAsksAgainSoonAndGivesUp) {
    for (const double says_it_every : {1e9, 10.0}) { // s
        Bridge bridge(waits_to_secure(240));
        bridge.chain().cable_out = 60;
        std::vector<double> asked;  // at s
        std::int64_t foretold = -1; // tick
        double said_at = 0;
        while (!bridge.now().finished && bridge.seen().time < 1500) {
            const std::size_t before = bridge.said.size();
            bridge.on(1);
            const bool asks = bridge.said.size() > std::max<std::size_t>(before, 1);
            if (asks) asked.push_back(bridge.seen().time);
            if (asks || (!asked.empty() && bridge.seen().time - said_at > says_it_every)) {
                bridge.report(ReportCode::shackles_in_pipe, 1); // two and more are out
                said_at = bridge.seen().time;
            }
            const std::int64_t at = gives_up_at(bridge.taught(), bridge.state(), kRate);
            if (at >= 0) foretold = at;
        }
        ASSERT_EQ(asked.size(), 3U) << says_it_every;
        ASSERT_EQ(bridge.said.size(), 4U);
        EXPECT_EQ(bridge.said[1].text, "");
        const std::string doubts = "that does not agree with my reckoning; look again and report";
        EXPECT_EQ(bridge.said[2].text, doubts);
        EXPECT_EQ(bridge.said[3].text, doubts + "; I send a man forward to look");
        EXPECT_NEAR(asked[0], 241, 2);
        EXPECT_NEAR(asked[1] - asked[0], 31, 2);
        EXPECT_NEAR(asked[2] - asked[1], 31, 2);
        ASSERT_TRUE(bridge.now().finished);
        EXPECT_NEAR(bridge.seen().time - asked[2], 31, 2) << "5 minutes and a half after the last true word";
        EXPECT_EQ(foretold, bridge.state().ended);
        EXPECT_EQ(bridge.now().ending, Ending::time);
        EXPECT_EQ(bridge.now().abort,
                  "the bridge was told what is not so when it asked \"how much port cable is out?\"");
        EXPECT_TRUE(was_told_falsely(bridge.taught(), bridge.state()));
    }
}

TEST(Bridge, IsAsPatientAgainWithHimWhoFellSilentAfterWhatIsNotSo) {
    Bridge bridge(waits_to_secure(240));
    bridge.chain().cable_out = 60;
    bridge.on(243);
    ASSERT_EQ(bridge.said.size(), 2U);
    bridge.report(ReportCode::shackles_in_pipe, 1);
    bridge.on(1);
    const std::int64_t foretold = gives_up_at(bridge.taught(), bridge.state(), kRate);
    bridge.on(31);
    ASSERT_EQ(bridge.said.size(), 3U);
    bridge.on(238);
    EXPECT_EQ(bridge.said.size(), 3U);
    bridge.on(3);
    EXPECT_EQ(bridge.said.size(), 4U);
    bridge.on(300);
    ASSERT_TRUE(bridge.now().finished);
    EXPECT_EQ(bridge.state().ended, foretold);
}

TEST(Bridge, IsContentWithAWordThatPutsAFalseOneRight) {
    Bridge bridge(kWaitsToSecure);
    bridge.chain().cable_out = 60;
    for (int round = 0; round < 4; ++round) {
        bridge.on(62);
        bridge.report(ReportCode::shackles_in_pipe, 1);
        bridge.on(5);
        EXPECT_EQ(bridge.state().asked, 1) << "as if he had said nothing";
        bridge.report(ReportCode::shackles_in_pipe, 2.2);
        bridge.on(1);
        EXPECT_EQ(bridge.state().asked, 0);
    }
    EXPECT_FALSE(bridge.now().finished);
}

namespace {

const std::string kNoGuesses = "do not guess; look again, and report what you see";

} // namespace

// The first figure is his answer and a second one puts it right. Of who goes on until one is taken the bridge
// takes none, be it right, before it has asked again.
TEST(Bridge, TakesNoThirdFigureOfWhoTriesThem) {
    Bridge bridge(waits_to_secure(240));
    bridge.chain().cable_out = 60; // 2.2 in the pipe
    bridge.on(243);
    ASSERT_EQ(bridge.said.size(), 2U);
    for (const double shackles : {5.0, 4.5, 2.0}) {
        bridge.report(ReportCode::shackles_in_pipe, shackles);
        bridge.on(0.5);
    }
    EXPECT_EQ(bridge.state().asked, 1) << "what he hit on is no answer";
    bridge.on(2);
    ASSERT_EQ(bridge.said.size(), 3U) << "and is told so at once";
    EXPECT_EQ(bridge.said[2].code, BridgeOrderCode::how_much);
    EXPECT_EQ(bridge.said[2].text, kNoGuesses);
    bridge.report(ReportCode::shackles_in_pipe, 2.2); // he has looked
    bridge.on(1);
    EXPECT_EQ(bridge.state().asked, 0);
    EXPECT_FALSE(bridge.now().finished);
}

TEST(Bridge, SendsAManForwardWhereOneGoesOnToTryFigures) {
    Bridge bridge(waits_to_secure(240));
    bridge.chain().cable_out = 60;
    bridge.on(243);
    double figure = 12;
    std::int64_t foretold = -1;
    while (!bridge.now().finished && bridge.seen().time < 400) {
        if (figure > 4) bridge.report(ReportCode::shackles_in_pipe, figure -= 0.5);
        bridge.on(1);
        const std::int64_t at = gives_up_at(bridge.taught(), bridge.state(), kRate);
        if (at >= 0) foretold = at;
    }
    ASSERT_EQ(bridge.said.size(), 4U);
    EXPECT_EQ(bridge.said[2].text, kNoGuesses);
    EXPECT_EQ(bridge.said[3].text, kNoGuesses + "; I send a man forward to look");
    EXPECT_LT(bridge.seen().time, 260);
    EXPECT_EQ(foretold, bridge.state().ended);
    EXPECT_EQ(bridge.now().abort,
              "the bridge was told what is not so when it asked \"how much port cable is out?\"");
}

// An order to a length is answered by what is heard; not by what is tried.
TEST(Bridge, GoesOnFromNoLengthThatWasTried) {
    Bridge bridge(kPayOut);
    bridge.chain().cable_out = 3 * 27.5;
    bridge.on(65);
    ASSERT_EQ(bridge.said.size(), 2U);
    ASSERT_EQ(bridge.said[1].code, BridgeOrderCode::how_much);
    for (const double shackles : {0.5, 1.0, 2.0}) {
        bridge.report(ReportCode::shackles_in_pipe, shackles);
        bridge.on(0.5);
    }
    bridge.on(12);
    ASSERT_EQ(bridge.said.size(), 3U);
    EXPECT_EQ(bridge.said[2].code, BridgeOrderCode::how_much);
    EXPECT_EQ(bridge.said[2].text, kNoGuesses);
    bridge.report(ReportCode::shackles_in_pipe, 3);
    bridge.on(1);
    ASSERT_EQ(bridge.said.size(), 4U);
    EXPECT_EQ(bridge.said[3].code, BridgeOrderCode::secure) << "three are reported";
}

// Each was so as it was said.
TEST(Bridge, TakesFiguresThatRiseAsTheCableRuns) {
    Bridge bridge(kPayOut);
    bridge.on(65);
    ASSERT_EQ(bridge.said.back().code, BridgeOrderCode::how_much);
    for (const double shackles : {0.5, 1.0, 1.5, 2.0}) {
        bridge.chain().cable_out = shackles * 27.5;
        bridge.report(ReportCode::shackles_in_pipe, shackles);
        bridge.on(2);
    }
    ASSERT_EQ(bridge.said.size(), 3U);
    EXPECT_EQ(bridge.said[2].code, BridgeOrderCode::pay_out);
    EXPECT_EQ(bridge.said[2].value, 3);
}

// He lied once and fell silent: in the end it waits for an answer, and there is none.
TEST(Bridge, ThatHadNoAnswerInTheEndWasNotToldWhatIsNotSo) {
    Bridge bridge(kWaitsToSecure);
    bridge.chain().cable_out = 60;
    bridge.on(62);
    bridge.report(ReportCode::shackles_in_pipe, 1);
    bridge.on(600);
    ASSERT_TRUE(bridge.now().finished);
    ASSERT_EQ(bridge.said.size(), 4U);
    EXPECT_EQ(bridge.said[2].text, "that does not agree with my reckoning; look again and report");
    EXPECT_EQ(bridge.said[3].text, "this is my last call, then I send another man forward");
    EXPECT_EQ(bridge.now().abort, "the bridge had no answer to \"how much port cable is out?\"");
    EXPECT_FALSE(was_told_falsely(bridge.taught(), bridge.state()));
}

// What is short of the order is ordered again, and asked for again, only so often as he who tells it lies.
TEST(Bridge, GivesUpOnHimWhoTellsOfLessThanIsOut) {
    Bridge bridge(kPayOut);
    bridge.chain().cable_out = 3 * 27.5;
    std::size_t heard = 0;
    for (int k = 0; k < 600 && !bridge.now().finished; ++k) {
        bridge.on(1);
        if (bridge.said.size() == heard) continue;
        heard = bridge.said.size();
        if (bridge.said.back().code == BridgeOrderCode::how_much)
            bridge.report(ReportCode::shackles_in_pipe, 1);
    }
    EXPECT_TRUE(bridge.now().finished);
    EXPECT_LE(bridge.said.size(), 4U);
}

TEST(Bridge, AsksHimWhoHasNotAnsweredThoughAnotherHas) {
    Bridge bridge(R"({"id": "T", "patience": 60, "orders": [
        {"id": "port", "code": "hold_on", "value": 4, "side": "port", "when": {"time": 1}},
        {"id": "starboard", "code": "gear_in", "side": "starboard", "when": {"given": "port"}},
        {"id": "secure", "code": "secure", "when": {"answered": ["port", "starboard"]}}],
      "criteria": [{"id": "o", "kind": "order", "orders": ["port", "starboard", "secure"]}],
      "end": {"time": 3000}})");
    bridge.on(10);
    bridge.report({.code = ReportCode::standing_by, .side = 1});
    bridge.on(55);
    ASSERT_EQ(bridge.said.size(), 3U);
    EXPECT_EQ(bridge.said[2].code, BridgeOrderCode::how_much);
    EXPECT_EQ(bridge.said[2].side, 0);
    bridge.on(100);
    EXPECT_TRUE(bridge.now().finished);
    EXPECT_EQ(bridge.now().abort,
              "the bridge had no answer to \"hold on port cable at 4 shackles in the pipe\"");
}

namespace {

/// An order that is unsafe in a wind, two that hang on it, and one that does not.
const std::string kHeave = R"({"id": "T", "patience": 60, "orders": [
    {"id": "heave", "code": "heave", "when": {"time": 1}, "unsafe": {"cable_out": 50}},
    {"id": "weight", "code": "how_much_weight", "when": {"answered": "heave"}},
    {"id": "stop", "code": "stop_heaving"},
    {"id": "secure", "code": "secure", "text": "wait for the engine", "when": {"either": ["refused", "told"]}}],
  "states": {"refused": {"challenged": "heave", "since": 5}, "told": {"answered": "stop"}},
  "criteria": [{"id": "o", "kind": "order", "orders": ["heave", "weight", "stop", "secure"]}],
  "end": {"good": {"answered": "secure"}, "time": 3000}})";

exercise::ReportMade unsafe(BridgeOrderCode proposed = BridgeOrderCode::text, int side = 0, int number = 0) {
    return {.code = ReportCode::unsafe, .side = side, .order_number = number, .order_code = proposed};
}

} // namespace

TEST(Bridge, TakesBackWhatIsUnsafeAndOrdersWhatIsProposed) {
    Bridge bridge(kHeave);
    bridge.chain().cable_out = 60;
    bridge.on(5);
    bridge.report(unsafe(BridgeOrderCode::secure));
    bridge.on(1);
    EXPECT_EQ(bridge.said.size(), 1U) << "nobody answers before he has heard it out";
    bridge.on(20);
    ASSERT_EQ(bridge.said.size(), 3U);
    EXPECT_EQ(bridge.said[1].code, BridgeOrderCode::cancel);
    EXPECT_EQ(bridge.said[1].cancels, 1);
    EXPECT_EQ(bridge.said[2].code, BridgeOrderCode::secure);
    EXPECT_EQ(bridge.said[2].text, "wait for the engine") << "the lesson's own words for it";
    bridge.secure();
    bridge.on(2);
    bridge.report(ReportCode::secured);
    bridge.on(1);
    EXPECT_EQ(bridge.now().ending, Ending::good);
    EXPECT_EQ(bridge.said.size(), 3U) << "what hangs on the order that was taken back is not given";
}

TEST(Bridge, OrdersWhatTheLessonHasNotWhenThatIsProposed) {
    Bridge bridge(kHeave);
    bridge.chain().cable_out = 60;
    bridge.on(5);
    bridge.report(
        {.code = ReportCode::unsafe, .side = 0, .value = 3, .order_code = BridgeOrderCode::hold_on});
    bridge.on(3);
    ASSERT_EQ(bridge.said.size(), 3U);
    EXPECT_EQ(bridge.said[2].code, BridgeOrderCode::hold_on);
    EXPECT_EQ(bridge.said[2].value, 3);
    EXPECT_EQ(bridge.said[2].text, "as you propose");
}

TEST(Bridge, GoesOnByTheLessonWhereNothingIsProposed) {
    Bridge bridge(kHeave);
    bridge.chain().cable_out = 60;
    bridge.on(5);
    bridge.report(unsafe());
    bridge.on(3);
    ASSERT_EQ(bridge.said.size(), 2U);
    EXPECT_EQ(bridge.said[1].code, BridgeOrderCode::cancel);
    bridge.on(6);
    ASSERT_EQ(bridge.said.size(), 3U);
    EXPECT_EQ(bridge.said[2].code, BridgeOrderCode::secure);
}

// A bridge that was told why the cable stands, and asks how much is out as if it had not been, is deaf.
TEST(Bridge, SaysWhatFaultItHasHeardOfWhenItAsksNext) {
    Bridge bridge(kPayOut);
    bridge.on(30);
    bridge.report(ReportCode::no_power);
    bridge.on(40);
    ASSERT_EQ(bridge.said.size(), 2U);
    EXPECT_EQ(bridge.said[1].code, BridgeOrderCode::how_much);
    EXPECT_EQ(bridge.said[1].text, "understood, no power on windlass");
    bridge.on(31);
    ASSERT_EQ(bridge.said.size(), 3U);
    EXPECT_EQ(bridge.said[2].text, "") << "once";

    Bridge heaving(kHeave);
    heaving.on(30);
    heaving.report(ReportCode::does_not_run);
    heaving.on(60);
    ASSERT_EQ(heaving.said.size(), 2U);
    EXPECT_EQ(heaving.said[1].text,
              "understood, cable does not run; I say again; report \"heaving\" when it is so");
}

TEST(Bridge, InsistsOnAnOrderThatIsSafe) {
    Bridge bridge(kHeave); // 5 m of cable
    bridge.on(5);
    bridge.report(unsafe(BridgeOrderCode::secure));
    bridge.on(3);
    ASSERT_EQ(bridge.said.size(), 2U);
    EXPECT_EQ(bridge.said[1].code, BridgeOrderCode::heave);
    EXPECT_EQ(bridge.said[1].text, "that is safe; carry it out");
    bridge.report(ReportCode::heaving);
    bridge.on(1);
    ASSERT_EQ(bridge.said.size(), 3U);
    EXPECT_EQ(bridge.said[2].code, BridgeOrderCode::how_much_weight);
}

TEST(Bridge, GivesUpOnHimWhoRefusesWhatIsSafe) {
    Bridge bridge(kHeave);
    bridge.on(5);
    for (int k = 0; k < 4; ++k) {
        bridge.report(unsafe(BridgeOrderCode::secure));
        bridge.on(3);
    }
    EXPECT_TRUE(bridge.now().finished);
    EXPECT_EQ(bridge.now().abort, "the bridge heard no \"heaving\" after \"heave up port anchor\"");
}

// He did as he was told and said nothing of it: of what words are to show, nothing is.
TEST(Bridge, ThatGaveUpLeavesNothingAchievedThatOrdersOrReportsShow) {
    Bridge bridge(
        R"({"id": "T", "patience": 60, "objectives": [{"id": "words", "text": "Speaks"}], "orders": [
        {"id": "two", "code": "pay_out", "value": 2, "when": {"time": 1}},
        {"id": "three", "code": "pay_out", "value": 3}],
      "criteria": [{"id": "o", "kind": "order", "orders": ["two", "three"], "objective": "words"}],
      "end": {"good": {"answered": "three"}, "time": 3000}})");
    bridge.chain().cable_out = 2 * 27.5;
    bridge.on(600);
    ASSERT_TRUE(bridge.now().finished);
    EXPECT_NE(bridge.now().abort.find("no answer to"), std::string::npos) << bridge.now().abort;
    EXPECT_GE(bridge.now().criteria[0].milli, 500) << "the order was carried out";
    EXPECT_EQ(bridge.now().objectives[0].outcome, Outcome::not_yet);
}

// He means the last order that he was given, and none of another side; a question is nothing unsafe.
TEST(Bridge, KnowsWhichOrderIsCalledUnsafe) {
    Bridge other(kHeave);
    other.chain().cable_out = 60;
    other.on(5);
    other.report(unsafe(BridgeOrderCode::secure, 1));
    other.report(unsafe(BridgeOrderCode::secure, 0, 7));
    other.on(5);
    EXPECT_EQ(other.said.size(), 1U) << "starboard's, and the seventh order's";
    other.report(ReportCode::heaving);
    other.on(2);
    ASSERT_EQ(other.said.size(), 2U) << "how much weight?";
    other.report(unsafe());
    other.on(3);
    ASSERT_EQ(other.said.size(), 3U);
    EXPECT_EQ(other.said[2].cancels, 1);
}

// What was taken back is nobody's to carry out.
TEST(Bridge, MarksNoOrderThatItTookBack) {
    Bridge bridge(kHeave);
    bridge.chain().cable_out = 60;
    bridge.on(5);
    bridge.report(unsafe());
    bridge.on(3);
    bridge.on(100);
    bridge.end();
    EXPECT_EQ(bridge.mark().reason.find("heave"), std::string::npos) << bridge.mark().reason;
}

// A bridge with men on it answers by itself: what they take back was challenged.
TEST(Bridge, ThatIsMannedIsHeardWhenItTakesBackWhatIsUnsafe) {
    std::string manned = kHeave;
    manned.insert(manned.find("\"patience\""), "\"bridge\": \"manned\", ");
    Bridge bridge(manned);
    bridge.seen().bridge_orders.push_back({.number = 1,
                                           .given = {.code = BridgeOrderCode::heave, .side = 0},
                                           .state = BridgeOrderState::repeated});
    bridge.on(1);
    bridge.report(unsafe());
    bridge.on(1);
    EXPECT_LT(bridge.state().orders[0].challenged, 0);
    bridge.seen().bridge_orders[0].state = BridgeOrderState::cancelled;
    bridge.on(1);
    EXPECT_GE(bridge.state().orders[0].challenged, 0);
    EXPECT_TRUE(bridge.said.empty());
}

namespace {

/// A bridge with a man on it, whose lengths the lesson leaves to him.
class Manned : public Bridge {
public:
    Manned()
        : Bridge(R"({"id": "T", "bridge": "manned", "orders": [{"id": "pay-out", "code": "pay_out"}],
            "criteria": [{"id": "o", "kind": "order", "orders": "pay-out"}], "end": {"time": 3000}})") {}
    void order(BridgeOrderCode code, double value = 0) {
        auto& all = seen().bridge_orders;
        all.push_back({.number = static_cast<int>(all.size()) + 1,
                       .tick = seen().tick,
                       .time = seen().time,
                       .given = {.code = code, .side = 0, .value = value},
                       .state = BridgeOrderState::repeated});
        on(5);
    }
    /// Whether the order in that place of the list is carried out.
    bool is_done(std::size_t place) const { return now().orders.at(place).tick > 0; }
};

} // namespace

TEST(Bridge, ThatIsMannedHasPaidOutWhatItOrderedOnceTheCableStandsThere) {
    Manned bridge;
    bridge.order(BridgeOrderCode::pay_out, 4);
    ASSERT_EQ(bridge.now().orders.size(), 1U);
    EXPECT_FALSE(bridge.is_done(0)) << "the cable stands, and not there";
    bridge.chain().cable_out = 4 * 27.5;
    bridge.on(5);
    EXPECT_TRUE(bridge.is_done(0));
    bridge.order(BridgeOrderCode::pay_out, 6);
    ASSERT_EQ(bridge.now().orders.size(), 2U) << "of which the lesson knows one";
    EXPECT_FALSE(bridge.is_done(1));
    bridge.chain().cable_out = 6 * 27.5;
    bridge.on(5);
    EXPECT_TRUE(bridge.is_done(1));
}

// The lesson's own order of the kind goes on with the next of them.
TEST(Bridge, ThatIsMannedAndTakesAnOrderBackHasItCarriedOutByNobody) {
    Manned bridge;
    bridge.order(BridgeOrderCode::pay_out, 4);
    bridge.seen().bridge_orders[0].state = BridgeOrderState::cancelled;
    bridge.on(1);
    bridge.order(BridgeOrderCode::pay_out, 4);
    bridge.chain().cable_out = 4 * 27.5;
    bridge.on(5);
    ASSERT_EQ(bridge.now().orders.size(), 2U);
    EXPECT_FALSE(bridge.is_done(0));
    EXPECT_TRUE(bridge.is_done(1));
    EXPECT_EQ(bridge.mark().milli, 1000);
    bridge.seen().bridge_orders[1].state = BridgeOrderState::cancelled;
    bridge.on(1);
    EXPECT_TRUE(bridge.is_done(1)) << "it was carried out before";
}

TEST(Bridge, ThatIsMannedHasEachOfItsOrdersInTheListThatAWindlassShowsOrAReportAnswers) {
    Manned bridge;
    bridge.windlass().clutch = exercise::ClutchState::out;
    bridge.order(BridgeOrderCode::gear_in);
    bridge.order(BridgeOrderCode::how_leading);
    bridge.order(BridgeOrderCode::stand_clear);
    ASSERT_EQ(bridge.now().orders.size(), 2U) << "who stands clear no windlass shows";
    EXPECT_EQ(bridge.now().orders[1].number, 2);
    EXPECT_FALSE(bridge.is_done(0));
    EXPECT_FALSE(bridge.is_done(1));
    bridge.windlass().clutch = exercise::ClutchState::in;
    bridge.report(exercise::ReportMade{.code = ReportCode::lead, .side = 0, .lead = 12});
    bridge.on(5);
    EXPECT_TRUE(bridge.is_done(0));
    EXPECT_TRUE(bridge.is_done(1));
}

TEST(Bridge, ThatIsMannedHeavesToAFigureUntilTheCableIsInToIt) {
    Manned bridge;
    bridge.chain().cable_out = 6 * 27.5;
    bridge.windlass().cable_speed = -0.15;
    bridge.order(BridgeOrderCode::heave_to, 2);
    EXPECT_FALSE(bridge.is_done(0)) << "it comes, and is not in";
    bridge.chain().cable_out = 2 * 27.5;
    bridge.windlass().cable_speed = 0;
    bridge.on(5);
    EXPECT_TRUE(bridge.is_done(0));
}

// Walked out in gear it is not let go, however fast it goes.
TEST(Bridge, ThatIsMannedHasAnAnchorLetGoByWhoLetsItGo) {
    Manned bridge;
    bridge.windlass().clutch = exercise::ClutchState::in;
    bridge.windlass().cable_speed = 0.24;
    bridge.order(BridgeOrderCode::let_go);
    ASSERT_EQ(bridge.now().orders.size(), 1U);
    EXPECT_FALSE(bridge.is_done(0));
    bridge.windlass().clutch = exercise::ClutchState::out;
    bridge.on(5);
    EXPECT_TRUE(bridge.is_done(0));
}

namespace {

/// L18, whose cable is fast in the spurling pipe: cleared away and walked out in gear, brake hard on,
/// "standing by" said, and the order to let go given.
class Stuck : public Bridge {
public:
    Stuck() : Bridge(read_json(WINDLASS_CONFIG_DIR "/exercises/L18_stuck.json").at("lesson").dump()) {
        windlass().brake_position = 0;
        windlass().clutch = exercise::ClutchState::in;
        chain().cable_out = 7.8;
        on(6);
        event("spurling_pipe.fast"); // at an earlier try
        on(1);
        windlass().brake_position = 1;
        on(2);
        report(ReportCode::standing_by);
        on(11);
    }
    /// What the criterion has earned, thousandths.
    int earned(const std::string& code) const {
        const Result all = now();
        const auto found = std::ranges::find(all.criteria, code, &CriterionResult::code);
        return found == all.criteria.end() ? -1 : found->milli;
    }
};

} // namespace

TEST(Bridge, ThatHearsOfCableThatNobodyTriedToLetGoHearsNothingThatIsSo) {
    Stuck lesson;
    ASSERT_FALSE(lesson.said.empty());
    ASSERT_EQ(lesson.said.back().code, BridgeOrderCode::let_go);
    lesson.report(ReportCode::does_not_run);
    lesson.on(40);
    lesson.end();
    EXPECT_EQ(lesson.earned("brake"), 0);
    EXPECT_EQ(lesson.earned("report"), 0);
}

// From when nothing ran, and not from when the bridge ordered it.
TEST(Bridge, HearsInTimeOfCableThatStoodWhenItWasLetGo) {
    Stuck lesson;
    lesson.windlass().clutch = exercise::ClutchState::out;
    lesson.on(60); // the brake stays on
    EXPECT_EQ(lesson.earned("brake"), 0);
    lesson.windlass().brake_position = 0;
    lesson.on(10);
    lesson.windlass().brake_position = 1;
    lesson.report(ReportCode::does_not_run);
    lesson.on(20);
    EXPECT_EQ(lesson.earned("brake"), 1000);
    EXPECT_EQ(lesson.earned("report"), 1000);
}

TEST(Bridge, ThatIsMannedSaysNothingByItself) {
    std::string manned = kPayOut;
    manned.insert(manned.find("\"patience\""), "\"bridge\": \"manned\", ");
    Bridge bridge(manned);
    bridge.on(600);
    EXPECT_TRUE(bridge.said.empty());
    EXPECT_FALSE(bridge.now().finished);
}

// "Ready when it hangs", says its briefing: with the anchor in the pipe it is not, and two metres are no
// walk.
TEST(Bridge, OfL02HearsReadyOnceTheAnchorHangsAndStandingByOnceItIsClearedAway) {
    const std::string text =
        read_json(WINDLASS_CONFIG_DIR "/exercises/L02_lower_and_let_go.json").at("lesson").dump();
    /// Whether the stopper is off as he says "standing by", and how much is out as he says "ready".
    const auto played = [&](bool stopper_off, double cable_out) {
        Bridge bridge(text);
        exercise::AnchorView& anchor = bridge.seen().tackle[0].anchor;
        anchor.height_above_bottom = 38;
        bridge.windlass().brake_position = 1;
        bridge.windlass().clutch = exercise::ClutchState::in;
        bridge.windlass().stopper_closed = !stopper_off;
        bridge.on(6);
        bridge.report(ReportCode::standing_by);
        bridge.on(7);
        bridge.windlass().stopper_closed = false;
        EXPECT_EQ(bridge.said.back().code, BridgeOrderCode::walk_out);
        bridge.chain().cable_out = cable_out;
        anchor.height_above_bottom = 43 - cable_out;
        bridge.on(2);
        bridge.report(ReportCode::anchor_ready);
        bridge.on(6);
        bridge.end();
        std::map<std::string, CriterionResult> marks;
        for (const CriterionResult& one : bridge.now().criteria)
            marks[one.code] = one;
        return marks;
    };
    auto right = played(true, 33);
    EXPECT_EQ(right["stands-by"].milli, 1000) << right["stands-by"].reason;
    EXPECT_EQ(right["ready"].milli, 1000) << right["ready"].reason;
    EXPECT_EQ(right["walked"].milli, 1000) << right["walked"].reason;
    auto in_the_pipe = played(false, 2);
    EXPECT_EQ(in_the_pipe["stands-by"].milli, 0);
    EXPECT_EQ(in_the_pipe["ready"].milli, 0);
    EXPECT_EQ(in_the_pipe["walked"].state, CriterionState::not_in_play);
}

// With one pump of two she walks on at half her speed: that is a defect, and no loss of power.
TEST(Bridge, OfL14HearsOfADefectAtHalfPowerAndOfNoPowerOnceThereIsNone) {
    std::ifstream file(WINDLASS_CONFIG_DIR "/exercises/L14_hydraulic_loss.json");
    const std::string text = nlohmann::json::parse(file).at("lesson").dump();
    struct Outcomes {
        std::int64_t secures = 0;
        std::size_t reports = 0;
        CriterionResult defect, no_power;
    };
    /// What he says at half speed, whether he stops then, and what he says once the power is gone.
    const auto walked = [&](ReportCode at_half, bool stops, ReportCode at_last) {
        Bridge bridge(text);
        const auto walks = [&](double from, double speed) {
            bridge.chain().cable_out = from;
            bridge.windlass().cable_speed = speed;
        };
        bridge.on(10);
        walks(79, 0.25);
        bridge.on(10);
        walks(81, 0.12);
        bridge.event("fault.active"); // one pump of two
        bridge.on(20);
        if (at_half != ReportCode::text) bridge.report(at_half);
        bridge.on(30);
        if (stops) {
            walks(85, 0);
        } else {
            walks(101, 0);
            bridge.event("fault.active"); // the hose
            bridge.on(5);
            if (at_last != ReportCode::text) bridge.report(at_last);
        }
        bridge.on(30);
        bridge.end();
        const Result result = bridge.now();
        Outcomes come{.secures = std::ranges::count(bridge.said, BridgeOrderCode::secure,
                                                    &exercise::BridgeOrderGiven::code),
                      .reports = result.reports.size(),
                      .defect = {},
                      .no_power = {}};
        for (const CriterionResult& one : result.criteria) {
            if (one.code == "defect") come.defect = one;
            if (one.code == "report") come.no_power = one;
        }
        return come;
    };
    const Outcomes both = walked(ReportCode::defect, false, ReportCode::no_power);
    EXPECT_EQ(both.defect.milli, 1000) << both.defect.reason;
    EXPECT_EQ(both.no_power.milli, 1000) << both.no_power.reason;
    EXPECT_EQ(both.reports, 2U) << "and he reads of both";
    EXPECT_EQ(both.secures, 1);

    const Outcomes stopped = walked(ReportCode::defect, true, ReportCode::text);
    EXPECT_EQ(stopped.defect.milli, 1000);
    EXPECT_EQ(stopped.no_power.state, CriterionState::not_in_play) << "there always was some";
    EXPECT_EQ(stopped.secures, 1) << "the bridge answers who tells of a defect, and stands";

    const Outcomes untrue = walked(ReportCode::no_power, false, ReportCode::text);
    EXPECT_EQ(untrue.no_power.milli, 0) << "half of it was left: " << untrue.no_power.reason;
    EXPECT_EQ(untrue.defect.milli, 0);
    EXPECT_EQ(walked(ReportCode::text, false, ReportCode::text).secures, 0)
        << "who says nothing hears nothing";
}

namespace {

/// A shipped lesson over made pictures.
class Shipped : public Bridge {
public:
    explicit Shipped(const std::string& file)
        : Bridge(read_json(WINDLASS_CONFIG_DIR "/exercises/" + file).at("lesson").dump()) {}
    void pulls(double speed, double newton) {
        windlass().cable_speed = speed;
        windlass().gypsy_load = windlass().motor_load = newton;
    }
    CriterionResult of(const std::string& code) const {
        const Result all = now();
        const auto found = std::ranges::find(all.criteria, code, &CriterionResult::code);
        return found == all.criteria.end() ? CriterionResult() : *found;
    }
};

} // namespace

// The weight is taken against the closed bar, the motor trips, all is made fast: nothing has come too heavy.
TEST(Bridge, OfA6KnowsNoLoadThatRoseAgainstTheClosedBar) {
    Shipped lesson("A06_clutch_mars_201410.json");
    lesson.windlass().stopper_closed = true;
    lesson.windlass().brake_position = 1;
    lesson.on(6);
    lesson.windlass().clutch = exercise::ClutchState::in;
    lesson.report(ReportCode::standing_by);
    lesson.on(8);
    ASSERT_EQ(lesson.said.back().code, BridgeOrderCode::heave);
    lesson.windlass().speed_lever = 0.15;
    lesson.windlass().brake_position = 0;
    lesson.pulls(-0.06, 155e3);
    lesson.on(3);
    lesson.pulls(0, 151e3);
    lesson.on(40);
    lesson.windlass().tripped = true;
    lesson.on(5);
    lesson.windlass().speed_lever = 0;
    lesson.windlass().brake_position = 1;
    lesson.report(ReportCode::no_power);
    lesson.on(5);
    EXPECT_EQ(lesson.of("told").state, CriterionState::not_in_play);
    EXPECT_EQ(lesson.of("steps").state, CriterionState::not_in_play);
    EXPECT_EQ(lesson.of("trip").state, CriterionState::not_met);
    EXPECT_EQ(lesson.of("trip-told").milli, 1000) << lesson.of("trip-told").reason;
    lesson.windlass().tripped = lesson.windlass().stopper_closed = false;
    lesson.windlass().brake_position = 0;
    lesson.windlass().speed_lever = 0.4;
    lesson.pulls(-0.15, 155e3);
    lesson.on(0.5); // as she starts to move
    lesson.pulls(-0.15, 130e3);
    lesson.on(20);
    EXPECT_EQ(lesson.of("told").state, CriterionState::not_in_play);
    lesson.pulls(-0.15, 160e3);
    lesson.on(3);
    EXPECT_EQ(lesson.of("told").state, CriterionState::open);
    lesson.windlass().speed_lever = 0;
    lesson.pulls(0, 160e3);
    lesson.windlass().stopper_closed = true; // and the brake, in whatever order
    lesson.on(2);
    lesson.windlass().brake_position = 1;
    lesson.on(2);
    lesson.windlass().clutch = exercise::ClutchState::out;
    lesson.report(ReportCode::defect);
    lesson.on(1);
    EXPECT_EQ(lesson.of("steps").milli, 1000) << lesson.of("steps").reason;
    EXPECT_EQ(lesson.of("told").milli, 1000) << lesson.of("told").reason;
}

TEST(Bridge, OfL08HasTheHandStandByAtOnceAndAHeaveWithoutAnOrderLosesByName) {
    Shipped lesson("L08_weigh_in_a_gale.json");
    lesson.seen().lights_and_shapes.anchor_ball = true;
    lesson.chain().cable_out = 165;
    lesson.windlass().brake_position = 1;
    lesson.on(15);
    ASSERT_FALSE(lesson.said.empty());
    EXPECT_EQ(lesson.said.front().code, BridgeOrderCode::stand_by);
    lesson.windlass().clutch = exercise::ClutchState::in;
    lesson.windlass().brake_position = 0;
    lesson.windlass().speed_lever = 1;
    lesson.pulls(-0.2, 500e3);
    lesson.on(5);
    EXPECT_EQ(lesson.of("ordered").state, CriterionState::open) << "the weight may be taken";
    lesson.on(10);
    EXPECT_EQ(lesson.of("ordered").state, CriterionState::not_met);
    lesson.on(200);
    lesson.end();
    EXPECT_GT(lesson.of("rated").time_outside, 100) << lesson.of("rated").reason;
    EXPECT_LT(lesson.of("rated").milli, 1000);
    EXPECT_EQ(lesson.of("dragged").milli, 1000) << "it has not";
    EXPECT_EQ(lesson.of("ball-up").milli, 1000);
    EXPECT_EQ(lesson.of("ball-down").state, CriterionState::not_in_play) << "she never weighed";
}

} // namespace windlass::assess
