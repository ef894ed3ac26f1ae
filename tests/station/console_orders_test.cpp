// The instructor's orders: when they are carried out, and when refused.

#include "instructor_console/orders.hpp"
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
    now.take(event(1, "exercise.reset", "exercise reset by me-2"), kNow);
    EXPECT_FALSE(console::reset_order().carried_out(now, "me"));
    now.take(event(2, "exercise.reset", "exercise reset by me"), kNow);
    EXPECT_TRUE(console::reset_order().carried_out(now, "me"));

    EXPECT_FALSE(console::time_scale_order(2).carried_out(now, "me"));
    now.status.sample.time_scale(2);
    EXPECT_TRUE(console::time_scale_order(2).carried_out(now, "me"));
}

TEST(ConsoleOrders, EnvironmentKeepsWhatIsNotGiven) {
    Picture picture = anchored();
    picture.status.sample.wind_speed(8);
    picture.status.sample.current_speed(0.3);
    const auto order = console::environment_order(
        {.wind_speed = 15, .wind_from = {}, .current_speed = {}, .current_towards = {}}, picture);
    EXPECT_EQ(order.sample.wind_speed(), 15);
    EXPECT_EQ(order.sample.current_speed(), 0.3);
    EXPECT_FALSE(order.carried_out(picture, "me"));
    picture.status.sample.wind_speed(15);
    EXPECT_TRUE(order.carried_out(picture, "me"));
}

TEST(ConsoleOrders, FaultIsKnownByItsCodeSideAndTrigger) {
    const auto order =
        console::fault_order(FAULT_BRAKE_LINING_FADED, SIDE_PORT, 0.6, TRIGGER_AT_CABLE_OUT, 60);
    Picture picture = anchored();
    FaultStatus fault;
    fault.code(FAULT_BRAKE_LINING_FADED);
    fault.side(SIDE_STARBOARD);
    fault.severity(0.6);
    fault.trigger(TRIGGER_AT_CABLE_OUT);
    fault.trigger_value(60);
    picture.status.sample.faults().push_back(fault);
    EXPECT_FALSE(order.carried_out(picture, "me"));
    picture.status.sample.faults()[0].side(SIDE_PORT);
    EXPECT_TRUE(order.carried_out(picture, "me"));
    const auto clear = console::clear_order(FAULT_BRAKE_LINING_FADED, SIDE_PORT);
    EXPECT_FALSE(clear.carried_out(picture, "me"));
    picture.status.sample.faults()[0].phase(FAULT_PHASE_CLEARED);
    EXPECT_TRUE(clear.carried_out(picture, "me"));
    EXPECT_FALSE(order.carried_out(picture, "me"));
}

TEST(ConsoleOrders, RefusalIsThatOfTheSenderAndSinceTheOrder) {
    Picture picture;
    picture.take(event(1, "command.refused", "FaultCommand from console-7: code = 9 refused"), kNow);
    EXPECT_FALSE(picture.refusal("console-7", 1));
    picture.take(event(2, "command.refused", "FaultCommand from console-77: code = 9 refused"), kNow);
    EXPECT_FALSE(picture.refusal("console-7", 1));
    picture.take(event(3, "command.refused", "FaultCommand from console-7: side = 1 refused"), kNow);
    EXPECT_THAT(picture.refusal("console-7", 1).value(), HasSubstr("side = 1"));
}

} // namespace
} // namespace windlass::station
