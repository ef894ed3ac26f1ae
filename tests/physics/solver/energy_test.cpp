// Energy and momentum: nothing comes from nowhere, nothing is lost unsaid.

#include "rigs/tackle_rig.hpp"
#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <ostream>

namespace windlass::physics {
namespace {

struct LetGo {
    double depth;     ///< m
    double brake_out; ///< m of cable at which the brake is put on
    double astern;    ///< m/s of the hull
};

void PrintTo(const LetGo& c, std::ostream* out) {
    *out << c.depth << " m deep, " << c.brake_out << " m out";
}

class EnergyTest : public testing::TestWithParam<LetGo> {};

TEST_P(EnergyTest, LetGoFromRestToBrakeStoppedCloses) {
    const LetGo& let_go = GetParam();
    rigs::TackleRig rig(TackleSetup{}, rigs::quiet_water(let_go.depth));
    rig.lip_velocity = {-let_go.astern, 0, 0};
    rig.tackle.keep_ledger();
    const double before = rig.tackle.energy(rig.environment);
    rig.run(1);
    rig.levers.brake = 0;
    ASSERT_TRUE(rig.run_until([&] { return rig.windlass().cable_out > let_go.brake_out; }, 60));
    rig.levers.brake = 1;
    rig.run(20);
    ASSERT_EQ(rig.windlass().cable_speed, 0);

    const EnergyLedger& ledger = rig.tackle.ledger();
    const double lost = before - rig.tackle.energy(rig.environment);
    EXPECT_GT(lost, 1e6);
    EXPECT_NEAR(sum(ledger) / lost, 1, 0.01); // as wanted
    // Each of these only takes.
    for (const double sink : {ledger.drag, ledger.bed, ledger.internal, ledger.pick_up, ledger.hawse,
                              ledger.brake, ledger.anchor_drag, ledger.anchor_bed, ledger.soil}) {
        EXPECT_GE(sink, -1e-3 * lost);
    }
    EXPECT_GT(ledger.brake, 0);
    EXPECT_NEAR(ledger.brake, rig.windlass().brake.heat, 1e-6 * lost); // the heat that warms the drum
}

INSTANTIATE_TEST_SUITE_P(LetGo, EnergyTest,
                         testing::Values(LetGo{25, 55, 0}, LetGo{40, 82.5, 0}, LetGo{60, 40, 0},
                                         LetGo{25, 55, 0.5}, LetGo{100, 200, 0}));

TEST(Energy, UndampedSwingKeepsItsEnergy) {
    // 100 m of chain with the anchor's mass at its end, let swing from 30 degrees, no damping of any kind.
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    def.damping_time = 0;
    const Vec3 foot(100 * std::sin(0.5), 0, -100 * std::cos(0.5));
    ChainRig rig(def, in_air(), foot, {0, 0, 0}, 100, Foot::hanging, 9900);
    const auto energy = [&] {
        return chain_energy(def, rig.environment, rig.state).total() +
               0.5 * rig.tail_mass * rig.state.velocity.at(0).squaredNorm() +
               rig.tail_weight * rig.state.position.z[0];
    };
    const double before = energy();
    const double swing = (9900 + 50 * def.mass_per_metre) * kGravity * 100 * (1 - std::cos(0.5));
    double worst = 0;
    for (int k = 0; k < 60 * 300; ++k) {
        rig.step(1.0 / 300);
        worst = std::max(worst, std::abs(energy() - before));
    }
    EXPECT_LT(worst / swing, 0.001);
}

TEST(Momentum, BalancesBetweenChainAndAnchor) {
    // Free of gravity, water and ground; the anchor is thrown aside, the chain drags on it: whatever momentum
    // one gains the other loses, and what the hawse pipe gives.
    EnvironmentDef space = in_air();
    const ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    const double extra = 0.5 * def.node_spacing * def.mass_per_metre;
    AnchorPose pose;
    pose.position = {0, 0, -52};
    pose.attitude = Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vec3::UnitY());
    Anchor anchor(AnchorDef{}, extra, space, pose);
    ChainRig rig(def, space, anchor.shackle(), {0, 0, 0}, -anchor.shackle().z() + 0.5, Foot::fixed);
    pose.velocity = {3, 1, -0.5};
    pose.spin = {0.1, -0.2, 0.3};
    anchor.set_pose(pose);
    rig.state.velocity.set(0, anchor.shackle_velocity());

    const auto momentum = [&] {
        Vec3 sum = anchor.mass() * anchor.pose().velocity;
        for (int i = 1; i < rig.state.links; ++i) {
            sum += def.mass_per_metre * node_length(def, rig.state, i) * rig.state.velocity.at(i);
        }
        return sum;
    };
    const double dt = 1.0 / 300;
    Vec3 expected = momentum();
    double worst = 0, pulled = 0;
    for (int k = 0; k < 3000; ++k) {
        const StepTime time{dt, step_kick(rig.state, dt)};
        const ChainTail tail = anchor.begin(space, time, {}, {});
        const ChainStepResult result =
            rigs::step_chain(rig.solver, rig.state, space, dt, tail, rig.locked, rig.hawse);
        anchor.finish(space, time, rig.state.velocity.at(0), nullptr);
        rig.state.position.set(0, anchor.shackle());
        rig.state.velocity.set(0, anchor.shackle_velocity());
        double weight = anchor.weight(space);
        for (int i = 1; i < rig.state.links; ++i)
            weight += def.mass_per_metre * node_length(def, rig.state, i) * kGravity;
        expected -= result.hawse_impulse + Vec3(0, 0, time.kick * weight);
        pulled = std::max(pulled, result.tail_impulse.norm() / time.kick);
        worst = std::max(worst, (momentum() - expected).norm());
    }
    EXPECT_GT(pulled, 5e4); // the chain did pull
    // Speeds come from differences of positions of 50 m: each step rounds them by 50 m x 1e-16 x 300 Hz,
    // which in 3000 steps at random adds up to 1e-10 of 3 m/s.
    EXPECT_LT(worst / (anchor.mass() * 3), 1e-9);
}

} // namespace
} // namespace windlass::physics
