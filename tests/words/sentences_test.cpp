// The sentences that server, stations and recorder share.

#include "words/words.hpp"

#include <gmock/gmock.h>

namespace windlass::words {
namespace {

std::string order(BridgeOrderCode code, int side, double value = 0) {
    return order_text(static_cast<std::size_t>(code), side, value);
}

ReportSaid report(ReportCode code, int side = 0) {
    return {.code = static_cast<std::size_t>(code), .side = side};
}

TEST(Sentences, AnOrderNamesItsSideAndItsFigure) {
    EXPECT_EQ(order(BridgeOrderCode::let_go, 0), "let go port anchor");
    EXPECT_EQ(order(BridgeOrderCode::let_go, -1), "let go both anchors");
    EXPECT_EQ(order(BridgeOrderCode::pay_out, 1, 3), "pay out starboard cable to 3 shackles in the pipe");
    EXPECT_EQ(order(BridgeOrderCode::pay_out, 1, 1), "pay out starboard cable to 1 shackle in the pipe");
    EXPECT_EQ(order(BridgeOrderCode::pay_out, 1, 2.25),
              "pay out starboard cable to 2.25 shackles in the pipe");
    EXPECT_EQ(order(BridgeOrderCode::walk_out, 0, 33), "walk out port anchor to 33 m");
    EXPECT_EQ(order(BridgeOrderCode::hold_on, 0, 6), "hold on port cable at 6 shackles in the pipe");
    EXPECT_EQ(order(BridgeOrderCode::hold_on, 0), "hold on port cable");
    EXPECT_EQ(order(BridgeOrderCode::gear_in, -1), "put both windlasses in gear");
    EXPECT_EQ(order(BridgeOrderCode::how_leading, 0), "how is the port cable leading?");
    EXPECT_EQ(order(BridgeOrderCode::how_much, -1), "how much cable is out?");
    EXPECT_EQ(order(BridgeOrderCode::text, 0), "");
    EXPECT_EQ(order_text(99, 0, 0), "");
}

TEST(Sentences, WhatIsAddedToAQuestionIsASentenceOfItsOwn) {
    EXPECT_EQ(order_with("let go port anchor", "I say again"), "let go port anchor, I say again");
    EXPECT_EQ(order_with("how much cable is out?", "this is my last call"),
              "how much cable is out? This is my last call");
    EXPECT_EQ(order_with("how much cable is out?", ""), "how much cable is out?");
    EXPECT_EQ(order_with("", "stop engine"), "stop engine");
}

TEST(Sentences, AReportSaysWhatWasGivenAndNothingElse) {
    ReportSaid said = report(ReportCode::shackles_on_deck);
    said.value = 3;
    EXPECT_EQ(report_text(said), "3 shackles on deck");
    EXPECT_EQ(report_text(report(ReportCode::brought_up)), "she is brought up");
    EXPECT_EQ(report_text(report(ReportCode::anchor_aweigh, 1)), "starboard anchor is aweigh");
    EXPECT_EQ(report_text(report(ReportCode::anchor_aweigh, -1)), "anchor is aweigh");

    said = report(ReportCode::lead);
    EXPECT_EQ(report_text(said), "port cable is leading");
    said.lead = 11;
    EXPECT_EQ(report_text(said), "port cable is leading 11 o'clock");
    said.stay = 2;
    EXPECT_EQ(report_text(said), "port cable is leading 11 o'clock, short stay");
    said.lead = 0, said.stay = 1;
    EXPECT_EQ(report_text(said), "port cable is up and down");

    said = report(ReportCode::weight);
    said.weight = 4, said.text = "stop";
    EXPECT_EQ(report_text(said), "too much weight on port cable, stop");
    said = report(ReportCode::growing);
    EXPECT_EQ(report_text(said), "port cable is growing");
    said.growing = 3;
    EXPECT_EQ(report_text(said), "port cable is tight");

    said = report(ReportCode::turns);
    said.value = 1;
    EXPECT_EQ(report_text(said), "1 turn in port cable");
    said = report(ReportCode::brought_up);
    said.lead = 12, said.growing = 1;
    EXPECT_EQ(report_text(said), "she is brought up, 12 o'clock, slack") << "nothing that was given is lost";
    said = report(ReportCode::text);
    said.text = "all well";
    EXPECT_EQ(report_text(said), "all well");
}

TEST(Sentences, AnAnchorIsReadyForWhateverWasOrdered) {
    EXPECT_EQ(report_text(report(ReportCode::anchor_ready)), "port anchor is ready")
        << "to be walked out or hove up as well as let go";
}

TEST(Sentences, ARepeatSaysTheOrderThatWasUnderstood) {
    ReportSaid said = report(ReportCode::order_repeated, -1);
    said.order_code = static_cast<std::size_t>(BridgeOrderCode::let_go);
    EXPECT_EQ(report_text(said), "repeats: let go both anchors");
    said.order_code = static_cast<std::size_t>(BridgeOrderCode::text);
    EXPECT_EQ(report_text(said), "repeats: the order") << "of own words that were not said again";
    said.text = "ring the bell";
    EXPECT_EQ(report_text(said), "repeats: ring the bell");
}

TEST(Sentences, WhatIsUnsafeSaysWhatIsProposedInstead) {
    ReportSaid said = report(ReportCode::unsafe);
    EXPECT_EQ(report_text(said), "unsafe");
    said.order_code = static_cast<std::size_t>(BridgeOrderCode::hold_on);
    said.value = 4, said.text = "the wind rises";
    EXPECT_EQ(report_text(said),
              "unsafe: I propose to hold on port cable at 4 shackles in the pipe, the wind rises");
}

TEST(Sentences, AnEventHasItsFigure) {
    EXPECT_EQ(event_text(*find_event("anchor.on_bottom"), 36.04),
              "anchor on the bottom, 36.0 m of cable out");
    EXPECT_EQ(event_text(*find_event("anchor.holding"), 1e5), "anchor holds");
}

TEST(Sentences, StaysAreTheServersClasses) {
    EXPECT_EQ(kStay[stay_at(80)].name, "up_and_down");
    EXPECT_EQ(kStay[stay_at(75)].name, "short");
    EXPECT_EQ(kStay[stay_at(50.1)].name, "short");
    EXPECT_EQ(kStay[stay_at(50)].name, "medium");
    EXPECT_EQ(kStay[stay_at(25)].name, "long");
}

} // namespace
} // namespace windlass::words
