// The bridge orders, the forecastle repeats back and reports, the anchor watch is kept.

#include "server/exercise/checkpoint.hpp"
#include "server/exercise/talk/bridge_orders.hpp"
#include "server/exercise/talk/lights_and_shapes.hpp"
#include "server/exercise/talk/talk.hpp"
#include "server/exercise/watch/watch_circle.hpp"

#include "rigs/drill.hpp"
#include "words/words.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::exercise {
using namespace rigs;

namespace {

Drill lying_still() {
    return Drill(quiet_def(25, 5));
}

BridgeOrderGiven pay_out_port(double shackles) {
    return {.code = BridgeOrderCode::pay_out, .side = 0, .value = shackles, .by = "conning"};
}

ReportMade repeated(int number, double shackles, int side = 0) {
    return {.code = ReportCode::order_repeated,
            .side = side,
            .value = shackles,
            .order_number = number,
            .order_code = BridgeOrderCode::pay_out};
}

BridgeOrderState state(const Drill& drill, int number) {
    for (const BridgeOrderView& order : drill.now().bridge_orders)
        if (order.number == number) return order.state;
    ADD_FAILURE() << "no order " << number;
    return {};
}

TEST(BridgeOrders, AreNumberedFromOneAndHaveTheDeadlinesOfTheirCode) {
    Drill drill = lying_still();
    drill.run(1);
    drill.give(pay_out_port(3));
    drill.give(BridgeOrderGiven{.code = BridgeOrderCode::let_go, .side = 0, .repeat_within = 7});
    drill.tick();
    const auto& orders = drill.now().bridge_orders;
    ASSERT_EQ(orders.size(), 2U);
    EXPECT_EQ(orders[0].number, 1);
    EXPECT_EQ(orders[1].number, 2);
    EXPECT_DOUBLE_EQ(orders[0].repeat_by, 1 + 10);
    EXPECT_DOUBLE_EQ(orders[0].do_by, 1 + 90);
    EXPECT_DOUBLE_EQ(orders[1].repeat_by, 1 + 7);
    EXPECT_DOUBLE_EQ(orders[1].do_by, 1 + 5);
    EXPECT_EQ(orders[0].given.by, "conning");
    EXPECT_EQ(drill.count("order.given"), 2);
    EXPECT_EQ(drill.first("order.given")->text,
              "order 1 given: pay out port cable to 3 shackles in the pipe");
}

TEST(BridgeOrders, OneRepeatedWithItsCodeSideAndValueIsRepeated) {
    Drill drill = lying_still();
    drill.give(pay_out_port(3));
    drill.run(2);
    drill.give(repeated(1, 3));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::repeated);
    EXPECT_EQ(drill.count("order.repeated"), 1);
    drill.run(20); // past the deadline
    EXPECT_EQ(state(drill, 1), BridgeOrderState::repeated);
    EXPECT_EQ(drill.count("order.not_repeated"), 0);
}

TEST(BridgeOrders, OneRepeatedWithAnotherFigureOrSideStaysOpenAndCanBeCorrected) {
    Drill drill = lying_still();
    drill.give(pay_out_port(3));
    drill.give(repeated(1, 4));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::misrepeated);
    drill.give(repeated(1, 3, 1));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::misrepeated);
    EXPECT_EQ(drill.count("order.misrepeated"), 2);
    drill.give(repeated(1, 3));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::repeated);
}

TEST(BridgeOrders, OneNotRepeatedByItsDeadlineIsCalledOnceAndStaysOpen) {
    Drill drill = lying_still();
    drill.give(pay_out_port(3));
    ASSERT_TRUE(drill.run_until_event("order.not_repeated", 12));
    EXPECT_NEAR(drill.now().time, 10, 0.01);
    drill.run(3);
    EXPECT_EQ(drill.count("order.not_repeated"), 1);
    drill.give(repeated(1, 3));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::repeated);
}

// Who repeats what he has heard need not know how often it was said while he thought.
TEST(BridgeOrders, OneGivenAgainIsRepeatedByWhoeverRepeatsAnyOfThem) {
    Drill drill = lying_still();
    BridgeOrderGiven again = pay_out_port(3);
    again.text = "I say again";
    drill.give(pay_out_port(3));
    drill.give(pay_out_port(4));
    drill.give(again);
    drill.give(repeated(1, 2));
    drill.tick();
    EXPECT_EQ(state(drill, 3), BridgeOrderState::misrepeated);
    EXPECT_EQ(state(drill, 2), BridgeOrderState::given);
    drill.give(repeated(1, 3));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::repeated);
    EXPECT_EQ(state(drill, 3), BridgeOrderState::repeated);
    EXPECT_EQ(state(drill, 2), BridgeOrderState::given) << "another figure";
    EXPECT_EQ(drill.count("order.repeated"), 1) << "it was said once";
}

TEST(BridgeOrders, OneInOwnWordsIsNotAnotherOne) {
    Drill drill = lying_still();
    for (const char* text : {"check her at four", "slack the stopper", "I say again: check her at four"})
        drill.give(BridgeOrderGiven{.code = BridgeOrderCode::text, .text = text});
    drill.give(ReportMade{.code = ReportCode::order_repeated, .order_number = 1});
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::repeated);
    EXPECT_EQ(state(drill, 2), BridgeOrderState::given);
    EXPECT_EQ(state(drill, 3), BridgeOrderState::repeated);
}

TEST(BridgeOrders, AQuestionNeedNotBeRepeated) {
    Drill drill = lying_still();
    drill.give(BridgeOrderGiven{.code = BridgeOrderCode::how_leading, .side = 0});
    drill.run(20);
    EXPECT_EQ(state(drill, 1), BridgeOrderState::given);
    EXPECT_DOUBLE_EQ(drill.now().bridge_orders[0].do_by, 15);
}

TEST(BridgeOrders, OneTakenBackIsCancelledFromAnyState) {
    Drill drill = lying_still();
    drill.give(pay_out_port(3));
    drill.give(repeated(1, 3));
    drill.give(BridgeOrderGiven{.code = BridgeOrderCode::cancel, .side = -1, .cancels = 1});
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::cancelled);
    EXPECT_EQ(state(drill, 2), BridgeOrderState::given);
    EXPECT_EQ(drill.count("order.cancelled"), 1);
    drill.give(repeated(1, 3));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::cancelled);
}

TEST(BridgeOrders, OfTooManyTheOldestAreForgotten) {
    Drill drill = lying_still();
    for (int k = 0; k < 230; ++k)
        drill.give(BridgeOrderGiven{.code = BridgeOrderCode::text, .text = "steady"});
    drill.tick();
    const auto& orders = drill.now().bridge_orders;
    ASSERT_EQ(orders.size(), BridgeOrders::kKept);
    EXPECT_EQ(orders.front().number, 31);
    EXPECT_EQ(orders.back().number, 230);
}

TEST(BridgeOrders, OrdersAndAnchorWatchAreKeptInACheckpoint) {
    Drill drill = lying_still();
    drill.give(pay_out_port(3));
    drill.give(WatchCircleOrder{true, 0, 0, 150});
    drill.run(1);
    Exercise& live = drill.exercise();
    Exercise read = read_checkpoint(write_checkpoint(live));
    EXPECT_TRUE(differences(live, read).empty());
    Snapshot snapshot;
    read.view(snapshot);
    ASSERT_EQ(snapshot.bridge_orders.size(), 1U);
    EXPECT_EQ(snapshot.bridge_orders[0].given.value, 3);
    EXPECT_TRUE(snapshot.watch_circle.kept);
}

TEST(LightsAndShapes, AreWhatTheBridgeLastOrderedAndEachChangeIsLogged) {
    Drill drill = lying_still();
    drill.tick();
    EXPECT_FALSE(drill.now().lights_and_shapes.anchor_ball);
    EXPECT_FALSE(drill.now().lights_and_shapes.anchor_lights);
    drill.give(LightsAndShapes{.anchor_ball = true});
    drill.tick();
    EXPECT_TRUE(drill.now().lights_and_shapes.anchor_ball);
    EXPECT_EQ(drill.first("signals.anchor_ball")->text, "anchor ball hoisted");
    EXPECT_EQ(drill.count("signals.anchor_lights"), 0);
    drill.give(LightsAndShapes{.anchor_ball = true}); // as it is: nothing to tell
    drill.give(LightsAndShapes{.anchor_lights = true});
    drill.tick();
    EXPECT_FALSE(drill.now().lights_and_shapes.anchor_ball);
    EXPECT_TRUE(drill.now().lights_and_shapes.anchor_lights);
    EXPECT_EQ(drill.count("signals.anchor_ball"), 2);
    EXPECT_EQ(drill.count("signals.anchor_lights"), 1);
}

TEST(LightsAndShapes, BurnOnInABlackout) { // on the emergency source: SOLAS II-1/43
    Drill drill = lying_still();
    drill.give(LightsAndShapes{.anchor_lights = true});
    drill.give(FaultOrder{.code = FaultCode::ship_blackout, .severity = 1});
    drill.run(60);
    EXPECT_TRUE(drill.now().lights_and_shapes.anchor_lights);
}

TEST(LightsAndShapes, AreKeptInACheckpoint) {
    Drill drill = lying_still();
    drill.give(LightsAndShapes{.anchor_ball = true, .anchor_lights = true});
    drill.tick();
    Exercise read = read_checkpoint(write_checkpoint(drill.exercise()));
    EXPECT_TRUE(differences(drill.exercise(), read).empty());
    Snapshot snapshot;
    read.view(snapshot);
    EXPECT_TRUE(snapshot.lights_and_shapes.anchor_ball && snapshot.lights_and_shapes.anchor_lights);
}

TEST(LightsAndShapes, OfAShipAtAnchorAreABallByDayAndLightsFromSunsetToSunrise) { // COLREG 72, rules 20, 30
    constexpr double kHour = 3600;
    for (const double hour : {6.5, 12.0, 17.5}) {
        EXPECT_TRUE(at_anchor_by(hour * kHour).anchor_ball) << hour;
        EXPECT_FALSE(at_anchor_by(hour * kHour).anchor_lights) << hour;
    }
    for (const double hour : {0.0, 5.5, 18.5, 23.9}) {
        EXPECT_FALSE(at_anchor_by(hour * kHour).anchor_ball) << hour;
        EXPECT_TRUE(at_anchor_by(hour * kHour).anchor_lights) << hour;
    }
}

TEST(Reports, AreLoggedByWhatWasEnteredAndNothingElse) {
    const auto line = [](const ReportMade& report) {
        Drill drill = lying_still();
        drill.give(report);
        drill.tick();
        return drill.first("report.made")->text;
    };
    EXPECT_EQ(line({.code = ReportCode::shackles_on_deck, .side = 0, .value = 3}),
              "reported: 3 shackles on deck");
    EXPECT_EQ(line({.code = ReportCode::lead, .side = 0}), "reported: port cable is leading");
    EXPECT_EQ(line({.code = ReportCode::lead, .side = 0, .lead = 2, .stay = StayGiven::long_stay}),
              "reported: port cable is leading 2 o'clock, long stay");
    EXPECT_EQ(line({.code = ReportCode::weight, .side = 0, .weight = CableWeight::too_much, .text = "stop"}),
              "reported: too much weight on port cable, stop");
    EXPECT_EQ(line(repeated(4, 3)),
              "reported: repeats: pay out port cable to 3 shackles in the pipe, to order 4");
    EXPECT_EQ(line({.code = ReportCode::text, .text = "all well"}), "reported: all well");
}

// ------------------------------------------------------------------ the VHF is lost

Drill without_vhf(double severity = 1) {
    Drill drill = lying_still();
    drill.give(FaultOrder{.code = FaultCode::vhf_lost, .severity = severity});
    drill.run(1);
    return drill;
}

TEST(WithoutVhf, AnOrderInWordsIsNotHeardAndWhoGaveItIsTold) {
    Drill drill = without_vhf();
    drill.give(pay_out_port(3));
    drill.give(BridgeOrderGiven{.code = BridgeOrderCode::text, .text = "mind the buoy"});
    drill.run(15); // past the deadline of an order that was heard
    EXPECT_TRUE(drill.now().bridge_orders.empty());
    EXPECT_EQ(drill.count("order.given"), 0);
    EXPECT_EQ(drill.count("order.not_heard"), 2);
    EXPECT_EQ(drill.count("order.not_repeated"), 0);
    EXPECT_EQ(drill.first("order.not_heard")->text,
              "no answer from the forecastle; ordered: pay out port cable to 3 shackles in the pipe");
    drill.clear(FaultCode::vhf_lost);
    drill.run(1);
    EXPECT_TRUE(drill.now().bridge_orders.empty()) << "what was not heard does not come later";
    drill.give(pay_out_port(3));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::given);
}

TEST(WithoutVhf, AHandSignalIsSeenAndRepeatedAndItsWordsAreLost) {
    Drill drill = without_vhf();
    drill.give(BridgeOrderGiven{.code = BridgeOrderCode::let_go, .side = 0, .text = "handsomely"});
    drill.tick();
    ASSERT_EQ(drill.now().bridge_orders.size(), 1U);
    EXPECT_EQ(drill.now().bridge_orders[0].given.text, kByHand);
    drill.give(ReportMade{.code = ReportCode::order_repeated,
                          .side = 0,
                          .order_number = 1,
                          .order_code = BridgeOrderCode::let_go});
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::repeated);
}

TEST(WithoutVhf, NoHandSignalIsSeenInFog) {
    Drill drill = without_vhf();
    EnvironmentOrder fog{drill.now().environment.now, 0};
    fog.weather.visibility = 100;
    drill.give(fog);
    drill.run(1);
    drill.give(BridgeOrderGiven{.code = BridgeOrderCode::let_go, .side = 0});
    drill.tick();
    EXPECT_TRUE(drill.now().bridge_orders.empty());
    EXPECT_EQ(drill.count("order.not_heard"), 1);
}

TEST(WithoutVhf, ARepeatOfWordsIsNotHeardAndTheOrderStaysOpen) {
    Drill drill = lying_still();
    drill.give(pay_out_port(3));
    drill.give(FaultOrder{.code = FaultCode::vhf_lost, .severity = 1});
    drill.run(1);
    drill.give(repeated(1, 3));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::given);
    EXPECT_EQ(drill.count("report.not_heard"), 1);
    EXPECT_EQ(drill.count("report.made"), 0);
}

// One stroke for each shackle, rung rapidly when she is aweigh: the custom of the service.
TEST(WithoutVhf, TheBellTellsShacklesAndAweighAndNothingElse) {
    const auto rung = [](const ReportMade& report) {
        Drill drill = without_vhf();
        drill.give(report);
        drill.tick();
        EXPECT_EQ(drill.count("report.not_heard"), 1);
        return drill.count("report.bell") == 1 ? drill.first("report.bell")->text : "";
    };
    EXPECT_EQ(rung({.code = ReportCode::shackles_on_deck, .side = 0, .value = 3}), "bell: 3 strokes");
    EXPECT_EQ(rung({.code = ReportCode::shackles_in_water, .side = 0, .value = 1}), "bell: 1 stroke");
    EXPECT_EQ(rung({.code = ReportCode::anchor_aweigh, .side = 0}), "bell: rung rapidly");
    EXPECT_EQ(rung({.code = ReportCode::brought_up, .side = 0}), "");
}

TEST(WithoutVhf, ASetThatIsOnlyPoorPassesEveryWord) {
    Drill drill = without_vhf(0.4);
    drill.give(pay_out_port(3));
    drill.give(repeated(1, 3));
    drill.tick();
    EXPECT_EQ(state(drill, 1), BridgeOrderState::repeated);
}

TEST(AnchorWatch, IsLeftWhenAnyCornerOfTheShipIsOutside) {
    ExerciseDef def = quiet_def(25, 5);
    def.ship_start.surge = 0.5;
    Drill drill(def);
    const double half = std::hypot(def.ship.length_overall, def.ship.beam) / 2;
    drill.give(WatchCircleOrder{true, 0, 0, half + 2});
    drill.run(1);
    EXPECT_FALSE(drill.now().outside_watch_circle);
    ASSERT_TRUE(drill.run_until_event("watch.circle", 20));
    EXPECT_TRUE(drill.now().outside_watch_circle);
    EXPECT_NEAR(drill.now().ship.position.y(), 2, 0.1); // ahead: her foremost corners
    drill.run(5);
    EXPECT_EQ(drill.count("watch.circle"), 1);
}

TEST(AnchorWatch, IsKeptAgainOnlyWellInsideTheCircle) {
    AnchorWatch watch;
    const EventLog log([](const words::Event&, int, double, const std::string&) {});
    physics::ShipState state;
    const physics::ShipDef def;
    const double half = farthest_corner(def, state, 0, 0);
    EXPECT_NEAR(half, std::hypot(def.length_overall, def.beam) / 2, 1e-9);
    watch.order({true, 0, 0, 1.05 * half}, log);
    const auto at = [&](double ahead) {
        state.y = ahead * half;
        watch.look(def, state, 1, log);
        return watch.outside();
    };
    EXPECT_FALSE(at(0.04));
    EXPECT_TRUE(at(0.06));
    EXPECT_TRUE(at(0.04)); // inside by 1 % of the radius: not yet
    EXPECT_FALSE(at(0.02));
    EXPECT_TRUE(at(0.06));
    watch.order({false, 0, 0, 0}, log);
    EXPECT_FALSE(at(1000));
}

} // namespace
} // namespace windlass::exercise
