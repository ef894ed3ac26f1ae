// Who notices which event, and what of it.

#include "tests/perceive/ships.hpp"
#include "words/words.hpp"

#include <gmock/gmock.h>

#include <map>

namespace windlass::perceive {
namespace {

using exercise::ExerciseEvent;
using exercise::Snapshot;

ExerciseEvent event(const std::string& code, const std::string& text = "its own words", int side = 0) {
    return {.tick = 300,
            .time = 1,
            .number = 9,
            .severity = exercise::Severity::warning,
            .code = code,
            .side = side,
            .value = 42,
            .text = text};
}

/// Every row of words.json.
std::vector<words::Event> rows() {
    std::vector<words::Event> all(words::kEventsWaitedFor.begin(), words::kEventsWaitedFor.end());
    all.insert(all.end(), words::kEventsTold.begin(), words::kEventsTold.end());
    return all;
}

TEST(Events, ACodeWithoutARowIsNoticedByNobody) {
    EXPECT_FALSE(perceive_event(event("brake.invented"), riding()));
    EXPECT_FALSE(perceive_event(event(""), riding()));
}

TEST(Events, TheTruthIsNotNoticed) {
    for (const char* code :
         {"anchor.on_bottom", "anchor.digging_in", "anchor.holding", "anchor.dragging", "anchor.brought_up",
          "cable.overstrained", "cable.overload", "brake.glazed", "fault.armed", "fault.active",
          "fault.cleared", "environment.changed", "exercise.bookmark", "classroom.created"}) {
        EXPECT_FALSE(perceive_event(event(code), riding())) << code;
        EXPECT_FALSE(perceive_event(event(code), weighing())) << code;
    }
}

TEST(Events, TheAnchorIsNoticedWhereItIsAboveTheWater) {
    for (const char* code : {"anchor.acockbill", "anchor.aweigh", "anchor.fouled", "anchor.flukes_inboard"}) {
        EXPECT_FALSE(perceive_event(event(code), riding())) << code;
        const auto seen = perceive_event(event(code), weighing());
        ASSERT_TRUE(seen) << code;
        EXPECT_TRUE(seen->forecastle());
        EXPECT_FALSE(seen->bridge()); // as reported
        EXPECT_EQ(seen->value(), 0);
        EXPECT_FALSE(perceive_event(event(code, "", 1), weighing())) << "of the side that has none";
    }
    exercise::Snapshot waterline = weighing();
    waterline.tackle[0].anchor.phase = exercise::AnchorPhase::acockbill;
    waterline.tackle[0].anchor.position.z() = -1;
    waterline.tackle[0].anchor.shackle.z() = 1;
    EXPECT_TRUE(perceive_event(event("anchor.acockbill"), waterline)) << "its shank is out of it";
    EXPECT_TRUE(perceive_event(event("anchor.let_go"), riding())); // the cable runs
}

TEST(Events, CarryWhatIsNoticedAndNoMore) {
    const auto shackle = perceive_event(event("cable.shackle", "3 shackles in the pipe"), riding());
    ASSERT_TRUE(shackle);
    EXPECT_EQ(shackle->tick(), 300U);
    EXPECT_EQ(shackle->time(), 1);
    EXPECT_EQ(shackle->number(), 0U); // who sends it counts
    EXPECT_EQ(shackle->severity(), EVENT_WARNING);
    EXPECT_EQ(shackle->code(), "cable.shackle");
    EXPECT_EQ(shackle->side(), 0);
    EXPECT_EQ(shackle->value(), 42);
    EXPECT_EQ(shackle->text(), "3 shackles in the pipe");

    const auto hot = perceive_event(event("brake.hot"), riding());
    ASSERT_TRUE(hot);
    EXPECT_EQ(hot->value(), 0);
    EXPECT_EQ(hot->text(), "brake lining smokes");

    for (const words::Event& rule : rows()) {
        if (rule.seat_said.empty() || rule.forecastle != words::Notice::always) continue;
        EXPECT_EQ(perceive_event(event(std::string(rule.name)), riding())->text(),
                  std::string(rule.seat_said));
    }
    for (const char* code : {"exercise.ready", "exercise.stopped_by_fault"})
        EXPECT_NE(perceive_event(event(code), riding())->text(), "its own words") << code;
}

TEST(Events, ACodeThatNamesACauseIsNotToldToASeat) {
    const std::map<std::string, std::string> codes{{"cable.parted", "cable.slack"},
                                                   {"clutch.sheared", "gypsy.not_driven"},
                                                   {"motor.overload_trip", "motor.trip"},
                                                   {"spurling_pipe.fast", "cable.stands"}};
    for (const auto& [code, told] : codes) {
        const auto seen = perceive_event(event(code), riding());
        ASSERT_TRUE(seen) << code;
        EXPECT_EQ(seen->code(), told) << code;
        EXPECT_EQ(seen->text().to_string().find(code.substr(code.find('.') + 1)), std::string::npos) << code;
    }
}

TEST(Events, WhatIsSaidAndWhoHasWhatIsForBoth) {
    for (const char* code : {"report.made", "order.given", "order.repeated", "levers.taken", "levers.lost",
                             "clutch.refused", "stopper.refused", "brake.waits", "exercise.started"}) {
        const auto seen = perceive_event(event(code), riding());
        ASSERT_TRUE(seen) << code;
        EXPECT_TRUE(seen->forecastle() && seen->bridge()) << code;
        EXPECT_EQ(seen->text(), "its own words") << code;
    }
    EXPECT_FALSE(perceive_event(event("watch.circle"), riding())->forecastle());
    EXPECT_TRUE(perceive_event(event("watch.circle"), riding())->bridge());
}

TEST(Events, WhatIsToldToOneSeatAloneIsNoEventOfBoth) {
    for (const words::Event& row : rows()) {
        const bool alone = row.forecastle == words::Notice::alone || row.bridge == words::Notice::alone;
        const auto told = event(std::string(row.name));
        EXPECT_EQ(is_instruction(told), alone) << row.name;
        if (!alone) continue;
        const auto seen = perceive_event(told, riding());
        ASSERT_TRUE(seen) << row.name;
        EXPECT_NE(seen->forecastle(), seen->bridge()) << row.name << ": it is told to one of them";
        EXPECT_EQ(seen->forecastle(), row.name.ends_with(".forecastle")) << row.name;
    }
    for (const char* code : {"briefing.forecastle", "briefing.bridge", "hint.forecastle", "hint.bridge"})
        EXPECT_TRUE(is_instruction(event(code))) << code;
}

TEST(Events, WhoIsNotHeardIsToldAndTheOtherSeatIsNot) {
    const auto order = perceive_event(event("order.not_heard"), riding());
    ASSERT_TRUE(order);
    EXPECT_TRUE(order->bridge() && !order->forecastle());
    const auto report = perceive_event(event("report.not_heard"), riding());
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->forecastle() && !report->bridge());
}

TEST(Events, ASeatHearsOfItsOwnRefusalsOnly) {
    const auto refused = [](const std::string& text) {
        const auto seen = perceive_event(event("command.refused", text), riding());
        return std::pair(seen && seen->forecastle(), seen && seen->bridge());
    };
    EXPECT_EQ(refused("WindlassCommand from deck: brake = 2 refused; allowed: 0..1"), std::pair(true, false));
    EXPECT_EQ(refused("(3 refusals not listed) HelmCommand from bridge: rudder = 9 refused; allowed: 1"),
              std::pair(false, true));
    EXPECT_EQ(refused("AlertCommand from deck: code"), std::pair(true, true));
    EXPECT_EQ(refused("FaultCommand from instructor: severity = 2 refused; allowed: 0..1"),
              std::pair(false, false));
    EXPECT_EQ(refused("7 samples refused: the mailbox was full"), std::pair(false, false));
    EXPECT_EQ(refused(""), std::pair(false, false));
    EXPECT_EQ(refused("("), std::pair(false, false));
}

TEST(Events, ATextThatIsTooLongIsClipped) {
    const auto seen = perceive_event(event("report.made", std::string(255, 'x') + "\u00e4"), riding());
    EXPECT_EQ(seen->text().size(), 255U); // not through the middle of a character
}

} // namespace
} // namespace windlass::perceive
