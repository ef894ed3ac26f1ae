// Coulomb's friction of the seabed in steps of an exercise: when chain starts to slide, and where it stops.

#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windlass::physics {
namespace {

constexpr double kLength = 60;

/// A dry bed of sand, level or going down eastward by the given tangent.
EnvironmentDef dry_bed(double tangent) {
    EnvironmentDef sea = still_water(200);
    sea.water_density = 0;
    lay_bed(sea, Soil::sand);
    if (tangent > 0) lay_ground(sea, {.slope = std::atan(tangent), .slope_towards = 0.5 * std::numbers::pi});
    return sea;
}

/// Chain along a contour, as deep in the bed as its weight sinks it, its ends held; a hundredth longer than
/// its way, so that no link pulls while the middle moves by some decimetres.
ChainRig lying_chain(const EnvironmentDef& sea, double alpha) {
    const ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    const double deep = def.mass_per_metre * kGravity * std::cos(alpha) * std::cos(alpha) /
                        (chain_bed(Soil::sand).stiffness * def.contact_diameter);
    const Vec3 from(0, 0, -sea.depth - deep), to(0, 0.99 * kLength, -sea.depth - deep);
    return {def, sea, from, to, kLength, Foot::fixed};
}

class EveryStep : public testing::TestWithParam<int> {};

TEST_P(EveryStep, ChainThatIsThrownStopsWhereItsSpeedIsSpent) {
    const double dt = 1.0 / GetParam(), thrown = 1;
    ChainRig rig = lying_chain(dry_bed(0), 0);
    rig.run(0.5, dt);
    const int middle = rig.state.links / 2;
    const double from = rig.state.position.x[middle];
    for (int i = 1; i < rig.state.links; ++i)
        rig.state.velocity.x[i] = thrown;
    rig.run(1, dt);
    // v^2 / 2 mu g; the speed was given half a step before.
    const double slows = rig.environment.bed_friction * kGravity, speed = thrown - 0.5 * slows * dt;
    // The step in which it stops has that much to spare: 1 mm at 1/60 s. (Friction known a step late: 14 mm.)
    EXPECT_NEAR(rig.state.position.x[middle] - from, speed * speed / (2 * slows), 0.5 * slows * dt * dt);
}

TEST_P(EveryStep, ChainThatMoreThanFrictionPullsStartsAtOnce) {
    const double dt = 1.0 / GetParam(), friction = chain_bed(Soil::sand).friction;
    const double alpha = std::atan(1.2 * friction), seconds = 0.5;
    ChainRig rig = lying_chain(dry_bed(1.2 * friction), alpha);
    const int middle = rig.state.links / 2;
    const Vec3 from = rig.state.position.at(middle);
    rig.run(seconds, dt);
    const double slid = (rig.state.position.at(middle) - from).x() / std::cos(alpha);
    const double speeds_up = kGravity * (std::sin(alpha) - friction * std::cos(alpha));
    // Nothing of it for the step, a little for the viscous creep below 0.1 mm/s. (Friction known a step late:
    // 0.02, 0.55 and 0.87 of the way, for a node crept until its speed had grown a thousandfold.)
    EXPECT_NEAR(slid / (0.5 * speeds_up * seconds * seconds), 1, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(StepsASecond, EveryStep, testing::Values(60, 300, 1200),
                         testing::PrintToStringParamName());

} // namespace
} // namespace windlass::physics
