// The anchor's types, flukes and hold on the ground, pulled as a ship pulls.

#include "tests/physics/tackle_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace windlass::physics {
namespace {

/// Let go and paid out as the hull falls away, then pulled slowly until the flukes are in. Cable in m.
TackleRig dug_in(AnchorType type, Soil soil, double cable) {
    EnvironmentDef environment = quiet_water(25);
    lay_bed(environment, soil);
    TackleSetup setup;
    setup.anchor = typical_anchor(type);
    TackleRig rig(setup, environment);
    rig.levers.brake = 0;
    rig.run_until([&] { return rig.windlass().cable_out > 35; }, 60);
    rig.lip_velocity = {0.8, 0, 0};
    rig.run_until(
        [&] {
            rig.levers.brake = rig.windlass().cable_out > 35 + rig.lip.x() ? 0.1 : 0;
            return rig.windlass().cable_out > cable;
        },
        600);
    rig.levers.brake = 1;
    rig.lip_velocity = {0.15, 0, 0};
    rig.run_until([&] { return rig.tackle.anchor().holding().embedment > 0.99; }, 900);
    return rig;
}

class EveryType : public testing::TestWithParam<AnchorType> {};

TEST_P(EveryType, LandsTurnsItsFlukesDownAndDigsIn) {
    const TackleRig rig = dug_in(GetParam(), Soil::sand, 165);
    const Anchor& anchor = rig.tackle.anchor();
    const Eigen::Matrix3d axes = anchor.pose().attitude.toRotationMatrix();
    EXPECT_GT(anchor.holding().embedment, 0.99);
    EXPECT_LT(std::abs(axes(2, 0)), 0.1); // shank flat
    // Flukes open to their stop, to the lower side; a stock lies flat and so one arm points down.
    EXPECT_NEAR(anchor.fluke_angle(), std::copysign(rig.setup.anchor.fluke_angle, axes(2, 2)), 0.02);
    EXPECT_GT(std::abs(axes(2, 2)), 0.95);
    EXPECT_EQ(anchor.holding().bent, 0); // soil alone does not bend it
}

INSTANTIATE_TEST_SUITE_P(Anchor, EveryType,
                         testing::Values(AnchorType::hall, AnchorType::spek, AnchorType::ac14,
                                         AnchorType::hhp, AnchorType::shhp, AnchorType::stock));

/// Soil, and m of cable.
class HoldingPower : public testing::TestWithParam<std::tuple<Soil, double>> {};

TEST_P(HoldingPower, IsThatOfTheAnchorAndOfTheCableOnTheBottom) {
    const auto [soil, cable] = GetParam();
    const TackleRig rig = dug_in(AnchorType::hall, soil, cable);
    const ChainState& chain = rig.tackle.chain();
    double lying = 0; // m
    for (int i = 0; i < chain.links; ++i)
        if (0.5 * (chain.position.z[i] + chain.position.z[i + 1]) < -rig.environment.depth + 0.1)
            lying += link_length(rig.setup.chain, chain, i);
    // H = w_a lambda_a + w_c lambda_c l, the anchor's weight in air, the cable's in water.
    const double expected =
        rig.setup.anchor.mass * kGravity * holding_factor(rig.setup.anchor, soil) +
        weight_in_water(rig.setup.chain, kSeaWaterDensity) * rig.environment.bed_friction * lying;
    const Vec3 lead = rig.tackle.cable_direction();
    const double pull = rig.deck().hawse_tension * std::hypot(lead.x(), lead.y());
    EXPECT_LT(rig.tackle.uplift(rig.environment), 0.01); // the shank lies flat
    EXPECT_NEAR(pull / expected, 1, 0.1);                // as wanted
}

INSTANTIATE_TEST_SUITE_P(SoilsAndScopes, HoldingPower,
                         testing::Combine(testing::Values(Soil::mud, Soil::sand, Soil::clay, Soil::gravel,
                                                          Soil::rock, Soil::coral, Soil::mixed),
                                          testing::Values(165.0, 220.0, 275.0)));

/// Hove in to a length (m), the lip coming up so that the cable hangs slack and the anchor is left as it
/// lies.
bool hove_in(TackleRig& rig, double cable) {
    rig.lip_velocity.setZero();
    rig.levers.clutch_in = true;
    if (!rig.run_until([&] { return rig.windlass().clutch.position == Clutch::in; }, 60)) return false;
    rig.levers.brake = 0;
    rig.levers.speed = 1;
    const double height = rig.lip.z() + rig.environment.depth;
    const auto come_up = [&] {
        const double out = rig.windlass().cable_out;
        const double slack = rig.tackle.anchor().shackle().x() + 0.9 * std::sqrt(out * out - height * height);
        rig.lip_velocity.x() = std::clamp(slack - rig.lip.x(), -0.5, 0.0);
        return out < cable;
    };
    const bool done = rig.run_until(come_up, 900);
    rig.levers.brake = 1;
    rig.levers.speed = 0;
    rig.lip_velocity.setZero();
    return done;
}

/// A length of cable, its angle at the anchor when that begins to drag, and what holding is left then.
struct ShortCable {
    double cable;   ///< m, with the hawse pipe 31 m over the bed
    double degrees; ///< by the catenary of that length whose level pull is what the anchor holds then
    double share;   ///< of what it holds with its shank flat: practice, see uplift_share()
};

class Uplift : public testing::TestWithParam<ShortCable> {};

TEST_P(Uplift, TakesItsShareOfWhatADugInAnchorHolds) {
    const auto [cable, degrees, share] = GetParam();
    TackleRig rig = dug_in(AnchorType::hall, Soil::sand, 165);
    ASSERT_TRUE(hove_in(rig, cable));
    ASSERT_GT(rig.tackle.anchor().holding().embedment, 0.98);
    double most = 0, uplift = 0; // N, degrees
    rig.lip_velocity = {0.05, 0, 0};
    for (int second = 0; second < 240; ++second) {
        rig.run(1);
        const Vec3 lead = rig.tackle.cable_direction();
        const double pull = rig.deck().hawse_tension * std::hypot(lead.x(), lead.y());
        if (pull < most) continue;
        most = pull;
        uplift = degrees_from_radians(rig.tackle.uplift(rig.environment));
    }
    const double flat = rig.setup.anchor.mass * kGravity * holding_factor(rig.setup.anchor, Soil::sand);
    // The uplift is that of the first straight link: half of its turn above the catenary at the shackle, and
    // the peak is looked for once a second in a lead that swings by some tenths of a degree as it drags.
    EXPECT_NEAR(uplift, degrees, 1.5);
    // One degree of the table's steepest part: 0.02 of the 0.2 at 30 degrees, 0.05 of the 0.75 at 5.
    EXPECT_NEAR(most / flat / share, 1, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Scopes, Uplift,
                         testing::Values(ShortCable{104, 5, 0.75}, ShortCable{70, 15, 0.5},
                                         ShortCable{46, 30, 0.2}));

TEST(Holding, TurnsOutWhenThePullVeersAndDigsInAnew) {
    const AnchorDef def;
    const double setting = setting_distance(def, Soil::sand);
    HoldingState state;
    GroundMotion motion{.touches = true, .flukes_down = true, .dt = 0.1};
    const auto drag = [&](const Vec3& way) {
        motion.shank = way.normalized();
        motion.moved = way / 100;
        for (int k = 0; k < 100; ++k)
            update_holding(def, Soil::sand, motion, state);
    };
    drag(0.95 * setting * Vec3::UnitX());
    ASSERT_NEAR(state.embedment, 0.95, 0.01);
    motion.moved.setZero();
    motion.shank = Vec3::UnitY();
    update_holding(def, Soil::sand, motion, state);
    EXPECT_NEAR(state.embedment, 0, 1e-9); // flukes lie across the new pull
    drag(0.95 * setting * Vec3::UnitY());
    EXPECT_NEAR(state.embedment, 0.95, 0.01);
    EXPECT_LT(std::abs(state.dug.x()), 0.2); // and the old furrow is left: e^-2 of it
}

TEST(Holding, BreaksOutAsTheCrownRises) {
    const AnchorDef def;
    HoldingState state;
    GroundMotion motion{.touches = true, .flukes_down = true, .dt = 0.1};
    motion.moved = Vec3(0.01 * setting_distance(def, Soil::mud), 0, 0);
    for (int k = 0; k < 98; ++k)
        update_holding(def, Soil::mud, motion, state);
    const double weight = def.mass * kGravity;
    EXPECT_NEAR(breakout_capacity(def, Soil::mud, state) / weight, 0.98 * def.suction, 1e-3);
    motion.moved.setZero();
    for (motion.height = 0; motion.height < 0.3 * def.fluke_length; motion.height += 0.01)
        update_holding(def, Soil::mud, motion, state);
    EXPECT_EQ(breakout_capacity(def, Soil::mud, state), 0);
    EXPECT_GT(state.ball, 0.1 * weight); // mud comes up with it
}

TEST(Holding, FallsWhenBentAndOnPoorGround) {
    const AnchorDef def;
    HoldingState state{.embedment = 1};
    const double sound = holding_capacity(def, Soil::sand, state, 0);
    EXPECT_LT(holding_capacity(def, Soil::sand, state, 0, 0.5), 0.6 * sound);
    state.bent = 1;
    EXPECT_LT(holding_capacity(def, Soil::sand, state, 0), 0.6 * sound);
}

TEST(Anchor, CaughtUnderAnOldCableBendsWhenItIsPulledBeyondItsProofLoad) {
    for (const bool caught : {false, true}) {
        TackleRig rig = dug_in(AnchorType::hall, Soil::sand, 165);
        rig.causes.anchor_fouled = caught ? 1 : 0;
        rig.lip_velocity = {0.1, 0, 0};
        rig.run_until([&] { return rig.deck().hawse_tension > 1.9e6; }, 120);
        EXPECT_EQ(rig.tackle.anchor().holding().bent > 0, caught);
        EXPECT_EQ(rig.tackle.anchor().holding().fouled > 0, caught);
        ASSERT_TRUE(rig.tackle.finite());
    }
}

} // namespace
} // namespace windlass::physics
