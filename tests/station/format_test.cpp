// Figures with their units, and the names of things.

#include "station/format.hpp"
#include "station/names.hpp"
#include "station/seen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace windlass::station {
namespace {

TEST(Format, FiguresCarryTheirUnit) {
    EXPECT_EQ(clock(125.9), "2:05");
    EXPECT_EQ(clock(3725), "1:02:05");
    EXPECT_EQ(clock(-3), "0:00");
    EXPECT_EQ(load(443000), "443 kN (45 t)");
    EXPECT_EQ(tonnes(44130), "4.5 t");
    EXPECT_EQ(cable(88.2), "88 m");
    EXPECT_EQ(shackles(3.21), "3.2 shackles");
    EXPECT_EQ(cable_speed(4.12), "4.1 m/s out");
    EXPECT_EQ(cable_speed(-0.15), "0.15 m/s in");
    EXPECT_EQ(knots(0.5144), "1.0 kn");
    EXPECT_EQ(celsius(453.15), "180 degC");
    EXPECT_EQ(megajoules(3.14e6), "3.1 MJ");
    EXPECT_EQ(percent(0.1), "10 %");
}

TEST(Format, WayNamesItsDirection) {
    EXPECT_EQ(way(-0.5144), "astern 1.0 kn");
    EXPECT_EQ(way(0.5144), "ahead 1.0 kn");
}

TEST(Format, NothingIsShownAsMinusZero) {
    EXPECT_EQ(number(-0.04, 1), "0.0");
    EXPECT_EQ(number(-0.4, 0), "0");
    EXPECT_EQ(number(-0.06, 1), "-0.1");
    EXPECT_EQ(load(-3), "0 kN (0.0 t)");
    EXPECT_EQ(knots(-0.001), "0.0 kn");
    EXPECT_EQ(percent(-0.001), "0 %");
    EXPECT_EQ(cable_speed(-0.001), "stopped");
}

TEST(Format, BearingsAreThreeDigitsBelow360) {
    constexpr double kDegree = std::numbers::pi / 180;
    EXPECT_EQ(bearing(7 * kDegree), "007");
    EXPECT_EQ(bearing(359.7 * kDegree), "000");
    EXPECT_EQ(bearing(-1 * kDegree), "359");
    EXPECT_EQ(bearing(725 * kDegree), "005");
}

TEST(Format, LeadIsTwelveOClockWhenAhead) {
    EXPECT_EQ(lead(0), "12 o'clock");
    EXPECT_EQ(lead(11.8), "12 o'clock");
    EXPECT_EQ(lead(10.6), "11 o'clock");
}

TEST(Names, CableUpAndDownLeadsNowhere) {
    ChainState chain;
    chain.lead_clock(11);
    chain.stay(STAY_MEDIUM);
    EXPECT_EQ(lead_and_stay(chain), "11 o'clock, medium stay");
    chain.stay(STAY_UP_AND_DOWN);
    EXPECT_EQ(lead_and_stay(chain), "up and down");
}

TEST(Names, FaultCodesAndNamesAreOneToOne) {
    for (std::uint32_t code = FAULT_BRAKE_LINING_FADED; code <= FAULT_SHIP_BLACKOUT; ++code)
        EXPECT_EQ(fault_code(name(static_cast<FaultCode>(code))), static_cast<FaultCode>(code)) << code;
    EXPECT_EQ(name(static_cast<FaultCode>(FAULT_SHIP_BLACKOUT + 1)), "unknown");
    EXPECT_EQ(fault_code("brake-lining-faded"), FAULT_BRAKE_LINING_FADED);
    EXPECT_EQ(fault_code("load-cell-dead"), FAULT_LOAD_CELL_DEAD);
    EXPECT_EQ(fault_code("gypsy-pockets-worn"), FAULT_GYPSY_POCKETS_WORN);
    EXPECT_EQ(fault_code("vhf-lost"), FAULT_VHF_LOST);
    EXPECT_FALSE(fault_code("BRAKE"));
}

TEST(Names, ReportsAndPhasesAreThoseOfTheWire) {
    EXPECT_EQ(report_code("shackles_in_water"), REPORT_SHACKLES_IN_WATER);
    EXPECT_EQ(report_code("order_repeated"), REPORT_ORDER_REPEATED);
    EXPECT_EQ(report_code("brought_up"), REPORT_BROUGHT_UP);
    EXPECT_EQ(anchor_phase("on_bottom"), ANCHOR_ON_BOTTOM);
    EXPECT_EQ(anchor_phase("lost"), ANCHOR_LOST);
    EXPECT_EQ(name(RUN_STOPPED_BY_FAULT), "stopped_by_fault");
    EXPECT_EQ(name(STAY_LONG), "long");
    EXPECT_EQ(name(static_cast<RunState>(77)), "unknown");
}

TEST(Names, AFigureOfCableIsTheMarkInThePipe) {
    int counted = 0;
    for (int code = 0; code <= static_cast<int>(BRIDGE_ORDER_CANCEL); ++code) {
        const auto order = static_cast<BridgeOrderCode>(code);
        if (value_unit(order) != "shackles") continue;
        ++counted;
        EXPECT_THAT(words(order, SIDE_PORT, 6), testing::EndsWith(" 6 shackles in the pipe"));
        EXPECT_THAT(words(order, SIDE_PORT, 1), testing::EndsWith(" 1 shackle in the pipe"));
    }
    EXPECT_EQ(counted, 5);
    EXPECT_EQ(words(BRIDGE_ORDER_WALK_OUT, SIDE_PORT, 33), "walk out port anchor to 33 m");
}

TEST(Names, ReportsAndOrdersAreSaidAsTheServerSaysThem) { // sentences_test has the sentences
    Report report;
    report.code(REPORT_LEAD);
    report.side(SIDE_PORT);
    report.lead(11);
    report.stay(STAY_GIVEN_SHORT);
    report.text() = "in his own words";
    EXPECT_EQ(words(report), "port cable is leading 11 o'clock, short stay, in his own words");
    report = {};
    report.code(REPORT_ORDER_REPEATED);
    report.order_code(BRIDGE_ORDER_HOLD_ON);
    report.side(SIDE_STARBOARD);
    report.value(6);
    EXPECT_EQ(words(report), "repeats: hold on starboard cable at 6 shackles in the pipe");
    BridgeOrder order;
    order.code(BRIDGE_ORDER_TEXT);
    order.text() = "mind the buoy";
    EXPECT_EQ(words(order), "mind the buoy");
    order.code(BRIDGE_ORDER_HOLD_ON);
    order.side(SIDE_PORT);
    EXPECT_EQ(words(order), "hold on port cable, mind the buoy");
    order.code(static_cast<BridgeOrderCode>(99));
    order.text() = "";
    EXPECT_EQ(words(order), "unknown order");
}

} // namespace
} // namespace windlass::station
