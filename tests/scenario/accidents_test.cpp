// Accidents of the trade in pairs: brought about by a cause or by handling, and avoided by right handling
// with everything else the same. Nothing is scripted: each follows from loads, heat and strength.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace windlass::exercise {

using namespace rigs;

namespace {

/// Cable up and down in deep water on a hydraulic windlass, clutch in, brake off, lever at full hoist.
Drill heaving_hydraulic() {
    ExerciseDef def = quiet_def(200, 180);
    def.tackle[0].windlass.drive = physics::DriveKind::hydraulic;
    Drill drill(def);
    drill.run(1);
    drill.clutch(true);
    drill.run(1);
    drill.brake(0);
    drill.speed_lever(1);
    drill.run(3);
    return drill;
}

/// Riding to chain hanging in deep water, with the stopper on. band_brake: as well.
Drill riding_to_stopper(bool band_brake) {
    Drill drill(quiet_def(60, 40));
    drill.run(1);
    drill.stopper(true);
    drill.run(0.5);
    if (!band_brake) drill.brake(0);
    drill.run(3);
    return drill;
}

/// Two seconds of free fall, then snubbed by the emergency stop's spring, which the hand-wheel relieves, or
/// eased to a stop. Returns when the cable stands or a minute later.
void let_run_and_stop(Drill& drill, bool hard) {
    drill.grip(0);
    ASSERT_TRUE(drill.run_until([&] { return drill.windlass().cable_speed > 0; }, 5));
    drill.run(2);
    if (hard) {
        drill.emergency_stop(true);
        drill.brake(1);
        drill.run(20);
        drill.emergency_stop(false);
        return;
    }
    for (int percent = 0; percent < 20; ++percent) {
        drill.grip(0.01 * percent);
        drill.run(1);
    }
    drill.run(20);
}

constexpr double kHolds = 0.14; ///< of the rating: 290 kN cold, for some 240 kN at 230 m

/// Water too deep to let go in.
ExerciseDef deep_water_def() {
    return quiet_def(325, 5);
}

} // namespace

// Stellar Voyager (MAIB 25/2009), and an anchor handler with one pump at full hoist (MARS): the rendering
// chain reversed the motor with its clutch in.
TEST(Accident, RenderingChainBurstsTheMotorThatCannotHoldIt) {
    Drill drill = heaving_hydraulic();
    ASSERT_LT(drill.windlass().cable_speed, -0.1); // sound, it heaves
    drill.fault(FaultCode::counterbalance_stuck_open);
    drill.fault(FaultCode::overspeed_protection_lost);
    drill.fault(FaultCode::relief_valve_low, 0.9);
    ASSERT_TRUE(drill.run_until_event("motor.burst", 60));
    EXPECT_EQ(drill.count("motor.overspeed"), 1);
    EXPECT_FALSE(drill.windlass().power);
    drill.run(5);
    EXPECT_GT(drill.windlass().cable_speed, 2); // nothing holds the cable any more
}

TEST(Accident, BandBrakeInTimeSavesTheMotor) {
    Drill drill = heaving_hydraulic();
    drill.grip(0); // a hand that has left the lining just clear: the motor bursts in three seconds
    drill.run(3);
    drill.fault(FaultCode::counterbalance_stuck_open);
    drill.fault(FaultCode::overspeed_protection_lost);
    drill.fault(FaultCode::relief_valve_low, 0.9);
    ASSERT_TRUE(drill.run_until([&] { return drill.windlass().cable_speed > 0.1; }, 30));
    drill.brake(1);
    drill.speed_lever(0);
    drill.run(10);
    EXPECT_EQ(drill.count("motor.burst"), 0);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
}

TEST(Accident, ProtectionSavesTheMotorFromTheSameChain) {
    Drill drill = heaving_hydraulic();
    drill.fault(FaultCode::counterbalance_stuck_open);
    drill.fault(FaultCode::relief_valve_low, 0.9);
    ASSERT_TRUE(drill.run_until_event("motor.overspeed_trip", 60));
    drill.run(10);
    EXPECT_EQ(drill.count("motor.burst"), 0);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
}

// Let go in water that calls for walking back: a hand that keeps the cable at 5 m/s on the brake burns it,
// and where it would have held cold, it no longer does.
TEST(Accident, DeepWaterOnTheBrakeLosesAnchorAndCable) {
    Drill drill(deep_water_def());
    drill.run(1);
    double grip = 0;
    while (drill.chain().cable_out < 230) {
        grip = std::clamp(grip + 0.01 * (drill.windlass().cable_speed - 5), 0.0, 1.0);
        drill.grip(grip);
        drill.run(0.1);
        ASSERT_LT(drill.now().time, 200);
    }
    EXPECT_EQ(drill.count("brake.hot"), 1);
    drill.grip(kHolds);
    drill.run(30);
    EXPECT_EQ(drill.count("cable.lost"), 1) << drill.chain().cable_out;
    EXPECT_EQ(drill.anchor().phase, AnchorPhase::lost);
}

TEST(Accident, WalkedBackInTheSameWaterItHangsOnAColdBrake) {
    Drill drill(deep_water_def());
    drill.run(1);
    drill.clutch(true);
    drill.run(1);
    drill.brake(0);
    drill.speed_lever(-0.4); // at full lever so much chain overhauls the motor in its field-weakened range
    ASSERT_TRUE(drill.run_until([&] { return drill.chain().cable_out > 230; }, 1700));
    drill.speed_lever(0);
    drill.grip(kHolds);
    drill.clutch(false);
    drill.run(30);
    EXPECT_EQ(drill.windlass().clutch, ClutchState::out);
    EXPECT_EQ(drill.count("brake.hot"), 0);
    EXPECT_EQ(drill.count("cable.lost"), 0);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
}

// A bitter end that nobody surveyed, or one that was: the last 20 cm run out.
TEST(Accident, WeakBitterEndLosesWhatASoundOneHolds) {
    for (const bool sound : {false, true}) {
        ExerciseDef def = quiet_def(325, 311.8);
        def.tackle[0].windlass.bitter_end_strength = 1.35e6; // 30 % of the breaking load
        Drill drill(def);
        drill.run(1);
        if (!sound) drill.fault(FaultCode::bitter_end_weak, 0.9);
        drill.brake(0);
        ASSERT_TRUE(drill.run_until_event("cable.bitter_end", 60));
        drill.run(10);
        EXPECT_EQ(drill.count("cable.bitter_end_parted"), sound ? 0 : 1);
        EXPECT_EQ(drill.count("cable.lost"), sound ? 0 : 1);
    }
}

// Royal Pescadores (ATSB 2014): the stopper's pin worked out and the brake did not hold.
TEST(Accident, StopperPinWorksOutAndNothingElseHolds) {
    Drill drill = riding_to_stopper(false);
    drill.fault(FaultCode::stopper_pin_out);
    drill.run(5);
    EXPECT_EQ(drill.count("stopper.sprung"), 1);
    EXPECT_GT(drill.windlass().cable_speed, 1);
}

TEST(Accident, BandBrakeBehindTheStopperHoldsWhenItsPinWorksOut) {
    Drill drill = riding_to_stopper(true);
    drill.fault(FaultCode::stopper_pin_out);
    drill.run(5);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
}

TEST(Accident, WeakLinkPartsWhenTheCableIsSnubbed) {
    Drill drill(quiet_def(100, 15));
    drill.run(1);
    drill.fault(FaultCode::chain_link_weak, 0.93); // 315 kN are left, for 100 to 200 kN of weight
    let_run_and_stop(drill, true);
    EXPECT_EQ(drill.count("cable.parted"), 1);
    EXPECT_EQ(drill.anchor().phase, AnchorPhase::lost);
    drill.run(20); // both ends go on: the anchor falls to the bottom, the rest hangs and can be hove in
    EXPECT_LT(drill.anchor().height_above_bottom, 2);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    drill.clutch(true);
    ASSERT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60));
    drill.brake(0);
    drill.speed_lever(1);
    ASSERT_TRUE(drill.run_until([&] { return drill.windlass().cable_speed < -0.2; }, 10));
    ASSERT_TRUE(drill.run_until([&] { return drill.windlass().cable_speed == 0; }, 600));
    EXPECT_NEAR(drill.chain().cable_out, 15, 2); // the bare end is at the lip
    // Nothing is on it: it stays there, and what is veered again hangs by its own weight.
    const double largest = drill.largest_tension();
    drill.run(5);
    EXPECT_NEAR(drill.chain().cable_out, 15, 2);
    drill.speed_lever(-1);
    ASSERT_TRUE(drill.run_until(
        [&] {
            EXPECT_LT(drill.windlass().hawse_tension, 20e3); // of 6 m of chain, 10 kN in air
            return drill.chain().cable_out > 22 || HasFailure();
        },
        60));
    EXPECT_NEAR(drill.chain().cable_out, 22, 0.2); // it went out as it was veered
    EXPECT_EQ(drill.largest_tension(), largest);
    EXPECT_EQ(drill.count("motor.burst"), 0);
}

TEST(Accident, SameWeakLinkHoldsWhenTheCableIsEased) {
    Drill drill(quiet_def(200, 15));
    drill.run(1);
    drill.fault(FaultCode::chain_link_weak, 0.93);
    let_run_and_stop(drill, false);
    EXPECT_EQ(drill.count("cable.parted"), 0);
    EXPECT_EQ(drill.windlass().cable_speed, 0);
}

// The joining shackle that runs out next is open: the cable parts there when it is let run and snubbed, and
// holds when it is surged out on the brake.
TEST(Accident, OpenJoiningShacklePartsWhenTheCableIsSnubbedAndHoldsWhenItIsSurged) {
    for (const bool snubbed : {true, false}) {
        Drill drill(quiet_def(100, 23));
        drill.run(1);
        drill.fault(FaultCode::joining_shackle_open, 0.93); // 315 kN are left
        if (snubbed) {
            let_run_and_stop(drill, true);
        } else {
            drill.grip(0.02); // 41 kN, for 110 kN of weight
            drill.run(4);
            for (int per_mille = 20; per_mille < 200; per_mille += 5) {
                drill.grip(0.001 * per_mille);
                drill.run(1);
            }
        }
        EXPECT_EQ(drill.windlass().cable_speed, 0);
        EXPECT_GT(drill.chain().cable_out, physics::kShackleLength);
        ASSERT_EQ(drill.count("cable.parted"), snubbed ? 1 : 0);
        if (!snubbed) continue;
        const std::string said = drill.first("cable.parted")->text; // 27.5 m, in whole metres
        EXPECT_NE(said.find(" 28 m from the anchor"), std::string::npos) << said;
    }
}

// What a survey would have found: sound cable bears the snub, worn cable is stretched by it, and a cracked
// link parts.
TEST(Accident, ConditionOfTheCableDecidesWhatASnubDoesToIt) {
    const std::vector<physics::LinkCondition> sound, worn{{.begins = 0, .ends = 330, .wear = 0.45}},
        cracked{{.begins = 20, .ends = 20, .defect = 0.93}};
    for (const auto* condition : {&sound, &worn, &cracked}) {
        ExerciseDef def = quiet_def(100, 15);
        def.tackle[0].condition = *condition;
        def.tackle[0].windlass.brake_travel_time = 0.05; // it bites at once
        Drill drill(def);
        drill.run(1);
        let_run_and_stop(drill, true);
        EXPECT_EQ(drill.count("cable.overstrained"), condition == &worn ? 1 : 0);
        EXPECT_EQ(drill.count("cable.parted"), condition == &cracked ? 1 : 0);
    }
}

TEST(Accident, ChainJumpsOnWornPocketsWhenSnubbedAndNotWhenEased) {
    for (const bool hard : {true, false}) {
        Drill drill(quiet_def(200, 15));
        drill.run(1);
        drill.fault(FaultCode::gypsy_pockets_worn, 0.98); // 180 kN are left
        let_run_and_stop(drill, hard);
        EXPECT_EQ(drill.count("gypsy.jumping") > 0, hard);
    }
}

// MARS 201410 and the order of section 4: heaving against the stopper trips the motor, heaving without it
// does not.
TEST(Accident, MotorTripsOnTheForgottenStopperOnly) {
    for (const bool forgotten : {true, false}) {
        Drill drill(quiet_def(60, 40));
        drill.run(1);
        if (forgotten) drill.stopper(true);
        drill.clutch(true);
        drill.run(1);
        drill.brake(0);
        drill.run(3);
        drill.speed_lever(1);
        EXPECT_EQ(drill.run_until_event("motor.overload_trip", 80), forgotten);
    }
}

// Wash water or spray on the brake: what held the cable dry renders wet, and dries under its own heat.
TEST(Accident, WetBrakeRendersWhereADryOneHolds) {
    for (const bool wet : {true, false}) {
        ExerciseDef def = quiet_def(200, 190);
        Drill drill(def);
        drill.run(1);
        if (wet) drill.fault(FaultCode::brake_wet);
        drill.run(30); // the film comes
        drill.grip(0.25);
        drill.run(15);
        EXPECT_EQ(drill.chain().cable_out > 200, wet) << drill.chain().cable_out; // 16 m go, or none
        EXPECT_EQ(drill.chain().cable_out < 190.5, !wet) << drill.chain().cable_out;
        EXPECT_EQ(drill.windlass().cable_speed, 0); // in which the film has boiled off
    }
}

} // namespace windlass::exercise
