// Payloads opened by the IDL that a recording carries.

#include "recorder/export/csv_text.hpp"
#include "recorder/recording/typed.hpp"

#include "idl/idl_text.hpp"
#include "idl/json_text.hpp"
#include "idl/topics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace windlass::recorder {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const idl::Type& type(const char* name) {
    return *idl::own_schema().find(wire::type_name(name));
}

nlohmann::json json_of(const char* name, mcap::Bytes payload) {
    std::string text;
    idl::append_json(type(name), payload, text);
    return nlohmann::json::parse(text);
}

TEST(CdrWalk, OpensWhatTheCompiledTypeHasClosed) {
    ExerciseStatus status;
    status.state(RUN_FINISHED);
    status.exercise("let-go");
    EXPECT_EQ(json_of("ExerciseStatus", recording::encode(status))["state"], "RUN_FINISHED");

    ExerciseTruth truth;
    truth.tick(12345678901234ULL);
    truth.time(0.1);
    truth.title("a \"title\", with a comma");
    FaultStatus fault;
    fault.code(FAULT_SHIP_BLACKOUT);
    fault.side(-1);
    fault.severity(0.25);
    fault.trigger_event("motor.on");
    truth.faults({fault, fault});
    const auto json = json_of("ExerciseTruth", recording::encode(truth));
    EXPECT_EQ(json["tick"], 12345678901234ULL);
    EXPECT_EQ(json["time"], 0.1);
    EXPECT_EQ(json["title"], "a \"title\", with a comma");
    ASSERT_EQ(json["faults"].size(), 2U);
    EXPECT_EQ(json["faults"][1]["code"], "FAULT_SHIP_BLACKOUT");
    EXPECT_EQ(json["faults"][1]["side"], -1);
    EXPECT_EQ(json["faults"][1]["trigger_event"], "motor.on");

    OrderTaken order;
    order.kind(ORDER_TAKEN_ENVIRONMENT);
    order.environment().weather().current_profile().resize(2);
    order.environment().weather().current_profile()[1].share(0.5);
    order.chance(0.75);
    const auto taken = json_of("OrderTaken", recording::encode(order));
    EXPECT_EQ(taken["environment"]["weather"]["current_profile"][1]["share"], 0.5);
    EXPECT_EQ(taken["chance"], 0.75) << "what is behind a sequence in a structure";

    Checkpoint checkpoint;
    checkpoint.data({0, 1, 254, 255});
    EXPECT_EQ(json_of("Checkpoint", recording::encode(checkpoint))["data"], "AAH+/w==");

    const auto back = recording::decode<ExerciseTruth>(recording::encode(truth));
    EXPECT_EQ(back, truth);
}

TEST(CdrWalk, NumberThatIsNoneIsNull) {
    HelmCommand helm;
    helm.rudder(std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(json_of("HelmCommand", recording::encode(helm))["rudder"].is_null());
}

TEST(CdrWalk, EveryPayloadCutShortIsRefused) {
    ChainState chain;
    chain.nodes().resize(10);
    chain.tension().resize(9);
    const auto whole = recording::encode(chain);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        std::string text;
        EXPECT_THROW(append_csv(type("ChainState"), mcap::Bytes(whole).first(size), text), mcap::Damage)
            << size;
    }
}

TEST(CdrWalk, SequenceBeyondItsBoundIsRefused) {
    ChainState chain;
    chain.nodes().resize(2049);
    std::string text;
    EXPECT_THROW(append_csv(type("ChainState"), recording::encode(chain), text), mcap::Damage);
}

TEST(CdrWalk, ClaimBeyondItsBoundIsNotOpenedWithTheCompiledTypeEither) {
    Checkpoint checkpoint;
    checkpoint.data().resize(3);
    auto payload = recording::encode(checkpoint);
    const auto length = payload.size() - 3 - 4; // of data, the last member
    ASSERT_EQ(payload[length], 3);
    EXPECT_NO_THROW(recording::decode<Checkpoint>(payload));
    std::fill_n(payload.begin() + static_cast<std::ptrdiff_t>(length), 4, std::uint8_t{0xFF});
    EXPECT_THROW(recording::decode<Checkpoint>(payload), mcap::Damage);
}

TEST(Csv, ColumnsHaveUnitsAndAsManyCells) {
    const auto& chain_type = type("ChainState");
    EXPECT_THAT(csv_columns(chain_type),
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
    append_csv(chain_type, recording::encode(chain), text);
    EXPECT_EQ(text, ",0,0,1.5,0,0,0,STAY_LONG,0,0,-2,0,0,0,0.5 0 -2;0.5 0 -2,0.1,"); // no marks

    EXPECT_THAT(csv_columns(type("CableForce")),
                ElementsAre("tick", "time (s)", "force.x (N)", "force.y (N)", "force.z (N)", "moment.x (N m)",
                            "moment.y (N m)", "moment.z (N m)", "hawse"));
    EXPECT_THAT(
        csv_columns(type("EnvironmentState")),
        testing::IsSupersetOf({"now.wind_speed (m/s)", "now.current_profile", "after.time_of_day (s)"}));
}

TEST(Csv, TextWithCommasAndQuotesIsQuoted) {
    EXPECT_EQ(csv_cell("plain"), "plain");
    EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_cell("say \"let go\""), "\"say \"\"let go\"\"\"");
}

TEST(Csv, SequenceOfWhatIsNotOnlyNumbersIsJson) {
    ExerciseTruth truth;
    FaultStatus fault;
    fault.code(FAULT_BRAKE_WET);
    truth.faults({fault});
    std::string text;
    append_csv(type("ExerciseTruth"), recording::encode(truth), text);
    EXPECT_THAT(text, HasSubstr(R"("[{""code"":""FAULT_BRAKE_WET"",""side"":0,)"));
}

} // namespace
} // namespace windlass::recorder
