// Prime movers on the bench: pull, speed, protection and what overhauling does, against closed forms.

#include "rigs/gypsy_bench.hpp"
#include "server/physics/windlass/hydraulic_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::physics {
using namespace rigs;

namespace {

constexpr double kNeverHome = 1e4; ///< m of cable out, of which two hours bring in 1100

TEST(Motor, HeavesRatedPullAtRatedSpeed) {
    GypsyBench bench;
    bench.drive(1);
    bench.run(10, bench.heaving_pull(bench.def.rated_pull));
    EXPECT_NEAR(-bench.speed() / bench.def.rated_speed, 1, 0.01);
}

TEST(Motor, RunsALightLineAtItsTopSpeed) {
    GypsyBench bench;
    bench.drive(1);
    bench.run(10, bench.heaving_pull(0.05 * bench.def.rated_pull));
    EXPECT_NEAR(-bench.speed() / bench.def.light_line_speed, 1, 0.01);
}

TEST(Motor, StallsAndTripsAboveItsStallPull) {
    GypsyBench bench;
    bench.drive(1);
    bench.run(5, bench.heaving_pull(0.98 * bench.def.stall_pull));
    EXPECT_LT(-bench.speed(), 0.1 * bench.def.rated_speed);
    EXPECT_FALSE(bench.windlass.state().motor.tripped);
    bench.run(80, bench.heaving_pull(0.98 * bench.def.stall_pull));
    EXPECT_TRUE(bench.windlass.state().motor.tripped);
}

TEST(Motor, StaysTrippedWhileItIsHotWhateverTheLeverDoes) {
    GypsyBench bench;
    bench.drive(1);
    const double stalled = bench.heaving_pull(0.98 * bench.def.stall_pull);
    const auto tripped = [&] { return bench.state().motor.tripped; };
    ASSERT_TRUE(bench.run_until(tripped, stalled, 100));
    const double hot = bench.windlass.motor_temperature();
    const auto flick = [&] { // to zero for one step and back
        bench.levers.speed = 0;
        bench.run(0.5 * bench.dt, 0);
        bench.levers.speed = 1;
        bench.run(0.5 * bench.dt, 0);
    };
    flick();
    EXPECT_TRUE(tripped());
    EXPECT_NEAR(bench.windlass.motor_temperature(), hot, 0.1); // K: a winding does not cool in a step
    // Makers of relays give 1 to 10 minutes until one may be reset.
    bench.run(60, 0);
    flick();
    EXPECT_TRUE(tripped());
    bench.run(540, 0);
    EXPECT_TRUE(tripped()); // nobody has reset it
    flick();
    EXPECT_FALSE(tripped());
    EXPECT_LT(bench.windlass.motor_temperature(), hot);
}

TEST(Motor, WarmItTripsSoonerThanCold) {
    // IEC 60947-4-1 tests at 1.5 times from the state at the rated current, at 7.2 times from cold.
    const auto seconds = [](double warming) {
        GypsyBench bench({}, {}, kNeverHome);
        bench.drive(1);
        bench.run(warming, bench.heaving_pull(bench.def.rated_pull));
        const double pull = bench.heaving_pull(1.5 * bench.def.rated_pull);
        double time = 0;
        for (; !bench.state().motor.tripped && time < 600; time += 1)
            bench.run(1, pull);
        return time;
    };
    const double cold = seconds(1), warm = seconds(1200);
    EXPECT_LT(warm, 120); // class 10A, table 2: within two minutes
    EXPECT_LT(warm, 0.5 * cold);
}

/// heat_motor() for so long (s) at a pull of the motor, which its relay sees as another (both of the rated).
void warm(MotorHeat& heat, double seconds, double share, double seen_by_relay) {
    const WindlassDef def;
    constexpr double kStep = 1.0 / 60;
    for (double t = 0; t < seconds; t += kStep)
        heat_motor(def, kStep, share * rated_motor_pull(def), seen_by_relay * rated_motor_pull(def), heat);
}

TEST(Motor, GivesItsRatedPullForHalfAnHourAndNotForAWatch) {
    // S2-30: the class's rise is what thirty minutes leave (IEC 60034-1: class F, 105 K by resistance). The
    // relay sees nothing: only the winding's own thermistors guard it.
    MotorHeat heat;
    warm(heat, 1800, 1, 0);
    EXPECT_FALSE(heat.open);
    EXPECT_NEAR(winding_temperature(heat) - kAirTemperature, 105, 0.1); // K
    warm(heat, 3600, 1, 0);
    EXPECT_TRUE(heat.open);
}

TEST(Motor, GivesShortTimePullForTwoMinutesWithoutTripping) {
    // IACS UR A3 3.1.3: 1.5 times the continuous pull for 2 minutes.
    GypsyBench bench;
    bench.drive(1);
    bench.run(120, bench.heaving_pull(1.5 * bench.def.rated_pull));
    EXPECT_FALSE(bench.windlass.state().motor.tripped);
    EXPECT_LT(bench.speed(), 0); // it still heaves
}

TEST(Motor, WithoutPowerItsShaftBrakeHolds) {
    GypsyBench bench;
    bench.drive(1);
    bench.run(5, bench.heaving_pull(2e5));
    ASSERT_LT(bench.speed(), 0);
    bench.causes.power_lost = 1;
    bench.run(3, bench.heaving_pull(2e5));
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_GT(bench.windlass.loads().shaft_brake, 1e5);
}

/// A pull (N, at the gypsy) while the chain runs out, motor against it with everything it has.
double overhauling(const GypsyBench& bench, double share_of_stall) {
    return bench.pull_for(share_of_stall * bench.def.stall_pull / kGearEfficiency / kGearEfficiencyBack);
}

TEST(Motor, RunsForEverALittleAboveItsRatedPullButNotAtAFifthAbove) {
    // IEC 60947-4-1, table 2: no trip at 1.05 times within two hours, then one within two hours at 1.2. The
    // winding is left out of it: an S2 motor is not made for hours.
    MotorHeat heat;
    warm(heat, 7200, 0, 1.05);
    EXPECT_FALSE(heat.open);
    warm(heat, 7200, 0, 1.2);
    EXPECT_TRUE(heat.open);
}

TEST(Motor, LosesItsShareInTheGearEitherWay) {
    // Steady walking back of 200 kN: the gear takes its part of what the motor would have to hold.
    GypsyBench bench;
    bench.drive(-0.5);
    bench.run(5, bench.pull_for(2e5));
    const DeckResult& deck = bench.windlass.loads().deck;
    EXPECT_NEAR(deck.motor, 2e5 * kGearEfficiencyBack, 200);
    EXPECT_NEAR(deck.motor + deck.gear, 2e5, 200);
    bench.levers.speed = 0.5;
    bench.run(5, bench.heaving_pull(2e5));
    EXPECT_NEAR(bench.windlass.loads().deck.motor, 2e5 / kGearEfficiency, 200);
}

TEST(Motor, HoldsWhatItsGearAndStallPullHoldTogether) {
    for (const double share : {0.98, 1.02}) {
        GypsyBench bench;
        bench.drive(1);
        bench.run(0.5, overhauling(bench, 0.5));
        bench.run(2, overhauling(bench, share));
        EXPECT_EQ(bench.speed() > 0, share > 1) << share;
    }
}

TEST(Motor, ProtectionStopsItWhenTheCableDrivesIt) {
    GypsyBench bench;
    bench.dt = 1.0 / 4800; // s, in which it gains less than is asked for
    bench.drive(-1);
    ASSERT_TRUE(bench.run_until([&] { return bench.state().motor.overspeed; }, overhauling(bench, 1.2), 20));
    EXPECT_NEAR(bench.speed() / bench.def.light_line_speed, kOverspeedTrip, 0.02);
    bench.run(10, bench.pull_for(5e5)); // within the shaft brake's rating
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_FALSE(bench.state().motor.burst);
}

TEST(Motor, BurstsWhenTheCableDrivesItUnprotected) {
    GypsyBench bench;
    bench.causes.overspeed_unprotected = 1;
    bench.drive(-1);
    ASSERT_TRUE(bench.run_until([&] { return bench.state().motor.burst; }, overhauling(bench, 1.2), 20));
    EXPECT_NEAR(bench.state().motor.worst_speed / bench.def.light_line_speed, kBurstSpeed, 0.2);
    bench.levers.speed = 1;
    bench.run(1, bench.pull_for(2e5));
    EXPECT_EQ(bench.windlass.loads().deck.motor, 0); // nothing is left to hold with
    EXPECT_EQ(bench.windlass.loads().shaft_brake, 0);
    EXPECT_GT(bench.speed(), 1);
}

WindlassDef pole_changing() {
    WindlassDef def;
    def.drive = DriveKind::electric_pole_changing;
    def.light_line_speed = 0.32;
    return def;
}

TEST(PoleChanging, RunsEachWindingAtItsSpeed) {
    const double table[][2] = {{0.2, 0.08}, {0.5, 0.16}, {1.0, 0.32}}; // lever, m/s
    for (const auto& [lever, speed] : table) {
        GypsyBench bench(pole_changing());
        bench.drive(lever);
        bench.run(10, bench.heaving_pull(0.02 * bench.def.rated_pull));
        EXPECT_NEAR(-bench.speed() / speed, 1, 0.01) << lever;
    }
}

TEST(PoleChanging, HeavesRatedPullAtRatedSpeedInTheMiddle) {
    GypsyBench bench(pole_changing());
    bench.drive(0.5);
    bench.run(10, bench.heaving_pull(bench.def.rated_pull));
    EXPECT_NEAR(-bench.speed() / bench.def.rated_speed, 1, 0.01);
}

TEST(PoleChanging, StallsInTheFastWindingWhereTheSlowOneHeaves) {
    for (const double lever : {0.5, 1.0}) {
        GypsyBench bench(pole_changing());
        bench.drive(lever);
        bench.run(10, bench.heaving_pull(1.5 * bench.def.rated_pull)); // the fast winding gives 1.0
        EXPECT_EQ(bench.speed() < 0, lever == 0.5) << lever;
    }
}

TEST(PoleChanging, RunsAwayBeyondItsBreakdownPull) {
    // Lowering, an induction motor brakes above its synchronous speed, up to the breakdown pull and no more.
    for (const double share : {0.97, 1.03}) {
        GypsyBench bench(pole_changing());
        bench.causes.overspeed_unprotected = 1;
        bench.drive(-0.5);
        bench.run(5, overhauling(bench, 0.5));
        bench.run(5, overhauling(bench, share));
        EXPECT_EQ(bench.speed() > 0.3, share > 1) << share;
        EXPECT_EQ(bench.state().motor.burst, share > 1) << share;
    }
}

WindlassDef hydraulic() {
    WindlassDef def;
    def.drive = DriveKind::hydraulic;
    return def;
}

TEST(Hydraulic, ReliefPressureLimitsThePull) {
    const WindlassDef def = hydraulic();
    const double max = def.hydraulic_relief * hydraulic_area(def) * kGearEfficiency;
    for (const double share : {0.99, 1.01}) {
        GypsyBench bench(def);
        bench.drive(1);
        bench.run(10, bench.heaving_pull(share * max));
        EXPECT_EQ(bench.speed() < 0, share < 1) << share;
    }
    GypsyBench low(def);
    low.causes.relief_low = 0.5;
    low.drive(1);
    low.run(5, low.heaving_pull(0.6 * max));
    EXPECT_EQ(low.speed(), 0);
    EXPECT_NEAR(low.state().motor.pressure / (0.5 * def.hydraulic_relief), 1, 1e-6);
}

TEST(Hydraulic, SpeedIsPumpFlowLessLeakage) {
    const WindlassDef def = hydraulic();
    for (const double lost : {0.0, 0.5}) { // two pumps, and one
        GypsyBench bench(def);
        bench.causes.pumps_lost = lost;
        bench.drive(1);
        bench.run(10, bench.heaving_pull(def.rated_pull));
        const double pressure = def.rated_pull / kGearEfficiency / hydraulic_area(def);
        const double flow = 2 * (1 - lost) * def.hydraulic_pump_flow - def.hydraulic_leakage * pressure;
        EXPECT_NEAR(-bench.speed() / (flow / hydraulic_area(def)), 1, 1e-3) << lost;
        EXPECT_NEAR(bench.state().motor.pressure / pressure, 1, 1e-3);
    }
}

TEST(Hydraulic, LeakingMotorOnOnePumpDoesNotReachReliefPressure) {
    // All the flow leaks past a motor that stands: p = Q / leakage.
    WindlassDef def = hydraulic();
    def.hydraulic_leakage = 1.4e-9; // a worn one
    GypsyBench bench(def);
    bench.causes.pumps_lost = 0.5;
    bench.drive(1);
    bench.levers.stopper_closed = true;
    bench.run(10, 0);
    EXPECT_NEAR(bench.state().motor.pressure / (def.hydraulic_pump_flow / def.hydraulic_leakage), 1, 0.01);
    EXPECT_LT(bench.state().motor.pressure, 0.4 * def.hydraulic_relief);
}

TEST(Hydraulic, CounterbalanceValveHoldsWhatReliefDoesNot) {
    const WindlassDef def = hydraulic();
    const double back = hydraulic_area(def) / kGearEfficiencyBack;
    const double load = 1.15 * def.hydraulic_relief * back; // between relief and the valve's setting
    GypsyBench bench(def);
    bench.drive(1);
    bench.run(5, bench.pull_for(load));
    // Only leakage lets it by: the pressure that the pumps do not give.
    const double creep = 0.15 * def.hydraulic_relief * def.hydraulic_leakage / hydraulic_area(def);
    EXPECT_NEAR(bench.speed() / creep, 1, 0.02);
    // Stuck open, full hoist and clutch in, the chain overhauls the motor.
    bench.causes.counterbalance_open = 1;
    bench.causes.overspeed_unprotected = 1;
    bench.run(5, bench.pull_for(load));
    EXPECT_GT(bench.speed(), 0.5);
}

TEST(Hydraulic, LowersAtThePumpsFlowUnderAnyLoadThatTheValveHolds) {
    const WindlassDef def = hydraulic();
    for (const double load : {1e5, 4e5}) {
        GypsyBench bench(def);
        bench.drive(-0.5);
        bench.run(5, bench.pull_for(load));
        const double leak = load * kGearEfficiencyBack / hydraulic_area(def) * def.hydraulic_leakage;
        EXPECT_NEAR(bench.speed(), 0.5 * hydraulic_top_speed(def) + leak / hydraulic_area(def), 1e-3) << load;
    }
}

TEST(Hydraulic, ShaftBrakeHoldsWhenAHoseBursts) {
    GypsyBench bench(hydraulic());
    bench.drive(1);
    bench.run(5, bench.heaving_pull(3e5));
    ASSERT_LT(bench.speed(), 0);
    bench.causes.hose_burst = 1;
    bench.run(3, bench.heaving_pull(3e5));
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_GT(bench.windlass.loads().shaft_brake, 1e5);
    EXPECT_EQ(bench.state().motor.pressure, 0);
}

} // namespace
} // namespace windlass::physics
