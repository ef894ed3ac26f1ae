// What men do by hand at a windlass: a cable that is broken on deck and slipped, an anchor that is cleared, a
// drive that is fed by the other windlass.

#include "rigs/drill.hpp"
#include "server/exercise/tick/anchor_party.hpp"

#include <gtest/gtest.h>

namespace windlass::exercise {
namespace {

using rigs::Drill;
using rigs::quiet_def;
using words::DeckHindrance;

void set_men(Drill& drill, DeckWork work) {
    drill.give(DeckWorkOrder{Side::port, work});
    drill.run(1);
}

DeckHindrance waits(const Drill& drill) {
    return drill.now().tackle[0].deck_work.waits;
}

constexpr double kMarkOnDeck = 4; // m inboard of the lip

/// The second joining shackle on deck, and the weight on the stopper.
Drill on_the_stopper() {
    Drill drill(quiet_def(60, 2 * physics::kShackleLength - kMarkOnDeck));
    drill.stopper(true);
    drill.run(2);
    drill.brake(0);
    drill.run(20);
    return drill;
}

} // namespace

TEST(AnchorParty, BreaksTheCableWhereItRestsOnTheStopperAndSlipsIt) {
    Drill drill = on_the_stopper();
    const double out = drill.chain().cable_out;
    set_men(drill, DeckWork::break_cable);
    EXPECT_EQ(waits(drill), DeckHindrance::none);
    ASSERT_TRUE(drill.run_until_event("cable.buoyed", 200));
    ASSERT_TRUE(drill.run_until_event("cable.broken", 500));
    EXPECT_NEAR(drill.now().time - drill.first("deck_work.begun")->time,
                deck_work_time(DeckWork::break_cable), 0.1);

    // The slip holds what the stopper held, whatever the levers are.
    drill.stopper(false);
    drill.clutch(true);
    drill.speed_lever(1);
    drill.run(30);
    EXPECT_NEAR(drill.chain().cable_out, out, 0.2);
    EXPECT_GT(drill.windlass().hawse_tension, 1e4);

    set_men(drill, DeckWork::slip);
    ASSERT_TRUE(drill.run_until_event("cable.slipped", 10));
    drill.run(10);
    EXPECT_EQ(drill.anchor().phase, AnchorPhase::lost);
    EXPECT_LT(drill.now().tackle[0].force.norm(), 2000) << "the half link that is left in the pipe";
    EXPECT_EQ(drill.count("cable.lost") + drill.count("cable.bitter_end"), 0);
    EXPECT_EQ(drill.count("cable.bitter_end_parted"), 0);
}

TEST(AnchorParty, WaitsUntilTheWeightIsOffTheBrakeAndAShackleOnDeck) {
    Drill drill(quiet_def(60, 2 * physics::kShackleLength - kMarkOnDeck));
    set_men(drill, DeckWork::break_cable);
    EXPECT_EQ(waits(drill), DeckHindrance::stopper_off);
    drill.stopper(true);
    drill.run(2);
    EXPECT_EQ(waits(drill), DeckHindrance::weight_on_brake);
    drill.brake(0);
    drill.run(20);
    EXPECT_EQ(waits(drill), DeckHindrance::none);
    EXPECT_EQ(drill.count("deck_work.waits"), 2 + drill.count("deck_work.endangered"));

    Drill none(quiet_def(60, 1.5 * physics::kShackleLength));
    none.stopper(true);
    none.run(2);
    none.brake(0);
    none.run(20);
    set_men(none, DeckWork::break_cable);
    EXPECT_EQ(waits(none), DeckHindrance::no_shackle_on_deck);
    set_men(none, DeckWork::slip);
    EXPECT_EQ(waits(none), DeckHindrance::not_broken);
    set_men(none, DeckWork::clear_anchor);
    EXPECT_EQ(waits(none), DeckHindrance::brake_off);
    set_men(none, DeckWork::cross_connect);
    EXPECT_EQ(waits(none), DeckHindrance::not_hydraulic);
}

TEST(AnchorParty, IsEndangeredByACableThatMovesUnderItsHands) {
    Drill drill = on_the_stopper();
    set_men(drill, DeckWork::break_cable);
    drill.run(60);
    EXPECT_EQ(drill.count("deck_work.endangered"), 0);
    drill.clutch(true);
    ASSERT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60));
    drill.speed_lever(0.5);
    drill.run(10);
    EXPECT_EQ(drill.count("deck_work.endangered"), 1);
}

TEST(AnchorParty, FeedsAHydraulicWindlassFromTheOtherOnesPumpsAtHalfItsSpeed) {
    const auto heaved = [](bool dead, bool other_dead) {
        ExerciseDef def = quiet_def(60, 50);
        physics::WindlassDef& windlass = def.tackle[0].windlass;
        windlass.drive = physics::DriveKind::hydraulic;
        windlass.hydraulic_pumps = 2;
        windlass.hydraulic_pump_flow = 0.0068;
        windlass.hydraulic_relief = 1.3e7;
        windlass.hydraulic_counterbalance = 1.7e7;
        windlass.hydraulic_displacement = 0.00178;
        windlass.hydraulic_leakage = 1.6e-10;
        Drill drill(def);
        if (dead) drill.fault(FaultCode::motor_power_lost);
        if (other_dead)
            drill.give(
                FaultOrder{.code = FaultCode::motor_power_lost, .side = Side::starboard, .severity = 1});
        if (dead) set_men(drill, DeckWork::cross_connect);
        drill.run(deck_work_time(DeckWork::cross_connect));
        EXPECT_EQ(drill.windlass().power, !other_dead);
        drill.clutch(true);
        drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60);
        drill.brake(0);
        drill.run(8);
        drill.speed_lever(1);
        drill.run(20);
        return -drill.windlass().cable_speed;
    };
    const double sound = heaved(false, false);
    EXPECT_GT(sound, 0.1);
    // One pump's flow less the same leakage: a little less than half.
    EXPECT_NEAR(heaved(true, false), 0.5 * sound, 0.08 * sound);
    EXPECT_LT(heaved(true, true), 0.01);
}

} // namespace windlass::exercise
