// words.json fits its schema, has what the wire has in the wire's order, and refers to nothing that is not
// there.

#include "common/json_schema.hpp"
#include "idl/idl_text.hpp"
#include "idl/topics.hpp"
#include "words/words.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace windlass::words {
namespace {

using Json = nlohmann::json;

std::string text_of(const std::string& name) {
    std::ifstream in(std::string(WINDLASS_SOURCE_DIR) + "/words/" + name);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

const Json& file() {
    static const Json json = Json::parse(text_of("words.json"));
    return json;
}

using Enumerations = std::map<std::string, const idl::Type*>;

void add_enumerations(const idl::Type& type, Enumerations& all) {
    for (const idl::Member& member : type.members) {
        const std::string& name = member.type->name;
        if (member.type->kind == idl::Kind::enumeration) all[name.substr(name.rfind(':') + 1)] = member.type;
        add_enumerations(*member.type, all);
    }
}

/// Of the topics that the server publishes, by the name without its modules.
const Enumerations& published() {
    static const Enumerations all = [] {
        Enumerations found;
        for (const auto& topic : wire::topics::all)
            if (topic.from_server) add_enumerations(*idl::own_schema().find(wire::type_name(topic)), found);
        return found;
    }();
    return all;
}

/// "brake-wet" in capitals, as enumerators are written.
std::string capitals(std::string name) {
    for (char& c : name)
        c = c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name;
}

TEST(Words, FitTheirSchema) {
    EXPECT_NO_THROW(JsonSchema(text_of("words.schema.json")).check(file(), "words.json"));
}

TEST(Words, HaveEveryEnumeratorOfTheWireInItsOrder) {
    for (const auto& [name, rows] : file().at("enumerations").items()) {
        ASSERT_TRUE(published().contains(name)) << name << " is no enumeration that is published";
        std::vector<std::string> enumerators, names;
        for (const Json& row : rows.at("oneOf")) {
            enumerators.push_back(row.at("enumerator"));
            names.push_back(row.at("const"));
            EXPECT_TRUE(enumerators.back().ends_with(capitals(names.back()))) << enumerators.back();
        }
        EXPECT_EQ(enumerators, published().at(name)->enumerators) << name;
        EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << name;
    }
}

TEST(Words, HaveEveryEnumerationThatIsPublished) {
    std::set<std::string> without;
    for (const auto& [name, type] : published())
        if (!file().at("enumerations").contains(name)) without.insert(name);
    // Of orders that are recorded: they choose a member, or name a button, and nobody reads them. What a
    // prediction came to is said in sentences with figures.
    EXPECT_THAT(without, testing::UnorderedElementsAre("AlertAction", "AnswerKind", "OrderTakenKind",
                                                       "PredictionState"));
}

TEST(Words, EventsHaveOneRowEach) {
    std::set<std::string_view> codes;
    const auto look = [&](const auto& events) {
        for (const Event& event : events) {
            EXPECT_TRUE(codes.insert(event.name).second) << event.name;
            EXPECT_EQ(find_event(event.name), &event);
            if (!event.seat_code.empty()) {
                EXPECT_EQ(find_event(event.seat_code), nullptr)
                    << event.seat_code << " would stand for another event";
            }
        }
    };
    look(kEventsWaitedFor);
    look(kEventsTold);
    EXPECT_EQ(find_event("brake.invented"), nullptr);
    EXPECT_EQ(EventCode("anchor.let_go").row().name, "anchor.let_go");
}

TEST(Words, WhatMakesAReportTrueIsAnEventThatALessonMayWaitFor) {
    for (const Report& report : kReportCode)
        if (!report.event.empty()) {
            EXPECT_GE(place_of(kEventsWaitedFor, report.event), 0) << report.name;
        }
}

TEST(Words, TheReportPadHasEveryReportThatHasAButtonAndNamesNothingElse) {
    std::map<std::string, std::set<std::string>> names;
    std::set<std::string> with_button, on_pad;
    for (const char* name : {"BridgeOrderCode", "ReportCode", "AnchorSeen"})
        for (const Json& row : file().at("enumerations").at(name).at("oneOf")) {
            names[name].insert(row.at("const"));
            if (name == std::string("ReportCode") && row.contains("label"))
                with_button.insert(row.at("const"));
        }
    const auto look = [&](const Json& list, const char* enumeration) {
        for (const Json& name : list)
            EXPECT_TRUE(names[enumeration].contains(name)) << name << " is not of " << enumeration;
    };
    for (const Json& leaf : file().at("report_pad")) {
        for (const Json& report : leaf.at("reports"))
            on_pad.insert(report.get<std::string>());
        const Json after = leaf.value("after", Json::object());
        look(after.value("orders", Json::array()), "BridgeOrderCode");
        look(after.value("reports", Json::array()), "ReportCode");
        look(after.value("anchor", Json::array()), "AnchorSeen");
    }
    EXPECT_EQ(on_pad, with_button);
}

/// The places that a sentence has to be filled in.
std::set<std::string> places(std::string_view sentence) {
    std::set<std::string> all;
    for (std::size_t open = sentence.find('{'); open != std::string_view::npos;
         open = sentence.find('{', open + 1))
        all.insert(std::string(sentence.substr(open + 1, sentence.find('}', open) - open - 1)));
    return all;
}

TEST(Words, SentencesHavePlacesThatCanBeFilled) {
    const std::set<std::string> known{"anchor", "cable",   "windlass", "brake", "side",    "figure",
                                      "lead",   "growing", "weight",   "order", "proposal"};
    const auto look = [&](std::string_view name, std::string_view sentence, Unit unit) {
        for (const std::string& place : places(sentence))
            EXPECT_TRUE(known.contains(place)) << name << ": {" << place << "}";
        EXPECT_EQ(places(sentence).contains("figure"), unit != Unit::none) << name;
    };
    for (const Order& order : kBridgeOrderCode) {
        look(order.name, order.said, order.unit);
        EXPECT_FALSE(places(order.said_bare).contains("figure")) << order.name;
    }
    for (const Report& report : kReportCode)
        look(report.name, report.said, report.unit);
}

TEST(Words, BordersOfOneKindRise) {
    EXPECT_LT(limits::stay_medium, limits::stay_short);
    EXPECT_LT(limits::stay_short, limits::stay_up_and_down);
    EXPECT_LT(limits::cable_fast, limits::cable_unchecked);
    EXPECT_LT(limits::cable_unchecked, limits::cable_runaway);
    EXPECT_LT(limits::lining_warm, limits::lining_smells);
    EXPECT_LT(limits::lining_smells, limits::lining_smokes);
    EXPECT_LT(limits::lining_smokes, limits::lining_burns);
    EXPECT_LT(limits::brake_rubs, limits::brake_squeals);
    EXPECT_LT(limits::brake_squeals, limits::brake_screams);
}

} // namespace
} // namespace windlass::words
