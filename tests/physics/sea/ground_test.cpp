// Anchor and chain on the seabed: holding, dragging, uplift, friction; and that nothing breaks the numbers.

#include "rigs/tackle_rig.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace windlass::physics {
using namespace rigs;

namespace {

/// Lays the anchor and the given length of cable (m) out over the bottom, brake on, hull at rest.
TackleRig laid_out(double depth, double cable, Soil soil = Soil::sand) {
    EnvironmentDef environment = quiet_water(depth);
    environment.soil = soil;
    TackleRig rig(TackleSetup{}, environment);
    // With a little way on: one that falls over on its own cable stands on it, and presses it in.
    rig.levers.brake = 0;
    rig.lip_velocity = {0.4, 0, 0};
    rig.run_until([&] { return rig.windlass().cable_out > depth + 10; }, 60);
    // Checked and given as the hull moves away, so that it does not pile up.
    rig.lip_velocity = {0.8, 0, 0};
    rig.run_until(
        [&] {
            rig.grip(rig.windlass().cable_out > depth + 10 + rig.lip.x() ? 0.1 : 0);
            return rig.windlass().cable_out > cable;
        },
        600);
    rig.levers.brake = 1;
    rig.run(3);
    rig.lip_velocity.setZero();
    return rig;
}

TEST(Holding, FactorsFallWithUplift) {
    EXPECT_EQ(uplift_share(0), 1);
    EXPECT_NEAR(uplift_share(radians_from_degrees(5)), 0.75, 1e-12);
    EXPECT_NEAR(uplift_share(radians_from_degrees(15)), 0.5, 1e-12);
    EXPECT_EQ(uplift_share(radians_from_degrees(90)), 0);
}

TEST(Holding, DigsInOverTheSettingDistanceAndDragsAtTheResidual) {
    const AnchorDef def;
    HoldingState state;
    const double weight = def.mass * kGravity, setting = setting_distance(def, Soil::sand);
    GroundMotion motion{.touches = true, .flukes_down = true, .dt = 0.1};
    update_holding(def, Soil::sand, motion, state);
    EXPECT_NEAR(holding_capacity(def, Soil::sand, state, 0) / weight, kAnchorBedFriction, 1e-12);
    motion.moved = Vec3(0.01 * setting, 0, 0);
    for (int k = 0; k < 100; ++k)
        update_holding(def, Soil::sand, motion, state);
    // The last of those steps already counts as sliding on: 1 % of the setting distance.
    EXPECT_NEAR(holding_capacity(def, Soil::sand, state, 0) / weight / def.holding_sand, 1, 0.02);
    motion.moved = Vec3(5.5 * def.fluke_length, 0, 0);
    update_holding(def, Soil::sand, motion, state);
    EXPECT_TRUE(state.dragging);
    EXPECT_NEAR(holding_capacity(def, Soil::sand, state, 0) / weight, def.holding_dragging, 1e-9);
    motion.touches = false;
    update_holding(def, Soil::sand, motion, state);
    EXPECT_FALSE(state.landed);
    EXPECT_EQ(state.embedment, 0);
}

TEST(Holding, HullPulledSlowlyAwayDigsTheAnchorInUntilItHolds) {
    TackleRig rig = laid_out(25, 165);
    rig.lip_velocity = {0.1, 0, 0};
    ASSERT_TRUE(rig.run_until([&] { return rig.tackle.anchor().holding().embedment > 0.99; }, 600));
    // The anchor gives what holding factor x weight says, while the cable at its shackle lies flat.
    const double expected = rig.setup.anchor.holding_sand * rig.setup.anchor.mass * kGravity;
    rig.run(1);
    EXPECT_NEAR(holding_capacity(rig.setup.anchor, Soil::sand, rig.tackle.anchor().holding(),
                                 rig.tackle.uplift(rig.environment)) /
                    expected,
                1, 0.05);
    EXPECT_LT(rig.tackle.uplift(rig.environment),
              radians_from_degrees(2)); // below zero: from the shank down to the mud
}

TEST(Holding, AnchorUnderALevelPullLiesWithItsShankFlat) {
    // It lands standing on its crown; the pull at the shackle, which the soil resists at the crown, lays it
    // down.
    TackleRig rig = laid_out(25, 165);
    rig.lip_velocity = {0.1, 0, 0};
    ASSERT_TRUE(rig.run_until([&] { return rig.tackle.anchor().holding().embedment > 0.9; }, 600));
    const Anchor& anchor = rig.tackle.anchor();
    const AnchorDef& def = rig.setup.anchor;
    const Vec3 shank = anchor.pose().attitude * Vec3::UnitX();
    // Crown and shank end touch: the shank slopes by the difference of their half thickness, 2 degrees.
    EXPECT_NEAR(shank.z(), 0, std::sin(radians_from_degrees(4)));
    EXPECT_LT(anchor.shackle().z(), -rig.environment.depth + 0.15 * def.crown_width);
    EXPECT_GT(shank.x(), std::cos(radians_from_degrees(10))); // and points to the hull
}

TEST(Ground, CableOnTheBottomTakesUpPullByFriction) {
    TackleRig rig = laid_out(25, 165);
    rig.lip_velocity = {0.05, 0, 0};
    rig.run(60);
    rig.lip_velocity.setZero();
    rig.run(60);
    // From the touchdown to the anchor the tension falls by at most friction x weight for each metre, and no
    // node of the chain is left hanging in the mud or in the air.
    const ChainState& chain = rig.tackle.chain();
    const double per_metre =
        rig.environment.bed_friction * weight_in_water(rig.setup.chain, kSeaWaterDensity);
    for (int i = 1; i < chain.links; ++i) {
        const bool down =
            chain.position.z[i] < -rig.environment.depth && chain.position.z[i + 1] < -rig.environment.depth;
        if (down) {
            EXPECT_LT(std::abs(chain.tension[i] - chain.tension[i - 1]),
                      1.1 * per_metre * rig.setup.chain.node_spacing);
        }
        // What the anchor stands on, it presses in.
        const Anchor& anchor = rig.tackle.anchor();
        const bool under = (chain.position.at(i) - anchor.pose().position).norm() < anchor.reach() + 1;
        EXPECT_GT(chain.position.z[i], -rig.environment.depth - (under ? 0.45 : 0.2));
    }
}

TEST(Ground, LyingToItsAnchorTheCableIsACatenary) {
    TackleRig rig = laid_out(25, 165);
    rig.lip_velocity = {0.05, 0, 0};
    ASSERT_TRUE(rig.run_until([&] { return rig.deck().hawse_tension > 2e5; }, 900));
    rig.lip_velocity.setZero();
    rig.run(120);
    // T_top = H + w y, with the part above water at its weight in air.
    const Vec3 lead = rig.tackle.cable_direction();
    const double top = rig.deck().hawse_tension, horizontal = top * std::hypot(lead.x(), lead.y());
    const double rise =
        weight_in_water(rig.setup.chain, kSeaWaterDensity) * 25 + weight_in_air(rig.setup.chain) * 6;
    EXPECT_NEAR(top / (horizontal + rise), 1,
                0.01); // 1 %: lead of a top link of a metre, half a link below the lip
}

/// Random levers and hull motion, in shallow and deep water, with the anchor anywhere: finite, and the cable
/// never longer than there is.
void handle_wildly(unsigned seed) {
    std::mt19937 random(seed);
    const auto pick = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    TackleSetup setup;
    setup.chain.node_spacing = pick(0.5, 3);
    setup.cable_out = pick(2 * setup.chain.node_spacing, 200);
    const EnvironmentDef sea = quiet_water(pick(8, 120));
    setup.cable_out = std::min(setup.cable_out, sea.depth); // hangs clear of the bottom at the start
    TackleRig rig(setup, sea);
    for (int move = 0; move < 25; ++move) {
        rig.levers = {pick(-0.5, 1), pick(-1, 1), pick(0, 1) > 0.5, pick(0, 1) > 0.9, pick(0, 1) > 0.95};
        rig.levers.brake = std::max(0.0, rig.levers.brake);
        rig.lip_velocity = {pick(-4, 4), pick(-4, 4), 0};
        rig.run(pick(0.2, 6));
        ASSERT_TRUE(rig.tackle.finite()) << "seed " << seed << " move " << move;
        const double up_the_locker =
            rig.windlass().bitter_end_parted ? rig.tackle.setup().windlass.locker_lift : 0;
        ASSERT_LE(rig.windlass().cable_out, rig.tackle.bitter_end() + up_the_locker + 1e-6);
    }
}

TEST(Robustness, WildHandlingNeverMakesNumbersThatAreNone) {
    for (unsigned seed = 1; seed <= 8; ++seed)
        handle_wildly(seed);
}

TEST(RobustnessOfMany, WildHandlingNeverMakesNumbersThatAreNone) { // in the long run
    for (unsigned seed = 9; seed <= 96; ++seed)
        handle_wildly(seed);
}

} // namespace
} // namespace windlass::physics
