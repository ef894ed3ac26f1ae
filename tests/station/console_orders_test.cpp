// The instructor's orders: when they are carried out, and when refused.

#include "instructor_console/bridge_options.hpp"
#include "instructor_console/orders.hpp"
#include "instructor_console/weather_options.hpp"
#include "tests/station/anchored_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace windlass::station {
namespace {

using testing::HasSubstr;

TEST(ConsoleOrders, AreCarriedOutWhenThePictureShowsIt) {
    Picture now = anchored();
    EXPECT_FALSE(console::pause_order().carried_out(now, "me"));
    now.status.sample.state(RUN_PAUSED);
    EXPECT_TRUE(console::pause_order().carried_out(now, "me"));

    now.status.sample.tick(0); // proves nothing: it may have stood at 0 before
    EXPECT_FALSE(console::reset_order().carried_out(now, "me"));
    now.receive(event(1, "exercise.reset", "exercise reset by me-2"), kNow);
    EXPECT_FALSE(console::reset_order().carried_out(now, "me"));
    now.receive(event(2, "exercise.reset", "exercise reset by me"), kNow);
    EXPECT_TRUE(console::reset_order().carried_out(now, "me"));

    EXPECT_FALSE(console::time_scale_order(2).carried_out(now, "me"));
    now.status.sample.time_scale(2);
    EXPECT_TRUE(console::time_scale_order(2).carried_out(now, "me"));
}

TEST(ConsoleOrders, EnvironmentKeepsWhatIsNotGiven) {
    Picture picture = anchored();
    console::Environment wanted;
    wanted.figures["wind_speed"] = 15;
    const auto order = console::environment_order(wanted, picture);
    EXPECT_EQ(order.sample.weather().wind_speed(), 15);
    EXPECT_EQ(order.sample.weather().current_speed(), 0.3);
    EXPECT_EQ(order.sample.ramp(), 0);
    EXPECT_FALSE(order.carried_out(picture, "me"));
    picture.environment.sample.after(order.sample.weather());
    picture.environment.sample.after().time_of_day(77); // it runs on meanwhile
    EXPECT_TRUE(order.carried_out(picture, "me"));
}

TEST(ConsoleOrders, AFetchRaisesTheSeaOfTheWindButWhatIsGiven) {
    Picture picture = anchored();
    console::Environment wanted;
    wanted.figures["wind_speed"] = 19;
    wanted.figures["wind_from"] = 1;
    wanted.fetch = 50e3;
    const Weather raised = console::environment_order(wanted, picture).sample.weather();
    EXPECT_GT(raised.wave_height(), 2);
    EXPECT_GT(raised.wave_period(), 4);
    EXPECT_EQ(raised.wave_from(), 1);
    wanted.figures["wave_height"] = 1;
    wanted.figures["wave_period"] = 7;
    wanted.figures["wave_from"] = 2;
    const Weather given = console::environment_order(wanted, picture).sample.weather();
    EXPECT_EQ(given.wave_height(), 1);
    EXPECT_EQ(given.wave_period(), 7);
    EXPECT_EQ(given.wave_from(), 2);
}

TEST(ConsoleOrders, EnvironmentLetsARampGoOnToItsEnd) {
    Picture picture = anchored();
    EnvironmentState now = *picture.environment;
    now.after().wind_speed(20);
    now.now().time_of_day(1000);
    now.after().time_of_day(900);
    now.ramp_left(120);
    picture.receive(now, kNow);
    console::Environment wanted;
    wanted.figures["current_speed"] = 1;
    const auto order = console::environment_order(wanted, picture);
    EXPECT_EQ(order.sample.weather().wind_speed(), 20);
    EXPECT_EQ(order.sample.weather().current_speed(), 1);
    EXPECT_EQ(order.sample.weather().time_of_day(), 1000);
    EXPECT_EQ(order.sample.ramp(), 120);
    wanted.ramp = 5;
    EXPECT_EQ(console::environment_order(wanted, picture).sample.ramp(), 5);
}

TEST(ConsoleOrders, EnvironmentIsKnownByTheDirectionNotByItsNumber) {
    Picture picture = anchored();
    console::Environment wanted;
    wanted.figures["wind_from"] = -90 * kDegree;
    const auto order = console::environment_order(wanted, picture);
    picture.environment.sample.after().wind_from(270 * kDegree);
    EXPECT_TRUE(order.carried_out(picture, "me"));
    picture.environment.sample.after().wind_from(260 * kDegree);
    EXPECT_FALSE(order.carried_out(picture, "me"));
}

TEST(ConsoleOptions, ProfilesAndHoursAreReadWholeOrNotAtAll) {
    const auto layers = console::current_profile_in("0:1,10:0.6:20").value();
    ASSERT_EQ(layers.size(), 2U);
    EXPECT_EQ(layers[1].depth(), 10);
    EXPECT_EQ(layers[1].share(), 0.6);
    EXPECT_NEAR(layers[1].turn(), 20 * kDegree, 1e-12);
    EXPECT_TRUE(console::current_profile_in("none").value().empty());
    for (const char* bad : {"", "5", "a:b", "1:2:3:4", "0:1,,5:1", "0:nan"})
        EXPECT_FALSE(console::current_profile_in(bad)) << bad;
    EXPECT_EQ(console::time_of_day_in("06:30"), 6 * 3600 + 30 * 60);
    for (const char* bad : {"", "630", "24:00", "6:60", "-1:00", "x:y"})
        EXPECT_FALSE(console::time_of_day_in(bad)) << bad;
}

TEST(ConsoleOptions, BridgeOrdersHaveTheirNumberOrNone) {
    console::BridgeOrderOptions options{.code = "hold-on", .value = "6", .side = "both"};
    EXPECT_EQ(options.wish().value, 6);
    EXPECT_EQ(options.wish().side, -1);
    options.value = "";
    EXPECT_EQ(options.wish().value, 0); // "hold on" alone is an order
    options.code = "pay-out";
    EXPECT_THROW(options.wish(), CLI::ValidationError);
    options = {.code = "let-go", .value = "3"};
    EXPECT_THROW(options.wish(), CLI::ValidationError);
    options = {.code = "text", .value = "mind the buoy"};
    EXPECT_EQ(options.wish().text, "mind the buoy");
    options = {.code = "cancel", .value = "3"};
    EXPECT_EQ(options.wish().cancels, 3);
    options.value = "the last";
    EXPECT_THROW(options.wish(), CLI::ValidationError);
}

FaultStatus armed(const console::FaultOrder& order) {
    const FaultCommand& command = order.sample;
    FaultStatus fault;
    fault.code(command.code());
    fault.side(command.side());
    fault.severity(command.severity());
    fault.ramp(command.ramp());
    fault.trigger(command.trigger());
    fault.trigger_value(command.trigger_value());
    fault.trigger_until(command.trigger_until());
    fault.trigger_event(command.trigger_event());
    fault.trigger_order(command.trigger_order());
    fault.target(command.target());
    return fault;
}

TEST(ConsoleOrders, FaultIsKnownByItsCodeSideAndTrigger) {
    const auto order = console::fault_order(FAULT_BRAKE_LINING_FADED, SIDE_PORT, 0.6,
                                            {.what = TRIGGER_AT_CABLE_OUT, .value = 60});
    Picture picture = anchored();
    FaultStatus fault = armed(order);
    fault.side(SIDE_STARBOARD);
    picture.truth.sample.faults().push_back(fault);
    EXPECT_FALSE(order.carried_out(picture, "me"));
    picture.truth.sample.faults()[0].side(SIDE_PORT);
    EXPECT_TRUE(order.carried_out(picture, "me"));
    const auto clear = console::clear_order(FAULT_BRAKE_LINING_FADED, SIDE_PORT);
    EXPECT_FALSE(clear.carried_out(picture, "me"));
    picture.truth.sample.faults()[0].phase(FAULT_PHASE_CLEARED);
    EXPECT_TRUE(clear.carried_out(picture, "me"));
    EXPECT_FALSE(order.carried_out(picture, "me"));
}

TEST(ConsoleOrders, EveryTriggerIsKnownByAllThatItNeeds) {
    using console::Trigger;
    const Trigger other{.what = TRIGGER_AT_TIME, .value = 9};
    for (const Trigger& trigger : {Trigger{.what = TRIGGER_AT_LOAD_AT_MOST, .value = 1e5},
                                   Trigger{.what = TRIGGER_AT_EVENT, .event = "anchor.on_bottom"},
                                   Trigger{.what = TRIGGER_AT_ORDER, .order = BRIDGE_ORDER_LET_GO},
                                   Trigger{.what = TRIGGER_AT_CHANCE, .value = 60, .until = 120}}) {
        const auto order = console::fault_order(FAULT_DRIVE_TRIP, SIDE_PORT, 1, trigger, 5, 2);
        Picture picture = anchored();
        picture.truth.sample.faults().push_back(armed(order));
        EXPECT_TRUE(order.carried_out(picture, "me")) << trigger.what;
        picture.truth.sample.faults()[0].target(1);
        EXPECT_FALSE(order.carried_out(picture, "me")) << trigger.what;
        picture.truth.sample.faults()[0] =
            armed(console::fault_order(FAULT_DRIVE_TRIP, SIDE_PORT, 1, other, 5, 2));
        EXPECT_FALSE(order.carried_out(picture, "me")) << trigger.what;
    }
}

TEST(ConsoleOrders, BridgeOrderIsKnownByANumberAboveThoseBefore) {
    Picture picture = anchored();
    BridgeOrder before = station::order(1, BRIDGE_ORDER_LET_GO, 0);
    before.by() = "me";
    picture.receive(before, kNow);
    const auto wanted = console::bridge_order({.code = BRIDGE_ORDER_LET_GO}, picture);
    EXPECT_FALSE(wanted.carried_out(picture, "me"));
    before.number(2);
    picture.receive(before, kNow);
    EXPECT_TRUE(wanted.carried_out(picture, "me"));
    EXPECT_FALSE(wanted.carried_out(picture, "you"));
    const auto taken_back = console::bridge_order({.code = BRIDGE_ORDER_CANCEL, .cancels = 2}, picture);
    EXPECT_FALSE(taken_back.carried_out(picture, "me"));
    before.state(ORDER_CANCELLED);
    picture.receive(before, kNow);
    EXPECT_TRUE(taken_back.carried_out(picture, "me"));
}

TEST(ConsoleOrders, AlertIsAnsweredWhenItsConditionSaysSo) {
    Picture picture;
    Alert alert;
    alert.code() = "brake.hot";
    alert.condition(ALERT_ACTIVE_UNACKNOWLEDGED);
    picture.receive(alert, kNow);
    const auto silence = console::alert_order(alert, ALERT_SILENCE);
    const auto acknowledge = console::alert_order(alert, ALERT_ACKNOWLEDGE);
    EXPECT_FALSE(silence.carried_out(picture, "me"));
    alert.condition(ALERT_ACTIVE_SILENCED);
    picture.receive(alert, kNow);
    EXPECT_TRUE(silence.carried_out(picture, "me"));
    EXPECT_FALSE(acknowledge.carried_out(picture, "me"));
    alert.condition(ALERT_ACTIVE_ACKNOWLEDGED);
    picture.receive(alert, kNow);
    EXPECT_TRUE(acknowledge.carried_out(picture, "me"));
}

TEST(ConsoleOrders, BookmarkShowsAsAnEventAfterIt) {
    Picture picture;
    picture.receive(event(1, "exercise.bookmark", "bookmark here by me"), kNow);
    const auto order = console::bookmark_order("here", picture);
    EXPECT_FALSE(order.carried_out(picture, "me"));
    picture.receive(event(2, "exercise.bookmark", "bookmark here by me"), kNow);
    EXPECT_TRUE(order.carried_out(picture, "me"));
}

TEST(ConsoleOrders, RefusalIsThatOfTheSenderAndSinceTheOrder) {
    Picture picture;
    picture.receive(event(1, "command.refused", "FaultCommand from console-7: code = 9 refused"), kNow);
    EXPECT_FALSE(picture.refusal("console-7", {.events = 1}));
    picture.receive(event(2, "command.refused", "FaultCommand from console-77: code = 9 refused"), kNow);
    EXPECT_FALSE(picture.refusal("console-7", {.events = 1}));
    picture.receive(event(3, "command.refused", "FaultCommand from console-7: side = 1 refused"), kNow);
    EXPECT_THAT(picture.refusal("console-7", {.events = 1}).value(), HasSubstr("side = 1"));
}

TEST(ConsoleOrders, RefusalIsHeardAtASeatToo) {
    Picture picture;
    picture.take_forecastle_event(
        event<SeatEvent>(1, "command.refused", "Report from anna: lead = 13 refused"), kNow);
    EXPECT_THAT(picture.refusal("anna", {}).value(), HasSubstr("lead = 13"));
    EXPECT_FALSE(picture.refusal("anna", picture.logs_read()));
    picture.take_bridge_event(
        event<SeatEvent>(1, "command.refused", "HelmCommand from bert: rudder = 9 refused"), kNow);
    EXPECT_THAT(picture.refusal("bert", {}).value(), HasSubstr("rudder = 9"));
    EXPECT_FALSE(picture.refusal("bert", picture.logs_read()));
}

} // namespace
} // namespace windlass::station
