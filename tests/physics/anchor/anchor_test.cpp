// The anchor's types, flukes and hold on the ground, pulled as a ship pulls.

#include "rigs/anchor_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace windlass::physics {
using namespace rigs;

namespace {

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
    const Held held = held_flat(soil, cable);
    EXPECT_LT(held.uplift, 0.01);                            // the shank lies flat
    EXPECT_NEAR(held.measured / held.closed_form(), 1, 0.1); // as wanted
}

INSTANTIATE_TEST_SUITE_P(SoilsAndScopes, HoldingPower,
                         testing::Combine(testing::Values(Soil::mud, Soil::sand, Soil::clay, Soil::gravel,
                                                          Soil::rock, Soil::coral, Soil::mixed),
                                          testing::Values(165.0, 220.0, 275.0)));

class Uplift : public testing::TestWithParam<ShortCable> {};

TEST_P(Uplift, TakesItsShareOfWhatADugInAnchorHolds) {
    const Held held = held_short(GetParam());
    // The uplift is that of the first straight link: half of its turn above the catenary at the shackle, and
    // the peak is looked for once a second in a lead that swings by some tenths of a degree as it drags.
    EXPECT_NEAR(degrees_from_radians(held.uplift), GetParam().degrees, 1.5);
    // One degree of the table's steepest part: 0.02 of the 0.2 at 30 degrees, 0.05 of the 0.75 at 5.
    EXPECT_NEAR(held.measured / held.closed_form(), 1, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Scopes, Uplift, testing::ValuesIn(kShortCables));

TEST(Anchor, FallsAtTheSpeedAtWhichItsDragIsItsWeight) {
    const EnvironmentDef sea = quiet_water(1000);
    for (const AnchorType type : {AnchorType::hall, AnchorType::ac14, AnchorType::shhp}) {
        const AnchorDef def = typical_anchor(type);
        AnchorPose pose; // crown down
        pose.position = {0, 0, -10};
        pose.attitude = Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vec3::UnitY());
        Anchor anchor(def, 0, sea, pose);
        constexpr double kStep = 1.0 / 300;
        for (int k = 0; k < 8 / kStep; ++k) {
            const ChainTail free = anchor.begin(sea, {kStep, kStep}, {}, {});
            anchor.finish(sea, {kStep, kStep}, free.velocity, nullptr);
        }
        const double speed = std::sqrt(anchor.weight(sea) / (0.5 * sea.water_density * def.drag_area));
        EXPECT_NEAR(-anchor.motion().z() / speed, 1, 0.001)
            << static_cast<int>(type); // 2 e^-14 is left of tanh
    }
}

// Cable that overtakes its anchor lies on the bottom before it, and under it; and the side to which flukes
// hang would decide to which side an anchor falls over that has landed.
TEST(Anchor, LeadsItsCableToTheBottomWithItsFlukesTrailingAlongItsShank) {
    for (const double depth : {25.0, 40.0})
        for (const AnchorType type : {AnchorType::hall, AnchorType::spek}) {
            TackleSetup setup;
            setup.anchor = typical_anchor(type);
            TackleRig rig(setup, quiet_water(depth));
            rig.lip_velocity = {0.4, 0, 0};
            rig.levers.brake = 0;
            const auto near_the_bottom = [&] { return rig.tackle.anchor().clearance(rig.environment) < 0.5; };
            ASSERT_TRUE(rig.run_until(near_the_bottom, 60));
            const double way = (rig.lip - rig.tackle.anchor().shackle()).norm();
            EXPECT_LT(rig.windlass().cable_out - way, 1) << depth; // m: less than the shank is long
            EXPECT_LT(std::abs(rig.tackle.anchor().fluke_angle()), radians_from_degrees(10)) << depth;
        }
}

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
    EXPECT_NEAR(breakout_capacity(def, Soil::mud, state) / weight, 0.98 * kAnchorSuction, 1e-3);
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

// Caught, it does not turn into a pull. What it takes along its shank bends it across: let her swing back
// into the line in which it dug in before anything heaves.
TEST(Anchor, CaughtAnchorBendsWhenPulledAcrossItsShankAndNotInLine) {
    for (const bool across : {false, true}) {
        TackleRig rig = dug_in(AnchorType::hall, Soil::sand, 165);
        rig.causes.anchor_fouled = 1;
        const Vec3 shackle = rig.tackle.anchor().shackle();
        Vec3 way = Vec3::UnitX();
        if (across) { // she swings on the chord, with a slack cable
            const double reach = rig.lip.x() - shackle.x();
            way = Vec3::UnitY();
            const Vec3 to = Vec3(shackle.x(), shackle.y() + 0.97 * reach, rig.lip.z()) - rig.lip;
            rig.lip_velocity = to.normalized();
            rig.run(to.norm());
            EXPECT_EQ(rig.tackle.anchor().holding().bent, 0);
        }
        rig.lip_velocity = 0.1 * way;
        ASSERT_TRUE(rig.run_until([&] { return rig.deck().hawse_tension > 6e5; }, 240));
        EXPECT_EQ(rig.tackle.anchor().holding().bent > 0, across);
        EXPECT_EQ(rig.tackle.anchor().holding().fouled, 1);
    }
}

} // namespace
} // namespace windlass::physics
