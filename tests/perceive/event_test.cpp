// Who notices which event. Every code that the server's sources log has a row in the table.

#include "tests/perceive/ships.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace windlass::perceive {
namespace {

namespace fs = std::filesystem;
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

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// The arguments of a call whose opening bracket stands there.
std::vector<std::string> arguments(const std::string& source, std::size_t open) {
    std::vector<std::string> list(1);
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = open; i < source.size(); ++i) {
        const char c = source[i];
        if (c == '"' && source[i - 1] != '\\') quoted = !quoted;
        if (!quoted && (c == '(' || c == '{' || c == '[') && depth++ == 0) continue;
        if (!quoted && (c == ')' || c == '}' || c == ']') && --depth == 0) return list;
        if (!quoted && c == ',' && depth == 1)
            list.emplace_back();
        else
            list.back() += c;
    }
    return {};
}

/// Codes in a call's argument: literals, or those that its constants stand for.
void add_codes(const std::string& argument, const std::string& all_sources, std::set<std::string>& codes) {
    static const std::regex literal(R"re("([a-z_]+\.[a-z_]+)")re"), constant(R"re(\bk[A-Z]\w*)re");
    for (std::sregex_iterator it(argument.begin(), argument.end(), literal), end; it != end; ++it)
        codes.insert((*it)[1]);
    for (std::sregex_iterator it(argument.begin(), argument.end(), constant), end; it != end; ++it) {
        const std::regex given(it->str() + R"re(\s*=\s*"([a-z_]+\.[a-z_]+)")re");
        std::smatch match;
        if (std::regex_search(all_sources, match, given)) codes.insert(match[1]);
    }
}

/// Every code in the server's calls of log(severity, code, ...).
std::set<std::string> logged_codes() {
    std::vector<std::string> sources;
    std::string all;
    for (const char* room : {"exercise", "run", "host"}) {
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(WINDLASS_SOURCE_DIR) / "server" / room)) {
            if (!entry.is_regular_file()) continue;
            sources.push_back(text_of(entry.path()));
            all += sources.back();
        }
    }
    static const std::regex call(R"re(\blog\()re");
    std::set<std::string> codes;
    for (const std::string& source : sources) {
        for (std::sregex_iterator it(source.begin(), source.end(), call), end; it != end; ++it) {
            const auto open = static_cast<std::size_t>(it->position() + it->length() - 1);
            const std::vector<std::string> given = arguments(source, open);
            if (given.size() > 1 && given[0].find("everity") != std::string::npos)
                add_codes(given[1], all, codes);
        }
    }
    return codes;
}

TEST(Events, EveryCodeOfTheSourcesHasARow) {
    const std::set<std::string> codes = logged_codes();
    EXPECT_GT(codes.size(), 50U) << "the search no longer finds them";
    EXPECT_TRUE(codes.contains("exercise.stopped_by_fault")); // by a constant
    EXPECT_TRUE(codes.contains("exercise.resumed"));          // one of two
    std::set<std::string> without;
    for (const std::string& code : codes)
        if (event_rule(code) == nullptr) without.insert(code);
    EXPECT_THAT(without, testing::IsEmpty()) << "say in server/perceive/seat_event.cpp who notices them";
}

TEST(Events, NoCodeHasTwoRows) {
    std::set<std::string_view> codes;
    for (const EventRule& rule : event_rules()) {
        EXPECT_TRUE(codes.insert(rule.code).second) << rule.code;
        if (!rule.code.ends_with(".*")) {
            EXPECT_EQ(event_rule(rule.code), &rule) << rule.code;
        }
        EXPECT_LE(rule.text.size(), 256U);
    }
}

TEST(Events, ACodeWithoutARowIsNoticedByNobody) {
    EXPECT_EQ(event_rule("brake.invented"), nullptr);
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
    for (const char* code : {"anchor.aweigh", "anchor.fouled", "anchor.flukes_inboard"}) {
        EXPECT_FALSE(perceive_event(event(code), riding())) << code;
        const auto seen = perceive_event(event(code), weighing());
        ASSERT_TRUE(seen) << code;
        EXPECT_TRUE(seen->forecastle());
        EXPECT_FALSE(seen->bridge()); // as reported
        EXPECT_EQ(seen->value(), 0);
        EXPECT_FALSE(perceive_event(event(code, "", 1), weighing())) << "of the side that has none";
    }
    EXPECT_TRUE(perceive_event(event("anchor.let_go"), riding())); // the cable runs
}

TEST(Events, CarryWhatIsNoticedAndNoMore) {
    const auto shackle = perceive_event(event("cable.shackle", "3 shackles out"), riding());
    ASSERT_TRUE(shackle);
    EXPECT_EQ(shackle->tick(), 300U);
    EXPECT_EQ(shackle->time(), 1);
    EXPECT_EQ(shackle->number(), 0U); // who sends it counts
    EXPECT_EQ(shackle->severity(), EVENT_WARNING);
    EXPECT_EQ(shackle->code(), "cable.shackle");
    EXPECT_EQ(shackle->side(), 0);
    EXPECT_EQ(shackle->value(), 42);
    EXPECT_EQ(shackle->text(), "3 shackles out");

    const auto hot = perceive_event(event("brake.hot"), riding());
    ASSERT_TRUE(hot);
    EXPECT_EQ(hot->value(), 0);
    EXPECT_EQ(hot->text(), "brake lining smokes");

    for (const EventRule& rule : event_rules()) {
        if (rule.text.empty() || rule.forecastle != Notice::always) continue;
        EXPECT_EQ(perceive_event(event(std::string(rule.code)), riding())->text(), std::string(rule.text));
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
    // None stands for another event of the server's.
    for (const EventRule& rule : event_rules()) {
        if (rule.seat_code.empty()) continue;
        const EventRule* other = event_rule(rule.seat_code);
        EXPECT_TRUE(other == nullptr) << rule.seat_code;
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
