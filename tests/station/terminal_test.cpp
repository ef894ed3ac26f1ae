// What the stations show: one line, JSON, the summary.

#include "idl/idl_text.hpp"
#include "station/json_view.hpp"
#include "station/line_view.hpp"
#include "station/names.hpp"
#include "station/summary.hpp"
#include "tests/station/anchored_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numbers>

namespace windlass::station {
namespace {

using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;

TEST(LineView, TellsTheWholeSituationInOneLine) {
    const std::string text = line(anchored(), SIDE_PORT, kNow, Onlooker::instructor);
    for (const char* part :
         {"2:05", "running", "x8", "port", "165 m", "6.0 shackles", "443 kN (45 t) 10 %", "brake 85 %",
          "180 degC", "clutch out", "holding", "11 o'clock", "medium stay", "0.6 kn"})
        EXPECT_THAT(text, HasSubstr(part));
    EXPECT_THAT(text, Not(HasSubstr("\n")));
    EXPECT_THAT(text, Not(HasSubstr("NO DATA")));
}

TEST(LineView, SaysSinceWhenTheDataAreOld) {
    EXPECT_THAT(line(anchored(), SIDE_PORT, kNow + 12s, Onlooker::instructor), HasSubstr("NO DATA FOR 12 s"));
    EXPECT_THAT(line(Picture{}, SIDE_PORT, kNow, Onlooker::instructor), HasSubstr("no server"));
}

TEST(LineView, EventsWorseThanInfoSayHowBad) {
    EXPECT_EQ(line(event(1, "anchor.brought_up", "Brought up")), "2:05 * port: Brought up");
    EXPECT_EQ(line(event(1, "brake.hot", "Brake hot", EVENT_WARNING)), "2:05 * WARNING: port: Brake hot");
}

TEST(LineView, EventsSayWhichWindlassUnlessTheirTextDoes) {
    Event starboard = event(1, "anchor.let_go", "anchor let go");
    starboard.side(SIDE_STARBOARD);
    EXPECT_EQ(line(starboard), "2:05 * starboard: anchor let go");
    EXPECT_EQ(line(event(1, "levers.taken", "ann has the port windlass")),
              "2:05 * ann has the port windlass");
    Event of_none = event(1, "exercise.started", "exercise started");
    of_none.side(-1);
    EXPECT_EQ(line(of_none), "2:05 * exercise started");
}

TEST(LineView, TimeIsThatOfTheNewestSample) {
    Picture picture = anchored();
    WindlassLoad load = *picture.tackle[0].load;
    load.time(126);
    picture.receive(load, kNow + 10ms);
    EXPECT_THAT(line(picture, SIDE_PORT, kNow, Onlooker::instructor), testing::StartsWith("2:06 running"));
    EXPECT_THAT(line(picture, SIDE_STARBOARD, kNow, Onlooker::instructor),
                testing::StartsWith("2:05 running"));
    // Begun again without that windlass: what was last heard of it is of another time.
    ExerciseStatus status = *picture.status;
    status.time(3);
    picture.receive(status, kNow + 2s);
    EXPECT_THAT(line(picture, SIDE_PORT, kNow, Onlooker::instructor), testing::StartsWith("0:03 running"));
}

TEST(Picture, PausedExerciseIsNotSilent) {
    Picture picture = anchored();
    ExerciseStatus status = *picture.status;
    picture.receive(status, kNow + 5s);
    EXPECT_NEAR(*picture.silence(kNow + 5s), 5, 1e-9); // running, but the loads stopped
    status.state(RUN_PAUSED);
    picture.receive(status, kNow + 5s);
    EXPECT_NEAR(*picture.silence(kNow + 5s), 0, 1e-9);
    EXPECT_FALSE(Picture{}.silence(kNow));
}

TEST(Picture, RunThatBeginsAgainForgetsEventsAndExtremes) {
    Picture picture = anchored();
    picture.receive(event(1, "a.b", "first"), kNow);
    picture.receive(event(2, "a.b", "second"), kNow);
    EXPECT_EQ(picture.events.kept.size(), 2U);
    EXPECT_EQ(picture.tackle[0].extremes.hawse_tension, 443000);
    picture.receive(event(1, "a.b", "again"), kNow);
    EXPECT_EQ(picture.events.kept.size(), 1U);
    EXPECT_EQ(picture.events.received, 3U);
    EXPECT_EQ(picture.events.after(2).size(), 1U);
    WindlassLoad load;
    load.tick(3);
    load.hawse_tension(1000);
    picture.receive(load, kNow);
    EXPECT_EQ(picture.tackle[0].extremes.hawse_tension, 1000);
}

// Each seat's events are counted by themselves, and each begins anew with the run.
TEST(Picture, OfBothSeatsHasWhatBothNoticeOnceAndForgetsAnEarlierRunOfEach) {
    Picture picture;
    const auto tell = [&](std::uint64_t forecastle, std::uint64_t bridge) {
        SeatEvent noticed;
        noticed.forecastle(forecastle > 0);
        noticed.bridge(bridge > 0);
        noticed.number(forecastle);
        if (forecastle > 0) picture.take_forecastle_event(noticed, kNow);
        noticed.number(bridge);
        if (bridge > 0) picture.take_event_beside(noticed, kNow);
    };
    const auto kept = [&] {
        return std::pair(picture.seat_events[0].kept.size(), picture.seat_events[1].kept.size());
    };
    tell(1, 1), tell(2, 0), tell(0, 2), tell(3, 3);
    EXPECT_EQ(kept(), std::pair(std::size_t{3}, std::size_t{1}));
    tell(1, 1);
    EXPECT_EQ(kept(), std::pair(std::size_t{1}, std::size_t{0}));
}

TEST(Picture, KeepsTheLatestEventsAndDropsTheOldest) {
    Picture picture;
    for (std::uint64_t number = 1; number <= EventLog<Event>::kKept + 10; ++number)
        picture.receive(event(number, "a.b", ""), kNow);
    EXPECT_EQ(picture.events.kept.size(), EventLog<Event>::kKept);
    EXPECT_EQ(picture.events.kept.front().number(), 11U);
}

TEST(Picture, SampleOfAnUnknownSideIsDropped) {
    Picture picture;
    WindlassLoad load;
    ForecastleView view;
    for (const int side : {-1, 2, 1 << 30}) {
        load.side(side);
        picture.receive(load, kNow);
        view.side(side);
        picture.receive(view, kNow);
    }
    EXPECT_FALSE(picture.tackle[0].view);
    EXPECT_FALSE(picture.tackle[0].load);
    EXPECT_FALSE(picture.tackle[1].load);
}

TEST(Picture, AlertsStandUntilTheyAreNormal) {
    Picture picture;
    Alert alert;
    alert.code() = "brake.hot";
    alert.side(SIDE_PORT);
    alert.condition(ALERT_ACTIVE_UNACKNOWLEDGED);
    picture.receive(alert, kNow);
    alert.condition(ALERT_ACTIVE_ACKNOWLEDGED);
    picture.receive(alert, kNow);
    ASSERT_EQ(picture.alerts.size(), 1U);
    EXPECT_EQ(picture.alerts[0].condition(), ALERT_ACTIVE_ACKNOWLEDGED);
    alert.condition(ALERT_NORMAL);
    picture.receive(alert, kNow);
    EXPECT_TRUE(picture.alerts.empty());
}

/// A counter that has missed pulses and a load cell that is dead.
Picture deceived() {
    Picture picture = anchored();
    ChainState chain = *picture.tackle[0].chain;
    chain.stretched(3.084);
    chain.stretch(0.052);
    chain.marks({mark(1, 137, -25), mark(2, 110, -25), mark(3, 3, 2.5), mark(4, -2, 6), mark(5, -27, 6)});
    picture.receive(chain, kNow);
    WindlassLoad load = *picture.tackle[0].load;
    load.cable_out(165);
    load.cable_out_indicated(140.2);
    load.gypsy_load_indicated(0);
    picture.receive(load, kNow);
    AnchorState anchor = *picture.tackle[0].anchor;
    anchor.soil(SOIL_CLAY);
    anchor.fluke_angle(std::numbers::pi / 4);
    anchor.embedment(0.8);
    anchor.holding_used(200e3);
    anchor.breakout(196.133e3);
    anchor.bent(0.3);
    picture.receive(anchor, kNow);
    return picture;
}

TEST(Anchor, AtTheHawseLeavesNoCableThatLeadsAnywhere) {
    TacklePicture tackle;
    EXPECT_TRUE(leads(tackle));
    tackle.anchor.at = Clock::time_point{};
    AnchorState anchor;
    for (const auto& [phase, leads_then] : {std::pair{ANCHOR_HOUSED, false},
                                            {ANCHOR_ACOCKBILL, false},
                                            {ANCHOR_HANGING, true},
                                            {ANCHOR_HOLDING, true}}) {
        anchor.phase(phase);
        tackle.anchor.sample = anchor;
        EXPECT_EQ(leads(tackle), leads_then) << name(phase);
    }
}

TEST(LineView, TellsASeatWhatItIsGiven) {
    Picture picture = deceived();
    give_views(picture);
    const std::string text = line(picture, SIDE_PORT, kNow, Onlooker::seat);
    EXPECT_EQ(
        text,
        "2:05 running x8  port 140 m 5.1 shackles  stopped  load 0 kN (0.0 t) 0 %  brake 85 % hot, smells"
        "  clutch out  under water, 11 o'clock, medium stay  ship 0.6 kn heading 090");
}

TEST(LineView, StayIsTheServersClassOfTheAngleSeen) {
    for (const auto& [degrees, stay] : {std::pair{90, "up and down"},
                                        {80, "up and down"},
                                        {70, "short stay"},
                                        {60, "short stay"},
                                        {40, "medium stay"},
                                        {20, "long stay"}}) {
        ForecastleView view;
        view.top_angle(degrees * kDegree);
        EXPECT_THAT(lead_and_stay(view), HasSubstr(stay)) << degrees;
    }
}

TEST(LineView, AlertsAndOrdersSayHowTheyStand) {
    Alert alert;
    alert.code() = "windlass.tripped";
    alert.side(SIDE_PORT);
    alert.raised_time(125);
    alert.priority(ALERT_ALARM);
    alert.condition(ALERT_ACTIVE_SILENCED);
    alert.text() = "Drive tripped";
    EXPECT_EQ(line(alert), "2:05 ALARM: port: Drive tripped (windlass.tripped, silenced)");
    EXPECT_EQ(line(order(3, BRIDGE_ORDER_HOLD_ON, 0, ORDER_NOT_REPEATED)),
              "2:00 # order 3: hold on port cable (not repeated)");
}

TEST(Picture, InstructorHasTheLeversWhileHeSpeaks) {
    Picture picture = exercise_heard();
    WindlassCommand instructor;
    instructor.origin().source() = "instructor";
    picture.take_instructor(instructor, kNow + 50ms);
    WindlassCommand trainee = *picture.tackle[0].levers;
    picture.receive(trainee, kNow + 100ms);
    const auto holder = [&] { return picture.tackle[0].levers_in_force()->origin().source().to_string(); };
    EXPECT_EQ(holder(), "instructor");
    picture.receive(trainee, kNow + 1051ms); // and not a word of the instructor for a second
    EXPECT_EQ(holder(), "trainee-1");
}

TEST(Picture, OrdersAreOfTheLatestRunAndTheNewestIsRepeatedFirst) {
    Picture picture = exercise_heard();
    EXPECT_EQ(picture.order_to_repeat(), nullptr);
    picture.receive(order(2, BRIDGE_ORDER_LET_GO, 0), kNow);
    picture.receive(order(1, BRIDGE_ORDER_STAND_BY, 0, ORDER_MISREPEATED), kNow);
    EXPECT_EQ(picture.order_to_repeat()->number(), 2);
    picture.receive(order(2, BRIDGE_ORDER_LET_GO, 0, ORDER_REPEATED), kNow);
    EXPECT_EQ(picture.order_to_repeat()->number(), 1);
    EXPECT_EQ(picture.orders.size(), 2U);
    BridgeOrder again = order(1, BRIDGE_ORDER_SECURE, 0);
    again.run(7);
    picture.receive(again, kNow);
    ASSERT_EQ(picture.orders.size(), 1U);
    EXPECT_EQ(picture.order_to_repeat(), nullptr); // the exercise that is shown is another run
    picture.receive(order(2, BRIDGE_ORDER_LET_GO, 0), kNow);
    EXPECT_EQ(picture.orders.size(), 1U);
}

TEST(Names, EveryEnumeratorHasOne) {
    EXPECT_EQ(name(REPORT_DEFECT), "defect");
    EXPECT_EQ(name(TRIGGER_AT_CHANCE), "at_chance");
    EXPECT_EQ(name(BRIDGE_ORDER_CANCEL), "cancel");
    EXPECT_EQ(bridge_order_code("hold-on"), BRIDGE_ORDER_HOLD_ON);
    EXPECT_EQ(stay_given("not_given"), std::nullopt);
    EXPECT_EQ(stay_given("long"), STAY_GIVEN_LONG);
    EXPECT_EQ(cable_weight("too_much"), WEIGHT_TOO_MUCH);
    EXPECT_EQ(growing("tight"), GROWING_TIGHT);
}

TEST(Summary, ComparesLoadsWithBreakingLoadAndBrakeRating) {
    Picture picture = anchored();
    WindlassLoad later = *picture.tackle[0].load;
    later.tick(40000);
    later.time(133);
    later.hawse_tension(100000); // less than before: the largest stands
    later.cable_speed(4.25);
    picture.receive(later, kNow);
    const Summary summary = summarise(picture, SIDE_PORT);
    EXPECT_EQ(summary.largest_load, 443000);
    EXPECT_EQ(summary.largest_load_time, 125);
    EXPECT_EQ(summary.largest_pay_out_speed, 4.25);
    const std::string text = to_text(summary);
    for (const char* part : {"165.0 m, 6.0 shackles", "443 kN (45 t) at 2:05, 10 % of the breaking load",
                             "15 % of the brake rating", "4.25 m/s", "3.1 MJ, lining at most 180 degC"})
        EXPECT_THAT(text, HasSubstr(part));
    EXPECT_THAT(text, Not(HasSubstr("stretched")));
    EXPECT_EQ(to_json(summary).at("brake_rating"), 2050000);
}

TEST(Summary, TellsOfACableThatIsStretched) {
    const Summary summary = summarise(deceived(), SIDE_PORT);
    EXPECT_THAT(to_text(summary), HasSubstr("3.08 m, a link by 5.2 % at most"));
    EXPECT_EQ(to_json(summary).at("stretched"), 3.084);
}

TEST(Summary, OfASeatIsWhatTheSeatCouldTell) {
    Picture picture = anchored_seen();
    ForecastleView later = *picture.tackle[0].view;
    later.tick(40000);
    later.time(133);
    later.gypsy_load_indicated(443000);
    later.cable_speed_indicated(4.25);
    picture.receive(later, kNow);
    later.tick(40010);
    later.gypsy_load_indicated(0);
    later.lining(LINING_WARM);
    picture.receive(later, kNow);
    const SeatSummary summary = summarise_seat(picture, SIDE_PORT);
    const std::string text = to_text(summary);
    for (const char* part : {"under water", "140.2 m, 5.1 shackles",
                             "443 kN (45 t) at 2:13, 10 % of the breaking", "4.25 m/s", "hot, smells"})
        EXPECT_THAT(text, HasSubstr(part));
    EXPECT_EQ(to_json(summary).at("largest_load_indicated"), 443000);
    EXPECT_FALSE(to_json(summary).contains("cable_out"));
}

TEST(JsonView, OfATraineeHasNothingOfTheTruth) {
    const auto object = to_json(anchored_seen(), kNow);
    EXPECT_EQ(object.at("port").at("forecastle").at("cable_out_indicated"), 140.2);
    EXPECT_EQ(object.at("port").at("forecastle").at("marks").size(), 2U);
    EXPECT_EQ(object.at("bridge").at("depth_below_keel"), 12.3);
    for (const char* truth : {"truth", "environment", "ship"})
        EXPECT_FALSE(object.contains(truth)) << truth;
    for (const char* truth : {"anchor", "chain", "windlass"})
        EXPECT_FALSE(object.at("port").contains(truth)) << truth;
}

TEST(JsonView, HoldsWhatWasHeardAndNothingElse) {
    const auto object = to_json(anchored(), kNow);
    EXPECT_EQ(object.at("status").at("state"), "RUN_RUNNING");
    EXPECT_EQ(object.at("port").at("chain").at("cable_out"), 165);
    EXPECT_EQ(object.at("port").at("levers").at("origin").at("source"), "trainee-1");
    EXPECT_FALSE(object.contains("starboard"));
    EXPECT_TRUE(to_json(Picture{}, kNow).empty());
}

/// Every member of the IDL's type, and of those in it, under its name.
void expect_whole(const nlohmann::json& object, const idl::Type& type, const std::string& where) {
    EXPECT_EQ(object.size(), type.members.size()) << where;
    for (const idl::Member& member : type.members) {
        const std::string place = where + "." + member.name;
        ASSERT_TRUE(object.contains(member.name)) << place;
        const nlohmann::json& value = object[member.name];
        if (member.sequence)
            EXPECT_TRUE(value.is_array()) << place;
        else if (member.type->kind == idl::Kind::structure)
            expect_whole(value, *member.type, place);
    }
}

TEST(JsonView, HasEveryFieldOfTheIdl) {
    Picture picture;
    const auto receive = [&](auto sample) { picture.receive(sample, kNow); };
    receive(ExerciseStatus()), receive(ExerciseTruth()), receive(EnvironmentState()), receive(ShipState());
    receive(BridgeView()), receive(ForecastleView()), receive(AnchorState()), receive(ChainState());
    receive(WindlassLoad()), receive(WindlassCommand()), receive(HelmCommand()), receive(Alert()),
        receive(BridgeOrder());
    const auto object = to_json(picture, kNow);
    expect_whole(object.at("status"), idl::own_type<ExerciseStatus>(), "status");
    expect_whole(object.at("truth"), idl::own_type<ExerciseTruth>(), "truth");
    expect_whole(object.at("environment"), idl::own_type<EnvironmentState>(), "environment");
    expect_whole(object.at("ship"), idl::own_type<ShipState>(), "ship");
    expect_whole(object.at("bridge"), idl::own_type<BridgeView>(), "bridge");
    expect_whole(object.at("helm"), idl::own_type<HelmCommand>(), "helm");
    expect_whole(object.at("alerts").at(0), idl::own_type<Alert>(), "alerts");
    expect_whole(object.at("orders").at(0), idl::own_type<BridgeOrder>(), "orders");
    const auto& port = object.at("port");
    expect_whole(port.at("forecastle"), idl::own_type<ForecastleView>(), "forecastle");
    expect_whole(port.at("anchor"), idl::own_type<AnchorState>(), "anchor");
    expect_whole(port.at("chain"), idl::own_type<ChainState>(), "chain");
    expect_whole(port.at("windlass"), idl::own_type<WindlassLoad>(), "windlass");
    expect_whole(port.at("levers"), idl::own_type<WindlassCommand>(), "levers");
    expect_whole(to_json(Event()), idl::own_type<Event>(), "event");
    expect_whole(to_json(SeatEvent()), idl::own_type<SeatEvent>(), "seat_event");
}

TEST(JsonView, KeepsAllBitsOfAHashForReadersThatHaveDoublesOnly) {
    ExerciseTruth truth;
    truth.state_hash(0xFFFFFFFFFFFFFFFFULL);
    EXPECT_EQ(to_json(truth).at("state_hash"), "18446744073709551615");
}

} // namespace
} // namespace windlass::station
