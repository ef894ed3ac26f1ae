// The chain against a measured one: Lindahl's tank test (Chalmers, 1985), a chain whose top is driven round a
// vertical circle until it goes slack and snaps taut in every turn. Figures of the published series: top
// tension at most 72.7 +- 0.8 N, mean 26.45 N, 20.7 % of the time below 2 N; at rest 22.7 N.

#include "tests/physics/chain_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace windlass::physics {
namespace {

constexpr double kLength = 33, kDepth = 3, kPeriod = 1.25, kRadius = 0.2;
const Vec3 kFoot(0, 0, -kDepth), kTop(32.554, 0, 0.3);

ChainRig tank(int links) {
    ChainDef def;
    def.diameter = 0.0022;
    def.mass_per_metre = 0.0818;
    def.stiffness = 1e4;
    def.damping_time = 0; // none is given for the tank's chain
    def.displacement = def.mass_per_metre / 7800;
    def.drag_normal = 2.5;
    def.drag_axial = 0.5;
    def.added_mass_normal = 0.01445 / (1000 * def.displacement);
    def.added_mass_axial = 0;
    def.contact_diameter = def.diameter;
    def.node_spacing = kLength / links;
    EnvironmentDef environment = still_water(kDepth);
    environment.water_density = 1000;
    environment.bed_friction = 0.3;
    environment.bed_stiffness = 3e6; // stiff: the chain sinks in by a tenth of its diameter

    ChainRig rig(def, environment, kFoot, kTop, kLength, Foot::fixed);
    // Laid along the floor, then straight up to the top: to settle from.
    const double lying = 20.56; // lying + hypot(32.554 - lying, 3.3) = 33
    const Vec3 touchdown(lying, 0, -kDepth);
    for (int i = 0; i <= links; ++i) {
        const double s = kLength * i / links;
        rig.state.position.set(
            i, s < lying ? Vec3(s, 0, -kDepth)
                         : Vec3(touchdown + (kTop - touchdown) * ((s - lying) / (kLength - lying))));
    }
    rig.run(30, 0.005);
    return rig;
}

TEST(Tank, HangsWithTheMeasuredChainsRestTension) {
    const ChainRig rig = tank(40);
    EXPECT_NEAR(rig.top_tension(), 22.7, 0.02 * 22.7); // 2 %: half a link's weight below the top, 0.3 N
}

TEST(Tank, SnapsAsTheMeasuredChain) {
    ChainRig rig = tank(40);
    const double dt = 0.001;
    double sum = 0, largest = 0;
    int counted = 0, slack = 0;
    for (int k = 1; k * dt < 30 * kPeriod; ++k) {
        const double t = k * dt, turn = 2 * std::numbers::pi * t / kPeriod;
        const double grown =
            t < kPeriod ? (1 + std::sin(std::numbers::pi * t / kPeriod - 0.5 * std::numbers::pi)) / 2 : 1;
        rig.hawse = kTop + grown * kRadius * Vec3(std::cos(turn), 0, -std::sin(turn));
        rig.step(dt);
        if (t < 10 * kPeriod) continue; // the first turns differ
        sum += rig.top_tension();
        largest = std::max(largest, rig.top_tension());
        ++counted;
        slack += rig.top_tension() < 2;
    }
    EXPECT_NEAR(largest / 72.7, 1, 0.03);          // the record's own spread is 1.1 %
    EXPECT_NEAR(sum / counted / 26.45, 1, 0.06);   // MoorDyn 2.7.1 has 27.9
    EXPECT_NEAR(100.0 * slack / counted, 20.7, 4); // MoorDyn 2.7.1 has 16.7
}

} // namespace
} // namespace windlass::physics
