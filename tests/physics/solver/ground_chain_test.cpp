// Chain on ground that is not level: what friction holds, the catenary on a slope, and that no shape of it
// makes energy.

#include "tests/physics/solver/chain_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace windlass::physics {
namespace {

/// A sea 200 m deep at the origin with a bed that goes down eastward.
EnvironmentDef slope(double tangent, Soil soil = Soil::sand) {
    EnvironmentDef sea = still_water(200);
    lay_bed(sea, soil);
    lay_ground(sea, {.slope = std::atan(tangent), .slope_towards = 0.5 * std::numbers::pi});
    return sea;
}

Vec3 on_bed(const EnvironmentDef& sea, double x, double y) {
    return {x, y, bed_height(sea, x, y)};
}

/// All that the chain has, and all that it gave away, J: the sum does not change.
double energy(const ChainRig& rig) {
    const Vec3 foot = rig.state.position.at(0), v = rig.state.velocity.at(0);
    return chain_energy(rig.def, rig.environment, rig.state).total() + 0.5 * rig.tail_mass * v.squaredNorm() +
           rig.tail_weight * foot.z();
}
double given(const ChainRig& rig) {
    return rig.ledger.drag + rig.ledger.bed + rig.ledger.internal;
}

class OnASlope : public testing::TestWithParam<Soil> {};

TEST_P(OnASlope, ChainSlidesIfAndOnlyIfItIsSteeperThanFriction) {
    for (const double share : {0.95, 1.05}) {
        const EnvironmentDef sea = slope(share * chain_bed(GetParam()).friction, GetParam());
        const ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
        // Along a contour, its ends as deep in the bed as the rest comes to lie; one is held.
        const Vec3 from = on_bed(sea, 0, 0), to = on_bed(sea, 0, 60);
        ChainRig rig(def, sea, from, to, 60, Foot::hanging);
        rig.run(10, 1.0 / 300);
        const Vec3 middle = rig.state.position.at(rig.state.links / 2);
        rig.run(10, 1.0 / 300);
        const double slid = rig.state.position.at(rig.state.links / 2).x() - middle.x();
        // Held, it creeps by at most 0.1 mm/s; sliding, it starts with 5 % of g sin / (1 + added mass).
        if (share < 1) {
            EXPECT_LT(slid, 1.01e-3);
        } else {
            EXPECT_GT(slid, 0.2);
        }
    }
}

TEST_P(OnASlope, ChainHauledUpAndLoweredPullsByWeightAndFriction) {
    const double friction = chain_bed(GetParam()).friction, alpha = std::atan(1.6 * friction);
    const EnvironmentDef sea = slope(1.6 * friction, GetParam());
    const ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    const double weight = weight_in_water(def, sea.water_density);
    const double deep = weight * std::cos(alpha) * std::cos(alpha) /
                        (chain_bed(GetParam()).stiffness * def.contact_diameter); // as it will lie
    const Vec3 in(0, 0, -deep), up = in + on_bed(sea, 0, 0), down = in + on_bed(sea, 50 * std::cos(alpha), 0);
    ChainRig rig(def, sea, down, up, 50, Foot::hanging);
    for (const int sense : {1, -1}) { // up, down; at 5 cm/s, so that the water does not matter
        for (int k = 0; k < 9000; ++k) {
            rig.hawse += sense * 0.05 / 300 * (up - down).normalized();
            rig.step(1.0 / 300);
        }
        const double along = weight * (std::sin(alpha) + sense * friction * std::cos(alpha));
        // Between two links clear of the ends: the foot's half link has no bed under it.
        const int low = 5, high = rig.state.links - 5;
        const double taken = rig.state.tension[high] - rig.state.tension[low];
        EXPECT_NEAR(taken / (along * (high - low) * def.node_spacing), 1, 0.005) << sense;
    }
}

INSTANTIATE_TEST_SUITE_P(Soils, OnASlope, testing::Values(Soil::mud, Soil::sand, Soil::rock));

class CatenaryOnASlope : public testing::TestWithParam<double> {};

TEST_P(CatenaryOnASlope, LiftsOffAlongTheBed) {
    // At the touchdown the pull leads along the bed, V = H tan b; from there V grows by the weight of the
    // chain: x = H / w (asinh(V / H) - asinh(tan b)), z = H / w (hypot(1, V / H) - 1 / cos b).
    const double rises = GetParam(); // tangent, towards the ship in the west
    const EnvironmentDef sea = slope(rises);
    ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    def.node_spacing = 0.5;
    const double weight = weight_in_water(def, sea.water_density);
    // Laid on the bed half of the way, then straight up to the lip: so long it is.
    const Vec3 foot = on_bed(sea, 0, 0) - Vec3(0, 0, 0.04), bend = on_bed(sea, -50, 0),
               lip = on_bed(sea, -90, 0) + Vec3(0, 0, 30);
    const double lies = (bend - foot).norm(), hangs = (lip - bend).norm();
    ChainRig rig(def, sea, foot, lip, lies + hangs, Foot::fixed);
    for (int i = 0; i <= rig.state.links; ++i) {
        const double s = (lies + hangs) * i / rig.state.links;
        rig.state.position.set(i, s < lies ? Vec3(foot + s / lies * (bend - foot))
                                           : Vec3(bend + (s - lies) / hangs * (lip - bend)));
    }
    rig.run(240, 1.0 / 240);

    const Vec3 top =
        (rig.state.position.at(rig.state.links) - rig.state.position.at(rig.state.links - 1)).normalized();
    const double tension = rig.top_tension(), horizontal = -tension * top.x();
    // The top link's pull is that of its middle.
    const double vertical = tension * top.z() + 0.5 * weight * def.node_spacing;
    const double a = horizontal / weight;
    const double x = a * (std::asinh(vertical / horizontal) - std::asinh(rises)),
                 z = a * (std::hypot(1, vertical / horizontal) - std::hypot(1, rises));
    const Vec3 touchdown = lip + Vec3(x, 0, -z);
    EXPECT_GT(x, 20);
    EXPECT_LT(x, 80) << "part of it lies";
    // It lies 4 cm deep, and lands node by node: to a quarter of a link.
    EXPECT_NEAR(height_over_bed(sea, touchdown), -0.04, 0.25 * def.node_spacing);
    for (int i = 0; i < rig.state.links; ++i) {
        const Vec3 at = rig.state.position.at(i);
        EXPECT_GT(height_over_bed(sea, at), -0.1);
        if (at.x() > touchdown.x() + 3) {
            EXPECT_LT(height_over_bed(sea, at), 0.02) << "node " << i;
        }
        if (at.x() < touchdown.x() - 8) {
            EXPECT_GT(height_over_bed(sea, at), 0.02) << "node " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Tangents, CatenaryOnASlope, testing::Values(-0.3, -0.1, 0.1, 0.3, 0.5));

/// Ground with a ledge of the given height (m), one cell wide, along the north; rock above, mud below.
EnvironmentDef ledge(double height, double spacing) {
    EnvironmentDef sea = still_water(30);
    GroundDef def{.west = -60, .south = -60, .spacing = spacing};
    def.columns = def.rows = static_cast<int>(120 / spacing) + 1;
    for (int r = 0; r < def.rows; ++r)
        for (int c = 0; c < def.columns; ++c) {
            const bool high = -60 + c * spacing < 0.1;
            def.heights.push_back(high ? height : 0);
            def.soils.push_back(high ? Soil::rock : Soil::mud);
        }
    lay_ground(sea, def);
    return sea;
}

TEST(GroundChain, ThrownAboutOnRoughGroundItNeverGainsAndTheBooksClose) {
    // Hills of 3 m in cells of 4, all soils beside each other, a chain thrown at them at 10 m/s.
    for (unsigned seed = 1; seed <= 8; ++seed) {
        std::mt19937 random(seed);
        const auto pick = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        EnvironmentDef sea = still_water(30);
        if (seed % 2 == 0) sea.water_density = 0; // nothing else that could swallow what the bed made
        GroundDef def{.west = -60, .south = -60, .spacing = 4, .columns = 31, .rows = 31};
        for (int k = 0; k < def.columns * def.rows; ++k) {
            def.heights.push_back(pick(-1.5, 1.5));
            def.soils.push_back(static_cast<Soil>(std::uniform_int_distribution<int>(0, 6)(random)));
        }
        lay_ground(sea, def);
        const ChainDef chain = stud_link_chain(0.078, Grade::k3, 330);
        ChainRig rig(chain, sea, {30, 10, -25}, {-5, 0, -24}, 40, Foot::hanging);
        for (int i = 0; i < rig.state.links; ++i)
            rig.state.velocity.set(i, {pick(-10, 10), pick(-10, 10), pick(-10, 10)});
        const double start = energy(rig);
        double min = start, booked = given(rig), worst = 0;
        const double dt = 1.0 / 600;
        for (int k = 0; k < 10 / dt; ++k) {
            rig.step(dt);
            const double now = energy(rig);
            worst = std::max(worst, now - min);
            min = std::min(min, now);
        }
        ASSERT_TRUE(std::isfinite(min));
        const double spent = start - energy(rig);
        // A thousandth: what a step of an integrator of second order swaps to and fro.
        EXPECT_LT(worst / spent, 1e-3) << "seed " << seed;
        EXPECT_NEAR((given(rig) - booked) / spent, 1, 0.02) << "seed " << seed;
    }
}

TEST(GroundChain, FallsOffALedgeAndIsHauledUpAgainWithoutBeingThrown) {
    const EnvironmentDef sea = ledge(5, 2);
    const ChainDef def = stud_link_chain(0.078, Grade::k3, 330);
    // Lies across the ledge in the air: lets go, falls down and is pulled back up over it at 1 m/s.
    ChainRig rig(def, sea, {25, 0.5, -24}, {-15, 0, -24}, 41, Foot::hanging);
    rig.run(10, 1.0 / 300);
    double fastest = 0;
    const double work_free = energy(rig) + given(rig);
    for (int k = 0; k < 9000; ++k) {
        rig.hawse.x() -= 1.0 / 300;
        rig.step(1.0 / 300);
        for (int i = 0; i <= rig.state.links; ++i)
            fastest = std::max(fastest, rig.state.velocity.at(i).norm());
    }
    EXPECT_GT(energy(rig) + given(rig), work_free) << "hauling takes work";
    EXPECT_LT(fastest, 4) << "m/s; a link whips as it comes over the edge, but none is shot off";
    EXPECT_NEAR(rig.state.position.at(0).x(), -45 + 41, 2) << "it came up the ledge";
}

TEST(GroundChain, SlidesFromMudOntoRockWithoutGaining) {
    // Half a metre deep in mud, then on rock that bears it by a millimetre, and back: no work but the haul's.
    EnvironmentDef sea = still_water(30);
    GroundDef def{.west = -100, .south = -20, .spacing = 5, .columns = 41, .rows = 9};
    for (int k = 0; k < def.columns * def.rows; ++k)
        def.soils.push_back(k % def.columns < 20 ? Soil::rock : Soil::mud);
    lay_ground(sea, def);
    const ChainDef chain = stud_link_chain(0.078, Grade::k3, 330);
    ChainRig rig(chain, sea, {50, 0, -30.4}, {10, 0, -29.9}, 40, Foot::hanging);
    rig.run(10, 1.0 / 300);
    double fastest = 0, highest = -1e9;
    for (int k = 0; k < 18000; ++k) {
        rig.hawse.x() -= std::min(1.0, k / 1500.0) / 300; // gently: a jerk would throw it by itself
        rig.step(1.0 / 300);
        for (int i = 2; i <= rig.state.links; ++i) { // the free end's half link has no bed, it swings
            fastest = std::max(fastest, rig.state.velocity.at(i).norm());
            highest = std::max(highest, rig.state.position.z[i]);
        }
    }
    EXPECT_LT(fastest, 1.5); // hauled at 1 m/s
    EXPECT_LT(highest, -29.85);
    EXPECT_NEAR(rig.state.position.z[rig.state.links / 2], -30, 0.01) << "on the rock at last";
}

} // namespace
} // namespace windlass::physics
