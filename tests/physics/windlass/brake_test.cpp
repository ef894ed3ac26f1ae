// The band brake: what it holds either way, and what heat, water, glaze and wear take from it.

#include "rigs/gypsy_bench.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace windlass::physics {
namespace {

TEST(Brake, HoldsBelowSlipTorqueAndSlipsAbove) {
    rigs::GypsyBench bench;
    bench.run(2, bench.pull_for(0.99 * bench.def.brake_rating));
    EXPECT_EQ(bench.speed(), 0);
    EXPECT_NEAR(bench.windlass.loads().brake / bench.def.brake_rating, 0.99, 1e-6);
    bench.run(2, bench.pull_for(1.01 * bench.def.brake_rating));
    EXPECT_GT(bench.speed(), 0.01);
}

TEST(Brake, SlippingTurnsItsForceIntoHeat) {
    rigs::GypsyBench bench;
    const double pull = bench.pull_for(1.02 * bench.def.brake_rating);
    const double out = bench.windlass.state().cable_out;
    bench.run(0.3, pull);
    const double slipped = bench.windlass.state().cable_out - out;
    ASSERT_GT(slipped, 0.1);
    ASSERT_LT(bench.windlass.state().brake.skin, kFadeStart);
    // The lining is still cold, so the force is the rating; 2 %: the first of 90 steps in a travel that grows
    // as t^2.
    EXPECT_NEAR(bench.windlass.state().brake.heat / (bench.def.brake_rating * slipped), 1, 0.02);
    const WindlassState& s = bench.windlass.state();
    const double stored = bench.def.lining_heat_capacity * (s.brake.skin - kAirTemperature) +
                          bench.def.drum_heat_capacity * (s.brake.drum - kAirTemperature);
    EXPECT_NEAR(stored / s.brake.heat, 1, 1e-3); // what cools off in a second is less
}

/// A brake hard on, cold and dry.
BandBrakeState sound() {
    BandBrakeState state;
    state.skin = state.drum = kAirTemperature;
    return state;
}

TEST(Brake, PullsByTheCapstanEquation) {
    // T1 / T2 = e^(mu theta): the ratio of what the band holds paying out to what it holds heaving in is the
    // ratio of tight to slack side. 300 deg: 3.7, 4.8, 6.3 (tribology-abc.com).
    const double table[][2] = {{0.25, 3.7}, {0.30, 4.8}, {0.35, 6.3}};
    const WindlassDef def;
    for (const auto& [mu, ratio] : table) {
        const BrakeGrip grip = brake_grip(def, sound(), {.lining_faded = 1 - mu / kLiningFriction});
        EXPECT_NEAR(grip.out / grip.in, ratio, 0.05) << mu; // the table's last figure
    }
    EXPECT_DOUBLE_EQ(brake_grip(def, sound(), {}).out, def.brake_rating);
}

TEST(Brake, HoldsByTheHandWheel) {
    const WindlassDef def;
    BandBrakeState state = sound();
    state.position = 0.5;
    EXPECT_DOUBLE_EQ(brake_grip(def, state, {}).out, 0.5 * def.brake_rating);
}

TEST(Brake, FadesWhenItsLiningIsHot) {
    const WindlassDef def;
    BandBrakeState state = sound();
    state.skin = 1000;
    // Capstan equation with what is left of the friction.
    const double left = kLiningFriction * kFadeResidual;
    const double expected = std::expm1(left * kBandWrap) / std::expm1(kLiningFriction * kBandWrap);
    EXPECT_NEAR(brake_grip(def, state, {}).out / def.brake_rating, expected, 1e-12);
    EXPECT_LT(expected, 0.3);
    EXPECT_EQ(brake_grip(def, state, {.lining_faded = 1}).out, 0); // no friction left: nothing holds
}

TEST(Brake, HoldsLessWetGlazedOrWorn) {
    const WindlassDef def;
    const BandBrakeState dry = sound();
    BandBrakeState wet = dry;
    wet.water = 1;
    EXPECT_GE(lining_friction(wet, {}), 0.15); // linings wet or oily: 0.15-0.25
    EXPECT_LE(lining_friction(wet, {}), 0.25);
    for (const BrakeGrip& grip : {brake_grip(def, wet, {}), brake_grip(def, dry, {.lining_glazed = 0.5}),
                                  brake_grip(def, dry, {.lining_worn = 0.7})}) {
        EXPECT_LT(grip.out, 0.9 * def.brake_rating);
        EXPECT_GT(grip.out, 0.1 * def.brake_rating);
    }
    EXPECT_EQ(brake_grip(def, dry, {.lining_worn = 0.4}).out, def.brake_rating); // the thread takes it up
}

TEST(Brake, ThermalNodesCloseOnEverySink) {
    // A minute of hard slipping from a wet start, an hour of cooling: heat in = stored + air + boiled water.
    const WindlassDef def;
    BandBrakeState state = sound();
    state.water = 1;
    const double dt = 1.0 / 300;
    for (int k = 0; k < 300 * 3660; ++k)
        heat_brake(def, dt, k < 300 * 60 ? 4e5 * dt : 0, {}, state);
    const double stored = def.lining_heat_capacity * (state.skin - kAirTemperature) +
                          def.drum_heat_capacity * (state.drum - kAirTemperature);
    EXPECT_NEAR((stored + state.cooled + state.dried) / state.heat, 1, 1e-9); // what is wanted is 0.5 %
    EXPECT_GT(state.cooled, 0.2 * state.heat);
    EXPECT_GT(state.dried, 8e5); // most of the film is gone: it dries by what is left of it
    EXPECT_LT(state.water, 0.2);
    // After so long skin and drum are one lump that cools by Newton's law.
    EXPECT_NEAR(state.skin - state.drum, 0, 2);
}

TEST(Brake, SkinSettlesAboveTheDrumByHeatOverConductance) {
    const WindlassDef def;
    BandBrakeState state = sound();
    for (int k = 0; k < 300 * 300; ++k)
        heat_brake(def, 1.0 / 300, 4e5 / 300, {}, state);
    // The drum itself still warms, by 400 kW / 0.69 MJ/K: the skin's own share of that lags, 5 %.
    EXPECT_NEAR((state.skin - state.drum) / (4e5 / def.lining_conductance), 1, 0.05);
}

TEST(Brake, SkinWarmsAsHeatDoesThatDiffusesIntoSteel) {
    // 300 kW on 0.75 m2 of thick steel (k 50 W/(m K), rho c 3.6 MJ/(m3 K)): 2 q sqrt(t / (pi k rho c)).
    const WindlassDef def;
    BandBrakeState state = sound();
    constexpr double kPower = 3e5, kTrack = 0.75;
    int seconds = 0;
    for (const int at : {10, 20, 40, 70, 100}) {
        for (; seconds < at; ++seconds)
            for (int k = 0; k < 300; ++k)
                heat_brake(def, 1.0 / 300, kPower / 300, {}, state);
        const double steel = 2 * kPower / kTrack * std::sqrt(seconds / (std::numbers::pi * 50 * 3.6e6)); // K
        // Two lumps for a square root: within a fifth.
        EXPECT_NEAR((state.skin - kAirTemperature) / steel, 1, 0.2) << seconds;
    }
}

TEST(Brake, GlazesWhenItIsBurntAndStaysSo) {
    const WindlassDef def;
    BandBrakeState state = sound();
    state.skin = state.drum = kFadeEnd + 50;
    for (int k = 0; k < 300 * 20; ++k)
        heat_brake(def, 1.0 / 300, 0, {}, state);
    EXPECT_GT(state.glaze, 0.2);
    state.skin = state.drum = kAirTemperature;
    EXPECT_LT(brake_grip(def, state, {}).out, 0.95 * def.brake_rating);
}

TEST(Brake, HandWheelTakesItsTime) {
    rigs::GypsyBench bench;
    bench.levers.brake = 0;
    bench.run(0.5 * bench.def.brake_travel_time, 0);
    EXPECT_NEAR(bench.windlass.state().brake.position, 0.5, 0.01);
}

} // namespace
} // namespace windlass::physics
