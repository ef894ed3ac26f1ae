// Orders of a page: the very bytes that a typed writer would send, and what is refused, with field and
// reason.

#include "station/gateway/orders.hpp"

#include "idl/topics.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace windlass::gateway {
namespace {

namespace topics = wire::topics;
using nlohmann::json;
using testing::HasSubstr;

const Sender kSender{.source = "trainee-1", .serial = 7, .sent_unix_ns = 1'700'000'000'000'000'000};

template <class T>
Payload typed(T sample) {
    sample.origin().source(kSender.source.c_str());
    sample.origin().serial(kSender.serial);
    sample.origin().sent_unix_ns(kSender.sent_unix_ns);
    Payload bytes(T::getCdrSerializedSize(sample) + 8);
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
    eprosima::fastcdr::Cdr out(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    out.serialize_encapsulation();
    sample.serialize(out);
    bytes.resize(out.getSerializedDataLength());
    return bytes;
}

template <class T>
void expect_same(const wire::Topic<T>& topic, const char* text, const T& sample) {
    EXPECT_EQ(encode_order(topic, json::parse(text), kSender), typed(sample)) << topic.name << " " << text;
}

TEST(GatewayOrders, AReportIsThatOfATypedWriter) {
    Report sample;
    sample.code(REPORT_ORDER_REPEATED);
    sample.side(-1);
    sample.value(3.5);
    sample.lead(11);
    sample.stay(STAY_GIVEN_SHORT);
    sample.growing(GROWING_TIGHT);
    sample.weight(WEIGHT_MUCH);
    sample.order_number(4);
    sample.order_code(BRIDGE_ORDER_HOLD_ON);
    sample.text("Kette steht kurz, \xC3\xBC"
                "ber den Bug");
    expect_same(
        topics::report,
        R"({"code": "REPORT_ORDER_REPEATED", "side": -1, "value": 3.5, "lead": 11, "stay": "STAY_GIVEN_SHORT",
                    "growing": "GROWING_TIGHT", "weight": "WEIGHT_MUCH", "order_number": 4,
                    "order_code": "BRIDGE_ORDER_HOLD_ON", "text": "Kette steht kurz, über den Bug"})",
        sample);
}

TEST(GatewayOrders, WhatIsLeftOutIsNothing) {
    expect_same(topics::report, "{}", Report{});
    expect_same(topics::bridge_order_command, "{}", BridgeOrderCommand{});
    expect_same(topics::watch_circle, "{}", WatchCircle{});
    expect_same(topics::lights_and_shapes_command, "{}", LightsAndShapesCommand{});
    expect_same(topics::alert_command, "{}", AlertCommand{});
    expect_same(topics::exercise_command, "{}", ExerciseCommand{});
    expect_same(topics::environment_command, "{}", EnvironmentCommand{});
    expect_same(topics::environment_command, R"({"weather": {}})", EnvironmentCommand{});
    expect_same(topics::fault_command, "{}", FaultCommand{});
    expect_same(topics::replay_command, "{}", ReplayCommand{});
    expect_same(topics::assessment_command, "{}", AssessmentCommand{});
    expect_same(topics::classroom_command, "{}", ClassroomCommand{});
    expect_same(topics::restore_command, "{}", RestoreCommand{});
}

TEST(GatewayOrders, EveryOtherOrderIsThatOfATypedWriter) {
    BridgeOrderCommand order;
    order.code(BRIDGE_ORDER_HOLD_ON);
    order.side(1);
    order.value(6);
    order.text("hold on at six");
    order.repeat_within(15);
    order.do_within(0.5);
    order.cancels(2);
    expect_same(topics::bridge_order_command,
                R"({"code": "BRIDGE_ORDER_HOLD_ON", "side": 1, "value": 6, "text": "hold on at six",
                    "repeat_within": 15, "do_within": 0.5, "cancels": 2})",
                order);

    WatchCircle circle;
    circle.kept(true);
    circle.x(-120.25);
    circle.y(1e6);
    circle.radius(150);
    expect_same(topics::watch_circle, R"({"kept": true, "x": -120.25, "y": 1e6, "radius": 150})", circle);

    LightsAndShapesCommand shown;
    shown.anchor_lights(true);
    expect_same(topics::lights_and_shapes_command, R"({"anchor_ball": false, "anchor_lights": true})", shown);

    AlertCommand alert;
    alert.code("brake.hot");
    alert.side(-1);
    alert.action(ALERT_SILENCE);
    expect_same(topics::alert_command, R"({"code": "brake.hot", "side": -1, "action": "ALERT_SILENCE"})",
                alert);

    ExerciseCommand exercise;
    exercise.action(EXERCISE_BOOKMARK);
    exercise.exercise("walk_back_60m.json");
    exercise.time_scale(8);
    exercise.restore_time(120.5);
    exercise.text("too early");
    exercise.predict(true);
    expect_same(topics::exercise_command,
                R"({"action": "EXERCISE_BOOKMARK", "exercise": "walk_back_60m.json", "time_scale": 8,
                    "restore_time": 120.5, "text": "too early", "predict": true})",
                exercise);

    FaultCommand fault;
    fault.code(FAULT_JOINING_SHACKLE_OPEN);
    fault.side(1);
    fault.severity(0.8);
    fault.ramp(5);
    fault.trigger(TRIGGER_AT_EVENT);
    fault.trigger_value(1);
    fault.trigger_until(2);
    fault.trigger_event("anchor.let_go");
    fault.trigger_order(3);
    fault.target(2);
    fault.clear(true);
    expect_same(topics::fault_command,
                R"({"code": "FAULT_JOINING_SHACKLE_OPEN", "side": 1, "severity": 0.8, "ramp": 5,
                    "trigger": "TRIGGER_AT_EVENT", "trigger_value": 1, "trigger_until": 2,
                    "trigger_event": "anchor.let_go", "trigger_order": 3, "target": 2, "clear": true})",
                fault);

    ReplayCommand replay;
    replay.action(REPLAY_SEEK);
    replay.value(63.25);
    expect_same(topics::replay_command, R"({"action": "REPLAY_SEEK", "value": 63.25})", replay);

    ClassroomCommand classroom;
    classroom.action(CLASSROOM_REMOVE);
    classroom.server("server-1");
    classroom.id("anna");
    classroom.exercise("let_go_port_25m");
    classroom.wait(true);
    classroom.definition({'{', '}'});
    expect_same(topics::classroom_command,
                R"({"action": "CLASSROOM_REMOVE", "server": "server-1", "id": "anna",
                    "exercise": "let_go_port_25m", "wait": true, "definition": "{}"})",
                classroom);
}

TEST(GatewayOrders, WeatherHasItsLayersOfCurrent) {
    EnvironmentCommand sample;
    sample.weather().wind_speed(17.5);
    sample.weather().wave_seed(4'000'000'000U);
    sample.weather().time_of_day(64800);
    CurrentLayer top, deep;
    top.share(1);
    deep.depth(20);
    deep.share(0.4);
    deep.turn(0.2);
    sample.weather().current_profile({top, deep});
    sample.ramp(300);
    expect_same(topics::environment_command,
                R"({"weather": {"wind_speed": 17.5, "wave_seed": 4000000000, "time_of_day": 64800,
                    "current_profile": [{"share": 1}, {"depth": 20, "share": 0.4, "turn": 0.2}]}, "ramp": 300})",
                sample);
}

TEST(GatewayOrders, LeversAreWhole) {
    WindlassCommand levers;
    levers.side(1);
    levers.brake(0.25);
    levers.speed_lever(-1);
    levers.clutch_in(true);
    const json message = json::parse(R"({"op": "levers", "side": 1, "brake": 0.25, "speed_lever": -1,
        "clutch_in": true, "stopper_closed": false, "emergency_stop": false})");
    EXPECT_EQ(
        encode_order(topics::windlass_command, windlass_levers(topics::windlass_command, message), kSender),
        typed(levers));

    HelmCommand helm;
    helm.engine(-0.5);
    helm.rudder(0.3);
    helm.bow_thruster(1);
    EXPECT_EQ(encode_order(topics::helm_command,
                           helm_levers(topics::helm_command,
                                       json::parse(R"({"op": "helm", "engine": -0.5, "rudder": 0.3,
                                                       "bow_thruster": 1, "stern_thruster": 0})")),
                           kSender),
              typed(helm));
}

struct Bad {
    const wire::TopicInfo* topic;
    const char* sample;
    const char* field;
    const char* allowed; ///< part of what is said
};

TEST(GatewayOrders, WhatHasNoPlaceInTheTypeIsRefusedWithItsField) {
    const std::string long_text(257, 'x');
    const std::string with_long_text = R"({"text": ")" + long_text + R"("})";
    const Bad bad[] = {
        {&topics::report, "[]", "sample", "an object"},
        {&topics::report, "null", "sample", "an object"},
        {&topics::report, R"({"cod": 1})", "cod", "code, side, value"},
        {&topics::report, R"({"origin": {"source": "server"}})", "origin", "code, side"},
        {&topics::report, R"({"code": 3})", "code", "REPORT_LET_GO"},
        {&topics::report, R"({"code": "REPORT_NOTHING"})", "code", "REPORT_LET_GO"},
        {&topics::report, R"({"code": "report_let_go"})", "code", "REPORT_LET_GO"},
        {&topics::report, R"({"code": null})", "code", "left out"},
        {&topics::report, R"({"side": 1.5})", "side", "a whole number"},
        {&topics::report, R"({"side": "1"})", "side", "a whole number"},
        {&topics::report, R"({"side": 3000000000})", "side", "-2147483648 to 2147483647"},
        {&topics::report, R"({"side": -99999999999999999999})", "side", "a whole number"},
        {&topics::report, R"({"value": "much"})", "value", "a finite number"},
        {&topics::report, R"({"value": true})", "value", "a finite number"},
        {&topics::report, R"({"text": "two\nlines"})", "text", "without control characters"},
        {&topics::report, R"({"text": "a \u0000 zero"})", "text", "without control characters"},
        {&topics::report, R"({"text": 5})", "text", "text"},
        {&topics::report, with_long_text.c_str(), "text", "256 bytes"},
        {&topics::bridge_order_command, R"({"side": []})", "side", "a whole number"},
        {&topics::watch_circle, R"({"kept": 1})", "kept", "true or false"},
        {&topics::watch_circle, R"({"radius": {}})", "radius", "a finite number"},
        {&topics::alert_command, R"({"action": "ALERT_FORGET"})", "action",
         "ALERT_ACKNOWLEDGE, ALERT_SILENCE"},
        {&topics::exercise_command, R"({"action": "EXERCISE_EXPLODE"})", "action", "EXERCISE_START"},
        {&topics::environment_command, R"({"weather": 5})", "weather.", "an object of wind_speed"},
        {&topics::environment_command, R"({"weather": {"wind": 5}})", "weather.wind", "wind_speed"},
        {&topics::environment_command, R"({"weather": {"wave_seed": -1}})", "weather.wave_seed",
         "0 to 4294967295"},
        {&topics::environment_command, R"({"weather": {"current_profile": {}}})", "weather.current_profile",
         "a list"},
        {&topics::environment_command, R"({"weather": {"current_profile": [{"depth": "deep"}]}})",
         "weather.current_profile[0].depth", "a finite number"},
        {&topics::fault_command, R"({"trigger_order": "BRIDGE_ORDER_LET_GO"})", "trigger_order",
         "a whole number"},
        {&topics::fault_command, R"({"clear": "yes"})", "clear", "true or false"},
        {&topics::replay_command, R"({"action": 2})", "action", "REPLAY_SEEK"},
        {&topics::classroom_command, R"({"definition": {"ship": 1}})", "definition", "text"},
    };
    for (const Bad& each : bad) {
        try {
            encode_order(*each.topic, json::parse(each.sample), kSender);
            ADD_FAILURE() << each.topic->name << " took " << each.sample;
        } catch (const Refused& refusal) {
            EXPECT_EQ(refusal.topic, each.topic->name);
            EXPECT_EQ(refusal.field, each.field) << each.sample;
            EXPECT_THAT(refusal.allowed, HasSubstr(each.allowed)) << each.sample;
            EXPECT_LE(refusal.value.size(), 64U);
            EXPECT_THAT(refusal.what(), HasSubstr(each.field));
        } catch (const std::exception& error) {
            ADD_FAILURE() << each.sample << ": " << error.what();
        }
    }
}

TEST(GatewayOrders, ATextAsLongAsItMayBeIsTaken) {
    Report sample;
    sample.text(std::string(256, 'x'));
    expect_same(topics::report, (R"({"text": ")" + std::string(256, 'x') + R"("})").c_str(), sample);
}

TEST(GatewayOrders, SixtyFiveLayersAreOneTooMany) {
    json sample = {{"weather", {{"current_profile", json::array()}}}};
    for (int i = 0; i < 64; ++i)
        sample["weather"]["current_profile"].push_back(json::object());
    EXPECT_NO_THROW(encode_order(topics::environment_command, sample, kSender));
    sample["weather"]["current_profile"].push_back(json::object());
    EXPECT_THROW(encode_order(topics::environment_command, sample, kSender), Refused);
}

TEST(GatewayOrders, NoJsonHasANumberThatIsNone) {
    for (const char* text : {R"({"value": NaN})", R"({"value": Infinity})", R"({"value": 1e999})"})
        EXPECT_TRUE(json::parse(text, nullptr, false).is_discarded()) << text;
}

TEST(GatewayOrders, LeversBeyondTheirStopsOrHalfGivenAreRefused) {
    const json good =
        json::parse(R"({"op": "levers", "side": 0, "brake": 1, "speed_lever": 0, "clutch_in": false,
        "stopper_closed": false, "emergency_stop": false})");
    EXPECT_NO_THROW(windlass_levers(topics::windlass_command, good));
    for (const auto& [field, value] : std::vector<std::pair<const char*, json>>{{"side", 2},
                                                                                {"side", -1},
                                                                                {"side", 0.0},
                                                                                {"side", true},
                                                                                {"brake", 1.01},
                                                                                {"brake", -0.01},
                                                                                {"brake", "1"},
                                                                                {"speed_lever", 2},
                                                                                {"clutch_in", 1},
                                                                                {"origin", json::object()}}) {
        json message = good;
        message[field] = value;
        try {
            windlass_levers(topics::windlass_command, message);
            ADD_FAILURE() << field << " " << value;
        } catch (const Refused& refusal) {
            EXPECT_EQ(refusal.field, field);
        }
    }
    for (const char* field :
         {"side", "brake", "speed_lever", "clutch_in", "stopper_closed", "emergency_stop"}) {
        json message = good;
        message.erase(field);
        EXPECT_THROW(windlass_levers(topics::windlass_command, message), Refused) << field;
    }
    EXPECT_THROW(
        helm_levers(topics::helm_command, json::parse(R"({"engine": 0, "rudder": 1, "bow_thruster": 0,
        "stern_thruster": 0})")),
        Refused); // 57 degrees
}

} // namespace
} // namespace windlass::gateway
