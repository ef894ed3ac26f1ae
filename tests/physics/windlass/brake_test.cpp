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
    const BandBrakeState& brake = bench.windlass.state().brake;
    EXPECT_NEAR(stored_heat(bench.def, brake) / brake.heat, 1, 1e-3); // what cools off in a second is less
}

/// A brake hard on, cold and dry.
BandBrakeState sound() {
    BandBrakeState state;
    state.skin = state.shell = state.drum = kAirTemperature;
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

TEST(Brake, GripsNothingInItsFreePlay) {
    const WindlassDef def;
    BandBrakeState state = sound();
    for (const double position : {0.0, 0.5 * def.brake_free_play, def.brake_free_play}) {
        state.position = position;
        EXPECT_EQ(brake_grip(def, state, {}).out, 0) << position;
        EXPECT_EQ(brake_grip(def, state, {}).in, 0) << position;
    }
}

TEST(Brake, GripRisesWithoutAStepToItsRatingHardOn) {
    WindlassDef def;
    BandBrakeState state = sound();
    for (const double free_play : {0.0, 0.4, 0.9}) {
        for (const double stiffening : {1.0, 2.5, 5.0}) {
            def.brake_free_play = free_play, def.brake_stiffening = stiffening;
            constexpr int kSteps = 10000;
            // Steepest hard on: the power over what travel the free play leaves.
            const double steepest = stiffening / (1 - free_play) / kSteps;
            double before = 0;
            for (int k = 1; k <= kSteps; ++k) {
                const double share = grip_share(def, static_cast<double>(k) / kSteps);
                EXPECT_GE(share, before);
                EXPECT_LE(share - before, steepest * (1 + 1e-9));
                before = share;
            }
            EXPECT_EQ(before, 1);
            state.position = 1;
            EXPECT_DOUBLE_EQ(brake_grip(def, state, {}).out, def.brake_rating);
        }
    }
}

TEST(Brake, LastOfFiveTurnsGivesMostOfTheGrip) {
    EXPECT_GT(1 - grip_share({}, 0.8), 0.6);
}

TEST(Brake, AFallIsHeldOverAHundredDegreesOfTheWheel) {
    // What holds the fall of 78 mm cable in 25 m between 2.2 and 5.0 m/s: 2.5 and 0.5 % of the grip.
    const WindlassDef def;
    EXPECT_GT(5 * 360 * (position_of_grip(def, 0.025) - position_of_grip(def, 0.005)), 100);
}

TEST(Brake, HandWheelIsFoundByTheGripThatItGives) {
    const WindlassDef def;
    for (const double share : {0.001, 0.01, 0.1, 0.5, 0.9, 1.0})
        EXPECT_NEAR(grip_share(def, position_of_grip(def, share)), share, 1e-12);
    EXPECT_EQ(position_of_grip(def, 0), def.brake_free_play);
    EXPECT_EQ(position_of_grip(def, 1), 1);
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
    EXPECT_NEAR((stored_heat(def, state) + state.cooled + state.dried) / state.heat, 1,
                1e-9); // wanted: 0.5 %
    EXPECT_GT(state.cooled, 0.2 * state.heat);
    EXPECT_GT(state.dried, 8e5); // most of the film is gone: it dries by what is left of it
    EXPECT_LT(state.water, 0.2);
    // After so long skin, shell and drum are one lump that cools by Newton's law.
    EXPECT_NEAR(state.skin - state.drum, 0, 2);
}

TEST(Brake, SkinWarmsAsHeatDoesThatDiffusesIntoSteel) {
    // Thick steel (k 50 W/(m K), rho c 3.6 MJ/(m3 K)) under a steady heat: 2 q sqrt(t / (pi k rho c)).
    const WindlassDef def;
    constexpr double kDt = 1.0 / 300;
    for (const double power : {3e5, 1e6, 3e6}) { // a cable that is ridden, runaways that are braked
        BandBrakeState state = sound();
        int steps = 0;
        for (const double seconds : {0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0, 20.0, 40.0, 70.0, 100.0}) {
            for (; steps * kDt < seconds; ++steps)
                heat_brake(def, kDt, power * kDt, {}, state);
            const double steel =
                2 * power / def.brake_track_area * std::sqrt(seconds / (std::numbers::pi * 50 * 3.6e6)); // K
            // Three lumps for a square root.
            EXPECT_NEAR((state.skin - kAirTemperature) / steel, 1, 0.06)
                << power << " W, " << seconds << " s";
        }
    }
}

TEST(Brake, SmallTrackIsHotterByItsArea) {
    const WindlassDef large;
    WindlassDef small;
    small.brake_track_area = 0.5 * large.brake_track_area;
    BandBrakeState on_large = sound(), on_small = sound();
    for (int k = 0; k < 300; ++k) {
        heat_brake(large, 1.0 / 300, 1e6 / 300, {}, on_large);
        heat_brake(small, 1.0 / 300, 1e6 / 300, {}, on_small);
    }
    EXPECT_NEAR((on_small.skin - kAirTemperature) / (on_large.skin - kAirTemperature), 2, 1e-3);
}

TEST(Brake, GlazesWhenItIsBurntAndStaysSo) {
    const WindlassDef def;
    BandBrakeState state = sound();
    state.skin = state.shell = state.drum = kFadeEnd + 50;
    for (int k = 0; k < 300 * 20; ++k)
        heat_brake(def, 1.0 / 300, 0, {}, state);
    EXPECT_GT(state.glaze, 0.2);
    state.skin = state.shell = state.drum = kAirTemperature;
    EXPECT_LT(brake_grip(def, state, {}).out, 0.95 * def.brake_rating);
}

TEST(Brake, EmergencySpringWaitsForNoHand) {
    rigs::GypsyBench bench;
    bench.levers.brake = bench.windlass.state().brake.position = 0;
    bench.levers.emergency_stop = true;
    bench.run(0.51, 0);
    EXPECT_EQ(bench.windlass.state().brake.position, 1);
}

TEST(Brake, HandWheelTakesItsTime) {
    rigs::GypsyBench bench;
    bench.levers.brake = 0;
    bench.run(0.5 * bench.def.brake_travel_time, 0);
    EXPECT_NEAR(bench.windlass.state().brake.position, 0.5, 0.01);
}

} // namespace
} // namespace windlass::physics
