// Orders to the wire and back.

#include "server/dds/order_taken.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::dds {
namespace {

namespace ex = exercise;

/// Numbers that lose something in every shorter form.
constexpr double kThird = 1.0 / 3, kSmall = 5e-324;

run::OrderView there_and_back(const ex::Order& command, OrderTaken& sample) {
    convert({.run = 1'700'000'000'123, .tick = 4711, .number = 12, .source = "trainee-1", .command = command},
            sample);
    return order_view(sample);
}

TEST(OrderTakenSample, GivesBackEveryOrderBitForBit) {
    OrderTaken sample; // one for all, as the publisher's slots are
    const auto levers = there_and_back(ex::WindlassOrder{.side = ex::Side::starboard,
                                                         .brake = kThird,
                                                         .speed_lever = -kSmall,
                                                         .clutch_in = true,
                                                         .stopper_closed = true,
                                                         .emergency_stop = true},
                                       sample);
    EXPECT_EQ(levers.run, 1'700'000'000'123U);
    EXPECT_EQ(levers.tick, 4711U);
    EXPECT_EQ(levers.number, 12U);
    EXPECT_EQ(levers.source, "trainee-1");
    const auto& windlass = std::get<ex::WindlassOrder>(levers.command);
    EXPECT_EQ(windlass.side, ex::Side::starboard);
    EXPECT_EQ(windlass.brake, kThird);
    EXPECT_EQ(windlass.speed_lever, -kSmall);
    EXPECT_TRUE(windlass.clutch_in && windlass.stopper_closed && windlass.emergency_stop);

    const auto answer = std::get<ex::AnswerGiven>(
        there_and_back(ex::AnswerGiven{.question = "out", .kind = ex::AnswerKind::number, .value = kThird},
                       sample)
            .command);
    EXPECT_EQ(answer.question, "out");
    EXPECT_EQ(answer.kind, ex::AnswerKind::number);
    EXPECT_EQ(answer.value, kThird);
    const auto chosen = std::get<ex::AnswerGiven>(
        there_and_back(ex::AnswerGiven{.question = "out", .kind = ex::AnswerKind::choice, .choice = 4},
                       sample)
            .command);
    EXPECT_EQ(chosen.choice, 4);

    const auto helm =
        std::get<ex::HelmOrder>(there_and_back(ex::HelmOrder{kThird, -kThird, kSmall, -0.0}, sample).command);
    EXPECT_EQ(helm.engine, kThird);
    EXPECT_EQ(helm.rudder, -kThird);
    EXPECT_EQ(helm.bow_thruster, kSmall);
    EXPECT_TRUE(std::signbit(helm.stern_thruster));

    const auto fault =
        std::get<ex::FaultOrder>(there_and_back(ex::FaultOrder{.code = ex::FaultCode::brake_wet,
                                                               .side = ex::Side::starboard,
                                                               .severity = kThird,
                                                               .trigger = ex::FaultTrigger::at_load,
                                                               .trigger_value = 1e6 / 3},
                                                sample)
                                     .command);
    EXPECT_EQ(fault.code, ex::FaultCode::brake_wet);
    EXPECT_EQ(fault.side, ex::Side::starboard);
    EXPECT_EQ(fault.severity, kThird);
    EXPECT_EQ(fault.trigger, ex::FaultTrigger::at_load);
    EXPECT_EQ(fault.trigger_value, 1e6 / 3);
    EXPECT_FALSE(fault.clear);

    ex::EnvironmentOrder environment;
    environment.weather.wind_speed = 17 * kThird;
    environment.weather.veering = -kSmall;
    environment.weather.current_towards = -kThird;
    environment.weather.current_profile = {{2 * kThird, kThird, -kThird}};
    environment.weather.time_of_day = 86400 * kThird;
    environment.ramp = 60 * kThird;
    const auto weather = std::get<ex::EnvironmentOrder>(there_and_back(environment, sample).command);
    EXPECT_EQ(weather.weather.wind_speed, 17 * kThird);
    EXPECT_EQ(weather.weather.veering, -kSmall);
    EXPECT_EQ(weather.weather.current_towards, -kThird);
    ASSERT_EQ(weather.weather.current_profile.size(), 1U);
    EXPECT_EQ(weather.weather.current_profile[0].depth, 2 * kThird);
    EXPECT_EQ(weather.weather.current_profile[0].turn, -kThird);
    EXPECT_EQ(weather.weather.time_of_day, 86400 * kThird);
    EXPECT_EQ(weather.ramp, 60 * kThird);

    const auto given = std::get<ex::BridgeOrderGiven>(
        there_and_back(ex::BridgeOrderGiven{.code = ex::BridgeOrderCode::hold_on,
                                            .side = 0,
                                            .value = 6 + kThird,
                                            .text = "hold on at six",
                                            .by = "instructor",
                                            .repeat_within = 5,
                                            .do_within = 10},
                       sample)
            .command);
    EXPECT_EQ(given.code, ex::BridgeOrderCode::hold_on);
    EXPECT_EQ(given.value, 6 + kThird);
    EXPECT_EQ(given.text, "hold on at six");
    EXPECT_EQ(given.by, "instructor");
    EXPECT_EQ(given.do_within, 10);

    const auto circle = std::get<ex::WatchCircleOrder>(
        there_and_back(ex::WatchCircleOrder{true, kThird, -kThird, 300 * kThird}, sample).command);
    EXPECT_TRUE(circle.kept);
    EXPECT_EQ(circle.radius, 300 * kThird);

    const auto shown =
        std::get<ex::LightsAndShapes>(there_and_back(ex::LightsAndShapes{false, true}, sample).command);
    EXPECT_FALSE(shown.anchor_ball);
    EXPECT_TRUE(shown.anchor_lights);

    const auto ship = std::get<ex::OwnShipSample>(
        there_and_back(ex::OwnShipSample{.position = {kThird, -1e6 / 3, kSmall},
                                         .attitude = Eigen::Quaterniond(kThird, -kThird, 0.5, 0.7),
                                         .velocity = {1, kThird, -kThird},
                                         .angular_velocity = {0, kSmall, -kThird},
                                         .time = 1.7e9 + kThird},
                       sample)
            .command);
    EXPECT_EQ(ship.position, physics::Vec3(kThird, -1e6 / 3, kSmall));
    EXPECT_EQ(ship.attitude.coeffs(), Eigen::Quaterniond(kThird, -kThird, 0.5, 0.7).coeffs());
    EXPECT_EQ(ship.velocity, physics::Vec3(1, kThird, -kThird));
    EXPECT_EQ(ship.angular_velocity, physics::Vec3(0, kSmall, -kThird));
    EXPECT_EQ(ship.time, 1.7e9 + kThird);

    EXPECT_EQ(std::get<ex::ChanceDrawn>(there_and_back(ex::ChanceDrawn{kThird}, sample).command).chance,
              kThird);

    const auto report =
        std::get<ex::ReportMade>(there_and_back(ex::ReportMade{.code = ex::ReportCode::shackles_on_deck,
                                                               .side = 1,
                                                               .value = 2.5,
                                                               .lead = 11,
                                                               .growing = ex::Growing::tight,
                                                               .order_number = 3,
                                                               .order_code = ex::BridgeOrderCode::veer,
                                                               .text = "two and a half on deck"},
                                                sample)
                                     .command);
    EXPECT_EQ(report.lead, 11);
    EXPECT_EQ(report.stay, ex::StayGiven::not_given);
    EXPECT_EQ(report.growing, ex::Growing::tight);
    EXPECT_EQ(report.order_number, 3);
    EXPECT_EQ(report.order_code, ex::BridgeOrderCode::veer);
    EXPECT_EQ(report.code, ex::ReportCode::shackles_on_deck);
    EXPECT_EQ(report.side, 1);
    EXPECT_EQ(report.value, 2.5);
    EXPECT_EQ(report.text, "two and a half on deck");
}

TEST(OrderTakenSample, OfADamagedRecordingIsRefusedNotTaken) {
    OrderTaken sample;
    sample.kind(static_cast<OrderTakenKind>(99));
    EXPECT_THROW(order_view(sample), std::runtime_error);
    sample.kind(ORDER_TAKEN_FAULT);
    sample.fault().code(static_cast<windlass::FaultCode>(1000));
    EXPECT_THROW(order_view(sample), std::runtime_error);
    sample.kind(ORDER_TAKEN_WINDLASS);
    sample.windlass().side(-1);
    EXPECT_THROW(order_view(sample), std::runtime_error);
    sample.kind(ORDER_TAKEN_BRIDGE_ORDER);
    sample.bridge_order().code(static_cast<windlass::BridgeOrderCode>(77));
    EXPECT_THROW(order_view(sample), std::runtime_error);
    sample.kind(ORDER_TAKEN_ALERT); // known to the wire, and not taken yet
    EXPECT_THROW(order_view(sample), std::runtime_error);
}

} // namespace
} // namespace windlass::dds
