// Accidents at anchor in a gale, in pairs: brought about by a cause or by handling, and avoided by right
// handling with everything else the same. Each follows from loads and strength; the ship rides in 25 m of
// water.

#include "rigs/drill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::exercise {

using namespace rigs;

namespace {

constexpr double kBreeze = 15; // m/s
constexpr double kGale = 25;   // m/s, Beaufort 10: 300 kN at the hawse pipe
constexpr double kStorm = 32;  // m/s, more than this anchor holds

/// Riding on the band brake, clutch out, in a wind of so many m/s.
Drill riding(double wind, const ExerciseDef& def = let_go_def(), int shackles = 4) {
    Drill drill(def);
    drill.wind(10);
    EXPECT_TRUE(let_go_and_pay_out(drill, shackles));
    EXPECT_TRUE(drill.run_until_event("anchor.brought_up", 900));
    drill.wind(wind);
    drill.run(60);
    return drill;
}

/// The anchor caught under something that does not give.
ExerciseDef caught() {
    ExerciseDef def = let_go_def();
    def.tackle[0].anchor.holding_sand = def.tackle[0].anchor.holding_dragging = 30;
    return def;
}

/// Lets time go by; with the engine, hands at telegraph and bow thruster keep her going ahead at so many m/s
/// with her head to the wind: the engine has nothing against a wind from the side.
void ride(Drill& drill, double seconds, bool engine, double ahead = 0.05) {
    constexpr double kLook = 2; // s
    const int looks = static_cast<int>(std::ceil(seconds / kLook));
    for (int k = 0; k < looks; ++k) {
        const auto& ship = drill.now().ship;
        const double off = std::remainder(ship.heading, 2 * std::numbers::pi); // the wind is from the north
        if (engine)
            drill.helm(std::clamp(3 * (ahead - ship.surge), 0.0, 0.7),
                       std::clamp(-5 * off - 50 * ship.yaw_rate, -1.0, 1.0), 0);
        drill.run(kLook);
    }
}

/// Clutch in, brake off, lever at full hoist.
void heave(Drill& drill) {
    drill.clutch(true);
    EXPECT_TRUE(drill.run_until([&] { return drill.windlass().clutch == ClutchState::in; }, 60));
    drill.speed_lever(1);
    drill.brake(0);
    drill.run(5);
}

/// The cable on the brake and out of gear.
void onto_the_brake(Drill& drill) {
    drill.speed_lever(0);
    drill.brake(1);
    drill.run(5);
    drill.clutch(false);
    drill.run(1);
    EXPECT_EQ(drill.windlass().clutch, ClutchState::out);
}

} // namespace

// Pasha Bulker (ATSB 243), and a ship that dragged for hours unnoticed (Maritime NZ 2014): the gale grows.
TEST(Gale, DragsTheAnchorUnlessTheEngineTakesTheStrain) {
    for (const bool engine : {false, true}) {
        Drill drill = riding(kGale);
        const double dragged = drill.anchor().dragged;
        const int called = drill.count("anchor.dragging");
        drill.wind(kStorm);
        ride(drill, 300, engine);
        EXPECT_EQ(drill.anchor().dragged - dragged > 20, !engine) << drill.anchor().dragged - dragged;
        if (!engine) {
            EXPECT_GT(drill.count("anchor.dragging"), called); // and it is called
        }
    }
}

// A box ship (Gard) and a tanker (CHIRP 2017): the cable rendered with the brake tight.
TEST(Gale, CableRendersThroughAWornBrakeUnlessTheStopperIsOn) {
    for (const bool stopper : {false, true}) {
        Drill drill = riding(kBreeze);
        if (stopper) drill.stopper(true);
        drill.run(5);
        drill.fault(FaultCode::brake_lining_worn);
        drill.fault(FaultCode::brake_lining_glazed);
        drill.fault(FaultCode::brake_wet); // spray
        const double out = drill.chain().cable_out;
        drill.wind(kGale);
        drill.run(200);
        EXPECT_EQ(drill.chain().cable_out > out + 5, !stopper);
        EXPECT_EQ(drill.count("brake.slipping") > 0, !stopper);
    }
}

// After a heave friction in the hawse pipe is against the brake. As she comes to strain it turns.
TEST(Gale, HawsePipeHelpsTheBrakeThatTookTheCableFromTheMotor) {
    Drill drill = riding(10);
    heave(drill);
    onto_the_brake(drill);
    const double before = drill.windlass().hawse_tension;
    EXPECT_GT(drill.windlass().gypsy_load, before);
    drill.wind(kGale);
    ASSERT_TRUE(drill.run_until([&] { return drill.windlass().hawse_tension > 4 * before; }, 300));
    EXPECT_EQ(drill.windlass().cable_speed, 0);
    EXPECT_LT(drill.windlass().gypsy_load, 0.8 * drill.windlass().hawse_tension);
}

// Young Lady (MAIB 3/2008), snagged on a pipeline: the windlass failed while it had to pull the ship ahead.
TEST(Gale, MotorTripsWhenItHasToPullTheShipAndNotWithTheEngineAhead) {
    for (const bool engine : {false, true}) {
        Drill drill = riding(1.15 * kStorm, caught(), 6); // long enough to pull level
        constexpr double kEasing = 0.25;                  // m/s ahead
        ride(drill, 60, engine, kEasing);
        heave(drill);
        ride(drill, 200, engine, kEasing);
        EXPECT_EQ(drill.count("motor.overload_trip") > 0, !engine);
    }
}

// MARS: the motor failed with 4 of 6 shackles in, and all 11 ran out.
TEST(Gale, CableRunsOutWhenTheClutchJumpsUnlessAHandIsAtTheBrake) {
    for (const bool hand : {false, true}) {
        Drill drill = riding(kGale);
        heave(drill);
        drill.fault(FaultCode::clutch_jumps_out, 0.7);
        ASSERT_TRUE(drill.run_until([&] { return drill.windlass().cable_speed > 0.2; }, 300));
        drill.speed_lever(0);
        if (hand) drill.brake(1);
        EXPECT_EQ(drill.run_until_event("cable.bitter_end", hand ? 60 : 300), !hand);
    }
}

// MARS 201410: shaft and claw coupling replaced. Stopper, brake, and declutch at once, before anything else.
TEST(Gale, DamagedShaftShearsUnlessTheCableIsOnTheBrake) {
    for (const bool declutched : {false, true}) {
        Drill drill = riding(kBreeze);
        heave(drill);
        drill.speed_lever(0); // on the shaft brake
        drill.run(2);
        if (declutched) onto_the_brake(drill);
        drill.fault(FaultCode::clutch_shaft_damaged, 0.92); // 160 kN are left
        drill.wind(kGale);
        EXPECT_EQ(drill.run_until_event("clutch.sheared", 200), !declutched);
        drill.run(2);
        EXPECT_EQ(drill.windlass().cable_speed > 0.05, !declutched);
    }
}

// A bulk carrier (HK MD note): fouled by an old chain, the cable leading astern, and the motor exploded.
TEST(Gale, MotorBurstsOnAnAnchorThatIsFastUnlessTheCableIsOnTheBrake) {
    for (const bool declutched : {false, true}) {
        Drill drill = riding(kGale, caught(), 6);
        drill.fault(FaultCode::overspeed_protection_lost);
        drill.fault(FaultCode::motor_power_lost, 0.5);
        heave(drill);
        if (declutched) onto_the_brake(drill);
        drill.engine(-1);
        EXPECT_EQ(drill.run_until_event("motor.burst", 240), !declutched) << drill.largest_tension();
    }
}

// Mariella (MAIB): a hydraulic line failed with the cable short, and she dragged for an hour.
TEST(Gale, HoseBurstAtShortStayDragsTheAnchorUnlessTheEngineTakesTheStrain) {
    for (const bool engine : {false, true}) {
        ExerciseDef def = let_go_def();
        def.tackle[0].windlass.drive = physics::DriveKind::hydraulic;
        Drill drill = riding(kBreeze, def);
        heave(drill);
        ASSERT_TRUE(drill.run_until([&] { return drill.shackles() < 2.5; }, 600));
        drill.fault(FaultCode::hydraulic_hose_burst);
        drill.run(5);
        EXPECT_EQ(drill.windlass().cable_speed, 0); // on the shaft brake, and nothing moves it
        drill.wind(kGale);
        const double dragged = drill.anchor().dragged;
        ride(drill, 300, engine);
        EXPECT_EQ(drill.anchor().dragged - dragged > 20, !engine) << drill.anchor().dragged - dragged;
    }
}

} // namespace windlass::exercise
