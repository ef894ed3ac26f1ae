// Payloads opened by the IDL that a recording carries.

#include "embedded/windlass_idl.hpp"
#include "recorder/export/csv_text.hpp"
#include "recorder/export/json_text.hpp"
#include "recorder/recording/typed.hpp"

#include "idl/topics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace windlass::recorder {
namespace {

using recording::IdlError;
using recording::IdlSchema;
using recording::Kind;
using testing::ElementsAre;
using testing::HasSubstr;

const IdlSchema& ours() {
    static const IdlSchema schema{embedded::windlass_idl};
    return schema;
}

nlohmann::json json_of(const char* type, mcap::Bytes payload) {
    std::string text;
    JsonText visitor(text);
    walk(*ours().find(type), payload, visitor);
    return nlohmann::json::parse(text);
}

TEST(IdlSchemaTest, KnowsTheTypeOfEveryTopic) {
    for (const auto& row : wire::topics::all)
        EXPECT_NE(ours().find(std::string("windlass::") + row.name), nullptr) << row.name;
    EXPECT_EQ(ours().find("windlass::Nothing"), nullptr);
}

TEST(IdlSchemaTest, EveryRealNumberOfAStateSaysItsUnitOrIsNone) {
    // Ratios, and what has another unit from case to case, as its comment says.
    const std::set<std::string> none{"w",
                                     "x",
                                     "y",
                                     "z",
                                     "utilisation",
                                     "lining_friction", // a coefficient
                                     "turns",           // a count
                                     "value",
                                     "time_scale",
                                     "time_scale_achieved",
                                     "model_error_load",
                                     "limit",
                                     "worst",
                                     "deduction",
                                     "severity",
                                     "brake",
                                     "engine",
                                     "trigger_value",
                                     "speed_lever",
                                     "speed"};
    for (const auto& row : wire::topics::all) {
        if (!row.from_server) continue;
        for (const auto& member : ours().find(std::string("windlass::") + row.name)->members) {
            if (member.type->kind != Kind::float64 || none.contains(member.name)) continue;
            EXPECT_NE(member.unit, "") << row.name << "." << member.name;
        }
    }
}

TEST(IdlSchemaTest, WhatIsNotUnderstoodIsToldWithItsLine) {
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

TEST(CdrWalk, OpensWhatTheCompiledTypeHasClosed) {
    ExerciseStatus status;
    status.tick(12345678901234ULL);
    status.time(0.1);
    status.state(RUN_FINISHED);
    status.exercise("let-go");
    status.title("a \"title\", with a comma");
    FaultStatus fault;
    fault.code(FAULT_SOIL_POOR);
    fault.side(-1);
    fault.severity(0.25);
    status.faults({fault, fault});
    const auto json = json_of("windlass::ExerciseStatus", recording::encode(status));
    EXPECT_EQ(json["tick"], 12345678901234ULL);
    EXPECT_EQ(json["time"], 0.1);
    EXPECT_EQ(json["state"], "RUN_FINISHED");
    EXPECT_EQ(json["title"], "a \"title\", with a comma");
    ASSERT_EQ(json["faults"].size(), 2U);
    EXPECT_EQ(json["faults"][1]["code"], "FAULT_SOIL_POOR");
    EXPECT_EQ(json["faults"][1]["side"], -1);

    Checkpoint checkpoint;
    checkpoint.data({0, 1, 254, 255});
    EXPECT_EQ(json_of("windlass::Checkpoint", recording::encode(checkpoint))["data"], "AAH+/w==");

    const auto back = recording::decode<ExerciseStatus>(recording::encode(status));
    EXPECT_EQ(back, status);
}

TEST(CdrWalk, NumberThatIsNoneIsNull) {
    HelmCommand helm;
    helm.rudder(std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(json_of("windlass::HelmCommand", recording::encode(helm))["rudder"].is_null());
}

TEST(CdrWalk, EveryPayloadCutShortIsRefused) {
    ChainState chain;
    chain.nodes().resize(10);
    chain.tension().resize(9);
    const auto whole = recording::encode(chain);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        std::string text;
        EXPECT_THROW(append_csv(*ours().find("windlass::ChainState"), mcap::Bytes(whole).first(size), text),
                     mcap::Damage)
            << size;
    }
}

TEST(CdrWalk, SequenceBeyondItsBoundIsRefused) {
    ChainState chain;
    chain.nodes().resize(2049);
    std::string text;
    EXPECT_THROW(append_csv(*ours().find("windlass::ChainState"), recording::encode(chain), text),
                 mcap::Damage);
}

TEST(Csv, ColumnsHaveUnitsAndAsManyCells) {
    const auto& type = *ours().find("windlass::ChainState");
    EXPECT_THAT(csv_columns(type),
                ElementsAre("side", "tick", "time (s)", "cable_out (m)", "cable_out_shackles (shackles)",
                            "lead_clock (hours)", "stay", "top_angle (rad)", "on_bottom (m)", "turns",
                            "largest_tension (N)", "stretched (m)", "stretch (0..1)", "nodes (m)",
                            "tension (N)", "marks"));
    ChainState chain;
    chain.stay(STAY_LONG);
    chain.time(1.5);
    chain.turns(-2);
    Point3f point;
    point.x(0.5F);
    point.z(-2);
    chain.nodes({point, point});
    chain.tension({0.1F});
    std::string text;
    append_csv(type, recording::encode(chain), text);
    EXPECT_EQ(text, ",0,0,1.5,0,0,0,STAY_LONG,0,0,-2,0,0,0,0.5 0 -2;0.5 0 -2,0.1,"); // no marks

    EXPECT_THAT(csv_columns(*ours().find("windlass::CableForce")),
                ElementsAre("tick", "time (s)", "force.x (N)", "force.y (N)", "force.z (N)", "moment.x (N m)",
                            "moment.y (N m)", "moment.z (N m)"));
}

TEST(Csv, TextWithCommasAndQuotesIsQuoted) {
    EXPECT_EQ(csv_cell("plain"), "plain");
    EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_cell("say \"let go\""), "\"say \"\"let go\"\"\"");
}

TEST(Csv, SequenceOfWhatIsNotOnlyNumbersIsJson) {
    ExerciseStatus status;
    FaultStatus fault;
    fault.code(FAULT_BRAKE_WET);
    status.faults({fault});
    std::string text;
    append_csv(*ours().find("windlass::ExerciseStatus"), recording::encode(status), text);
    EXPECT_THAT(text, HasSubstr(R"("[{""code"":""FAULT_BRAKE_WET"",""side"":0,)"));
}

} // namespace
} // namespace windlass::recorder
