// A cable whose upper end waves move: inertia, snatch, and how fine links and steps must be.

#include "rigs/tackle_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::physics {
using namespace rigs;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Loads at the hawse (N) while the lip goes up and down by so much (m, amplitude) in so many seconds.
struct Loads {
    double least = 1e300, most = -1e300;
    double in_phase = 0; ///< N, part that goes with the lip's height
    double fastest = 0;  ///< m/s, of the lip away from the anchor's centre of mass: as the cable comes taut
    bool slack = false;
};

/// The motion comes up over the first period; what is looked at are the last of so many.
Loads heave(TackleRig& rig, double amplitude, double period, int periods, int last) {
    const double omega = kTurn / period;
    const double start = rig.lip.z();
    const int steps = static_cast<int>(periods * period / rig.dt);
    Loads loads;
    int looked = 0;
    const auto height = [&](double t) { return amplitude * std::min(1.0, t / period) * std::sin(omega * t); };
    for (int k = 1; k <= steps; ++k) {
        const double t = k * rig.dt;
        rig.lip_velocity = {0, 0, (start + height(t) - rig.lip.z()) / rig.dt};
        rig.step();
        if (t < (periods - last) * period) continue;
        const double load = -rig.tackle.pull_on_ship().z(), level = rig.tackle.pull_on_ship().norm();
        loads.least = std::min(loads.least, level), loads.most = std::max(loads.most, level);
        loads.in_phase += 2 * load * std::sin(omega * t);
        loads.slack = loads.slack || rig.tackle.chain().tension[0] <= 0;
        loads.fastest = std::max(loads.fastest, rig.lip_velocity.z() - rig.tackle.anchor().motion().z());
        ++looked;
    }
    loads.in_phase /= looked;
    return loads;
}

/// An anchor on so much cable (m), up and down in deep water.
TackleRig hanging(double cable, double spacing = 1) {
    TackleSetup setup;
    setup.cable_out = cable;
    setup.chain.node_spacing = spacing;
    setup.self_contact = false;
    return {setup, quiet_water(300)};
}

TEST(CableInWaves, HangingAnchorAddsItsInertia) {
    // 0.3 m in 8 s: the load that goes with the lip's height is that of all that hangs, held up against
    // gravity less omega^2 times its mass and the water's with it. Drag is a quarter of a period off, and 1
    // %.
    constexpr double kAmplitude = 0.3, kPeriod = 8;
    TackleRig rig = hanging(60);
    rig.run(10);
    const ChainDef& chain = rig.setup.chain;
    const AnchorDef& anchor = rig.setup.anchor;
    const double under_water = 60 - 6;
    const double chain_mass = 60 * chain.mass_per_metre +
                              under_water * chain.added_mass_axial * kSeaWaterDensity * chain.displacement;
    constexpr double kSteel = 7850; // kg/m3, as the anchor's
    const double anchor_mass = anchor.mass * (1 + kAnchorAddedMass * kSeaWaterDensity / kSteel);
    const double omega = kTurn / kPeriod;
    // Cable that comes out of the water is heavier in air: a spring of rho g A.
    const double spring = weight_in_air(chain) - weight_in_water(chain, kSeaWaterDensity);
    const double told = -omega * omega * kAmplitude * (chain_mass + anchor_mass) + spring * kAmplitude;
    // 3 %: the load is that of the lip, half a link above it counts inboard.
    EXPECT_NEAR(heave(rig, kAmplitude, kPeriod, 8, 6).in_phase, told, 0.03 * std::abs(told));
}

TEST(CableInWaves, SnatchIsWhatAMassOnASpringMakesOfItsSpeed) {
    // 3 m in 3.5 s throw the lip faster downwards than the anchor sinks: slack, and then a snatch. A mass M
    // that comes taut at v on a spring k pulls by v sqrt(k M) over its weight, and no more: water and chain
    // take from it. The chain's own waves, mu c v, come on top.
    constexpr double kCable = 60;
    TackleRig rig = hanging(kCable);
    rig.run(10);
    const double rest = rig.tackle.pull_on_ship().norm();
    const Loads loads = heave(rig, 3, 3.5, 8, 6);
    ASSERT_TRUE(loads.slack);
    EXPECT_GT(loads.fastest, 0.5);
    const ChainDef& chain = rig.setup.chain;
    const double spring = chain.stiffness / (kCable + rig.setup.windlass.hawse_pipe_length);
    const double mass = 1.2 * rig.setup.anchor.mass + 0.5 * kCable * chain.mass_per_metre;
    const double waves = std::sqrt(chain.stiffness * chain.mass_per_metre) * loads.fastest;
    const double inertia = (kTurn / 3.5) * (kTurn / 3.5) * 3 * rest / 9.81;
    EXPECT_LT(loads.most, rest + inertia + loads.fastest * std::sqrt(spring * mass) + waves);
    EXPECT_GT(loads.most, 2 * rest); // and it is one
    EXPECT_LT(loads.least, 0.5 * rest);
}

/// 165 m laid out in 30 m, taut to some 250 kN at rest; then 3 m of 8 s. rate: steps a second.
Loads riding(double spacing, int rate) {
    TackleSetup setup;
    setup.chain.node_spacing = spacing;
    setup.self_contact = false;
    TackleRig rig(setup, quiet_water(30));
    rig.dt = 1.0 / rate;
    rig.lip_velocity = {-1, 0, 0}; // m/s, sternway
    rig.run_until(
        [&] {
            rig.grip(rig.windlass().cable_speed > 1.1 ? 0.4 : 0);
            return rig.windlass().cable_out >= 165;
        },
        600);
    rig.levers.brake = 1;
    rig.lip_velocity = {-0.3, 0, 0};
    rig.run_until([&] { return rig.tackle.pull_on_ship().norm() > 2.5e5; }, 300);
    rig.lip_velocity = Vec3::Zero();
    rig.run(30);
    return heave(rig, 1.5, 8, 8, 4);
}

TEST(CableInWaves, LinksOfTheExercisesAreShortEnough) {
    // The exercise's own links are 1.25 m here; the reference's half as long. The cable is laid out anew with
    // each: what it lies in is not the same to the metre, so 3 % for the peaks.
    const Loads reference = riding(0.6, 300);
    EXPECT_GT(reference.most, 1.05 * reference.least);
    for (const double spacing : {1.25, 2.5}) {
        const Loads loads = riding(spacing, 300);
        EXPECT_NEAR(loads.most / reference.most, 1, 0.03) << spacing;
        EXPECT_NEAR(loads.least / reference.least, 1, 0.06) << spacing;
    }
}

TEST(CableInWaves, StepsOfTheExercisesAreShortEnough) {
    const Loads reference = riding(1.25, 1200), loads = riding(1.25, 300), longer = riding(1.25, 100);
    EXPECT_NEAR(loads.most / reference.most, 1, 0.02);
    EXPECT_NEAR(longer.most / reference.most, 1, 0.03); // the policy's stride
}

} // namespace
} // namespace windlass::physics
