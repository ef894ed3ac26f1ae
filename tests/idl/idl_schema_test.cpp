// The IDL as a text: every topic's type is known, with units, and what is not understood is told.

#include "idl/idl_text.hpp"
#include "idl/topics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace windlass::idl {
namespace {

using testing::HasSubstr;

TEST(IdlSchema, KnowsTheTypeOfEveryTopicByTheNameOfThisVersion) {
    for (const auto& row : wire::topics::all)
        EXPECT_NE(own_schema().find(wire::type_name(row)), nullptr) << row.name;
    for (const auto& row : wire::topics::classroom)
        EXPECT_NE(own_schema().find(wire::type_name(row)), nullptr) << row.name;
    EXPECT_EQ(wire::type_name(wire::topics::server_alert), "windlass::v12::Alert");
    EXPECT_EQ(own_schema().find("windlass::v12::ServerAlert"), nullptr);
    EXPECT_EQ(own_schema().find("windlass::ShipState"), nullptr) << "a type of version 1";
}

void expect_units(const Type& type, const std::string& where, const std::set<std::string>& none) {
    for (const auto& member : type.members) {
        const std::string name = where + "." + member.name;
        if (member.type->kind == Kind::structure && !member.sequence && member.unit.empty())
            expect_units(*member.type, name, none);
        if (member.type->kind != Kind::float64 || none.contains(member.name)) continue;
        EXPECT_NE(member.unit, "") << name;
    }
}

TEST(IdlSchema, EveryRealNumberOfAStateSaysItsUnitOrIsNone) {
    // Ratios, and what has another unit from case to case, as its comment says.
    const std::set<std::string> none{"w",
                                     "x",
                                     "y",
                                     "z",
                                     "utilisation",
                                     "lining_friction", // a coefficient
                                     "turns",           // a count
                                     "step",            // in the unit of its question
                                     "value",
                                     "time_scale",
                                     "time_scale_achieved",
                                     "model_error_load",
                                     "motor_speed_heard", // a share
                                     "gust_factor",
                                     "origin_y", // as origin_x
                                     "limit",
                                     "worst",
                                     "severity",
                                     "brake",
                                     "engine",
                                     "chance",
                                     "trigger_value",
                                     "speed_lever",
                                     "speed"};
    for (const auto& row : wire::topics::all)
        if (row.from_server) expect_units(*own_schema().find(wire::type_name(row)), row.name, none);
}

TEST(IdlSchema, KnowsKeysAndTheBoundsOfTexts) {
    const auto& alert = *own_schema().find(wire::type_name(wire::topics::alert));
    for (const auto& member : alert.members) {
        EXPECT_EQ(member.key, member.name == "code" || member.name == "side") << member.name;
        const std::uint64_t bound = member.name == "code"          ? 48
                                    : member.name == "text"        ? 128
                                    : member.name == "explanation" ? 256
                                                                   : 0;
        EXPECT_EQ(member.text_bound, bound) << member.name;
    }
    // As the table of topics has it, which a test holds against topics.md; keys stand first.
    for (const auto& row : wire::topics::all) {
        const auto& members = own_schema().find(wire::type_name(row))->members;
        EXPECT_EQ(members[0].key, row.keyed) << row.name;
        bool before = true;
        for (const auto& member : members) {
            EXPECT_TRUE(before || !member.key) << row.name << "." << member.name;
            before = member.key;
        }
    }
}

TEST(IdlSchema, NamesAreLookedForFromTheInnermostModuleOutwards) {
    const IdlSchema schema("struct A { long of_none; };\n"
                           "module a { struct A { long of_a; };\n"
                           "module v12 { struct B { A first; a::A second; }; struct A { long own; };\n"
                           "struct C { A third; }; }; };");
    const auto& b = *schema.find("a::v12::B");
    EXPECT_EQ(b.members[0].type->name, "a::A");
    EXPECT_EQ(b.members[1].type->name, "a::A");
    EXPECT_EQ(schema.find("a::v12::C")->members[0].type->name, "a::v12::A");
}

TEST(IdlSchema, WhatIsNotUnderstoodIsToldWithItsLine) {
    for (const char* text :
         {"module a {\nunion U switch (long) {};\n};", "struct A {\nmissing b;\n};",
          "struct A {\nlong b[3];\n};", "struct A {\n", "module a {\nstruct B { long c };\n};"}) {
        try {
            IdlSchema schema{text};
            FAIL() << text;
        } catch (const IdlError& error) {
            EXPECT_THAT(error.what(), HasSubstr("IDL line 2: ")) << text;
        }
    }
}

} // namespace
} // namespace windlass::idl
