// Chain running out freely: its speed against the closed form, its load across nodes that come and go.

#include "rigs/grip_in_proportion.hpp"
#include "rigs/tackle_rig.hpp"
#include "server/physics/tackle/hawse_pipe_fit.hpp"
#include "tests/physics/tackle/laid_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

namespace windlass::physics {
using namespace rigs;

namespace {

/// Steady speed of chain running out with the anchor on the bottom and the brake open, m/s. Pull at the
/// gypsy: weight of the hanging chain less its drag, through the hawse pipe; against it the chain lifted from
/// the locker and the momentum that it takes to pick it up, m v^2.
double steady_speed(const TackleSetup& setup, double depth, double air_height) {
    const double efficiency = kHawseEfficiency;
    const double drag = 0.5 * kSeaWaterDensity * setup.chain.drag_axial * setup.chain.diameter;
    const double pull = efficiency * (weight_in_water(setup.chain, kSeaWaterDensity) * depth +
                                      weight_in_air(setup.chain) * air_height) -
                        weight_in_air(setup.chain) * setup.windlass.locker_lift;
    return std::sqrt(pull / (setup.chain.mass_per_metre + efficiency * drag * depth));
}

/// Lets go and runs until the speed has settled, with plenty of cable.
double settled_speed(TackleSetup setup, double depth) {
    setup.chain.length = 2000;
    setup.brake = 0;
    setup.self_contact = false; // the formula knows no heap: in 20 m one of 4 m takes 7 % of the speed
    TackleRig rig(setup, quiet_water(depth));
    // Half of the chain's weight hangs on the hawse pipe's 12 m from waterline to gypsy: 6 m outboard, 6 m in
    // the pipe.
    double before = 0;
    for (int second = 0; second < 120; second += 4) {
        rig.run(4);
        if (rig.windlass().cable_out > depth + 60 &&
            std::abs(rig.windlass().cable_speed - before) < 0.002 * before)
            break;
        before = rig.windlass().cable_speed;
    }
    return rig.windlass().cable_speed;
}

TEST(PayOut, SettlesAtTheClosedFormInEveryDepth) {
    for (const double depth : {20.0, 40.0, 100.0}) {
        const TackleSetup setup;
        // 2 %: the chain piles up over half a metre, and the speed is still creeping up by 0.2 % in 4 s.
        EXPECT_NEAR(settled_speed(setup, depth) / steady_speed(setup, depth, 12), 1, 0.02) << depth << " m";
    }
}

TEST(PayOut, SettlesAtTheTabulatedSpeedOfTheDefaultChain) {
    // Table of 78 mm chain, 12 m from waterline to gypsy, 10 m locker lift, efficiency 0.7, inelastic
    // pick-up: 6.5, 7.6, 8.4 m/s. 10 % is wanted.
    const double table[][2] = {{20, 6.5}, {40, 7.6}, {100, 8.4}};
    for (const auto& [depth, speed] : table) {
        EXPECT_NEAR(settled_speed({}, depth) / speed, 1, 0.10) << depth << " m";
    }
}

TEST(PayOut, SettlesAtTheTabulatedSpeedWithoutDrag) {
    // Same table, no drag: 10.2 and 14.9 m/s in 20 and 40 m. (In 100 m it takes more chain than any ship
    // has.)
    const double table[][2] = {{20, 10.2}, {40, 14.9}};
    for (const auto& [depth, speed] : table) {
        TackleSetup setup;
        setup.chain.drag_axial = setup.chain.drag_normal = 0;
        EXPECT_NEAR(settled_speed(setup, depth) / speed, 1, 0.10) << depth << " m";
    }
}

enum class Work { let_go, walk_back, heave, heave_at_long_stay };

struct FeedCase {
    Work work;
    double spacing; ///< m
};

/// What GoogleTest prints of a case.
void PrintTo(const FeedCase& c, std::ostream* out) {
    *out << c.spacing << " m";
}

std::string feed_name(const testing::TestParamInfo<FeedCase>& info) {
    static const char* const kNames[] = {"LetGo", "WalkBack", "Heave", "HeaveAtLongStay"};
    return std::string(kNames[static_cast<int>(info.param.work)]) +
           std::to_string(static_cast<int>(info.param.spacing * 10)) + "dm";
}

/// How cable leaves or comes in, and how finely it is modelled.
class FeedTest : public testing::TestWithParam<FeedCase> {};

TEST_P(FeedTest, LoadDoesNotJumpWhenANodeComesOrGoes) {
    const auto [work, spacing] = GetParam();
    TackleSetup setup;
    setup.chain.node_spacing = spacing;
    const ShipDef ship; // her hawse pipe: friction in it goes by the lead, and so by the nodes at the lip
    setup.pipe = fit_hawse_pipe(ship, setup.windlass, setup.chain, setup.anchor,
                                hull_mesh(ship, setup.chain.contact_diameter), -1);
    setup.clutch_in = work != Work::let_go;
    setup.brake = 0;
    grip_in_proportion(setup.windlass);
    setup.cable_out = work == Work::heave ? 45 : 10;
    TackleRig rig(setup, quiet_water(work == Work::heave_at_long_stay ? 25 : 90));
    if (work == Work::heave_at_long_stay) {
        ASSERT_TRUE(lay_out_and_gear_in(rig, {1, 0, 0}));
    }
    rig.levers.speed = work == Work::let_go ? 0 : work == Work::walk_back ? -1 : 0.4;
    rig.run(3);

    double worst = 0, before = rig.deck().gypsy_load;
    int changes = 0, links = rig.tackle.chain().links, since = 99;
    for (int k = 0; k < 300 * (work == Work::let_go ? 5 : 30); ++k) {
        rig.step();
        const double load = rig.deck().gypsy_load;
        if (++since <= 3) worst = std::max(worst, std::abs(load / before - 1));
        before = load;
        if (rig.tackle.chain().links != links) ++changes, since = 0;
        links = rig.tackle.chain().links;
    }
    EXPECT_GE(changes, 2);
    EXPECT_LT(worst, 5e-3); // of the load, in each of the three steps after; as wanted
}

INSTANTIATE_TEST_SUITE_P(Spacing, FeedTest,
                         testing::Values(FeedCase{Work::let_go, 0.5}, FeedCase{Work::let_go, 1},
                                         FeedCase{Work::let_go, 2}, FeedCase{Work::walk_back, 0.5},
                                         FeedCase{Work::walk_back, 1}, FeedCase{Work::walk_back, 2},
                                         FeedCase{Work::heave, 0.5}, FeedCase{Work::heave, 1},
                                         FeedCase{Work::heave, 2}, FeedCase{Work::heave_at_long_stay, 0.5},
                                         FeedCase{Work::heave_at_long_stay, 1},
                                         FeedCase{Work::heave_at_long_stay, 2}),
                         feed_name);

} // namespace
} // namespace windlass::physics
