// Hull forces against tables of the literature, and against what no hull can do.

#include "server/physics/sea/environment.hpp"
#include "server/physics/ship/ship_dynamics.hpp"
#include "tests/physics/ship/kvlcc2.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace windlass::physics {
namespace {

constexpr double kDeep = 1e6; // m

ShipDef panamax() {
    ShipDef ship;
    ship.length_overall = ship.length_pp = 225, ship.beam = 32, ship.draught = 12.5;
    return ship;
}

ShipDef car_carrier() {
    ShipDef ship;
    ship.length_overall = 200, ship.length_pp = 190, ship.beam = 32.26, ship.draught = 9;
    ship.displacement = 33.5e6;
    return ship;
}

ShipDef in_ballast(double trim) {
    ShipDef ship;
    ship.beam = 32.26, ship.draught = 6, ship.displacement = 35.5e6, ship.trim = trim;
    return ship;
}

EnvironmentDef still_water(double depth) {
    EnvironmentDef sea;
    sea.depth = depth;
    sea.wind_speed = sea.current_speed = 0;
    return sea;
}

double drag_beam_on(const ShipDef& ship, double draughts) {
    const HullCoefficients hull = in_depth(hull_coefficients(ship), draughts * ship.draught);
    const PlanarForce force = hull_force(hull, kSeaWaterDensity, 0, 0.5, 0);
    EXPECT_EQ(force.x, 0);
    EXPECT_EQ(force.moment, 0);
    return -force.y / (0.5 * kSeaWaterDensity * hull.length * hull.draught * 0.25);
}

/// W, that water takes out of a motion: what the hull's force takes, and what the added mass, whose turning
/// moment is in N_v, would else give back.
double power_lost(const HullCoefficients& hull, double u, double v, double r) {
    const PlanarForce force = hull_force(hull, kSeaWaterDensity, u, v, r);
    return -(force.x * u + force.y * v + force.moment * r + (hull.added_sway - hull.added_surge) * u * v * r);
}

TEST(HullForce, IsNoneAtRest) {
    const PlanarForce force = hull_force(hull_coefficients(panamax()), kSeaWaterDensity, 0, 0, 0);
    EXPECT_EQ(force.x, 0);
    EXPECT_EQ(force.y, 0);
    EXPECT_EQ(force.moment, 0);
}

// UFC 4-159-03 (2005), Table 4-6 and its eq. 11 to 13, for these two hulls; 2 %: the midship's coefficient.
TEST(HullForce, DragBeamOnGrowsAsTheKeelComesNearTheGround) {
    struct Row {
        double draughts, panamax, vlcc;
    };
    for (const Row& row : {Row{1.2, 2.42, 2.40}, Row{1.5, 1.78, 1.74}, Row{2, 1.28, 1.23}, Row{3, 0.92, 0.87},
                           Row{4, 0.80, 0.74}, Row{6, 0.71, 0.65}}) {
        EXPECT_NEAR(drag_beam_on(panamax(), row.draughts), row.panamax, 0.02 * row.panamax) << row.draughts;
        EXPECT_NEAR(drag_beam_on(kvlcc2(), row.draughts), row.vlcc, 0.02 * row.vlcc) << row.draughts;
    }
}

// As measured: 0.137 of the dynamic pressure on L^2 T; a Munk moment beside it would make 0.34. A table of
// particulars knows no single hull: 7 %.
TEST(HullForce, ObliqueTowTurnsHerAsMeasuredAndNotTwice) {
    const HullCoefficients hull = hull_coefficients(kvlcc2());
    for (const double degrees : {2.0, 6.0, 10.0}) {
        const double drift = degrees * std::numbers::pi / 180, u = 4 * std::cos(drift),
                     v = 4 * std::sin(drift);
        const PlanarForce force = hull_force(hull, kSeaWaterDensity, u, v, 0);
        const double unit = 0.5 * kSeaWaterDensity * 320 * 320 * 20.8 * 16;
        EXPECT_NEAR(force.moment / (unit * std::sin(drift)), Kvlcc2Measured::n_v, 0.07 * 0.137) << degrees;
    }
}

// KVLCC2's, measured. Side force by drift comes out a third too large, the rest within 15 %: so much is left
// to a formula that knows length, beam, draught and block coefficient alone.
TEST(HullForce, CoefficientsOfParticularsAreNearMeasuredOnes) {
    using Measured = Kvlcc2Measured;
    const HullCoefficients hull = hull_coefficients(kvlcc2());
    const double unit = 0.5 * kSeaWaterDensity * 320 * 320 * 20.8;
    EXPECT_NEAR(hull.side_drift, Measured::y_v, 0.33 * 0.315);
    EXPECT_NEAR(hull.side_yaw - hull.added_surge / unit, Measured::y_r - Measured::m_x, 0.7 * 0.061);
    EXPECT_NEAR(hull.turn_yaw, Measured::n_r, 0.15 * 0.049);
    EXPECT_NEAR(hull.added_surge / unit, Measured::m_x, 0.06 * 0.022);
    EXPECT_NEAR(hull.added_sway / unit, Measured::m_y, 0.06 * 0.223);
    EXPECT_NEAR(hull.added_yaw / (unit * 320 * 320), Measured::j_z, 0.06 * 0.011);
}

// Van Berlekom and Goddard (1972), tanker of 190 000 t: added masses by depth over draught; and linear terms
// of KVLCC2 by Taimuri and others (2020), doi 10.1016/j.oceaneng.2020.108103: 3 %, and a rounded figure.
TEST(HullForce, ShallowWaterMakesItAllHeavier) {
    const HullCoefficients deep = hull_coefficients(kvlcc2());
    struct Row {
        double draughts, sway, surge, yaw, side_drift, turn_drift;
    };
    constexpr double kNone = 0;
    for (const Row& row : {Row{1.1, 4.9, 0.55, 1.37, kNone, kNone}, Row{1.2, 3.0, 0.30, 1.18, 4.2, 4.5},
                           Row{1.5, 1.79, 0.15, 1.07, 2.0, 2.1}, Row{2, 1.41, 0.10, 1.04, 1.37, 1.40},
                           Row{3, 1.21, 0.075, 1.02, 1.11, 1.14}}) {
        const HullCoefficients c = in_depth(deep, row.draughts * deep.draught);
        const auto near = [&](double ratio, double told) {
            EXPECT_NEAR(ratio, told, 0.03 * told + 0.005) << row.draughts;
        };
        near(c.added_sway / deep.added_sway, row.sway / 1.02);
        near(c.added_surge / deep.added_surge, row.surge / 0.05);
        near((c.inertia + c.added_yaw) / (deep.inertia + deep.added_yaw), row.yaw);
        if (row.side_drift == kNone) continue;
        near(c.side_drift / deep.side_drift, row.side_drift);
        near(c.turn_drift / deep.turn_drift, row.turn_drift);
    }
    EXPECT_EQ(in_depth(deep, deep.draught).cross_flow, in_depth(deep, 1.1 * deep.draught).cross_flow);
}

TEST(HullForce, TurningOnTheSpotIsBrakedByTheSquareOfTheTurn) {
    const HullCoefficients hull = hull_coefficients(panamax());
    const double once = hull_force(hull, kSeaWaterDensity, 0, 0, 0.002).moment;
    EXPECT_LT(once, 0);
    EXPECT_NEAR(hull_force(hull, kSeaWaterDensity, 0, 0, 0.004).moment, 4 * once, 1e-9 * -once);
    EXPECT_NEAR(hull_force(hull, kSeaWaterDensity, 0, 0, -0.004).moment, -4 * once, 1e-9 * -once);
    EXPECT_EQ(hull_force(hull, kSeaWaterDensity, 0, 0, 0.002).y, 0);
}

TEST(HullForce, IsTheSameOnBothSides) {
    const HullCoefficients hull = in_depth(hull_coefficients(panamax()), 20);
    const PlanarForce a = hull_force(hull, kSeaWaterDensity, -1, 0.7, 0.003);
    const PlanarForce b = hull_force(hull, kSeaWaterDensity, -1, -0.7, -0.003);
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, -b.y);
    EXPECT_EQ(a.moment, -b.moment);
}

// The stern, which is deeper, hangs back: where she is pushed sideways her drag acts at the middle of the
// area under water, and where she turns on the spot she is pushed to where her bow goes.
TEST(HullForce, DragActsWhereHerAreaIs) {
    ShipDef ship = in_ballast(2.5);
    const HullCoefficients hull = in_depth(hull_coefficients(ship), 20);
    const PlanarForce aside = hull_force(hull, kSeaWaterDensity, 0, 0.5, 0);
    EXPECT_NEAR(aside.moment / aside.y, -ship.trim / ship.draught * ship.length_pp / 12, 1e-9);
    EXPECT_NEAR(aside.y,
                hull_force(in_depth(hull_coefficients(in_ballast(0)), 20), kSeaWaterDensity, 0, 0.5, 0).y,
                1e-6);
    const PlanarForce round = hull_force(hull, kSeaWaterDensity, 0, 0, 0.002);
    EXPECT_GT(round.y, 0);
    // The integrals against sums over 20 000 strips, with the turning point within the hull and beyond it.
    for (const double v : {0.02, 0.4}) {
        const double r = 0.002, drag = 0.5 * kSeaWaterDensity * hull.cross_flow;
        double side = 0, moment = 0;
        constexpr int kStrips = 20000;
        for (int k = 0; k < kStrips; ++k) {
            const double x = ship.length_pp * ((k + 0.5) / kStrips - 0.5), strip = ship.length_pp / kStrips;
            const double a = v + 2.22 * r * x, b = v + 0.81 * r * x;
            side -= drag * ship.draught_at(x) * std::abs(a) * a * strip;
            moment -= drag * ship.draught_at(x) * std::abs(b) * b * x * strip;
        }
        const PlanarForce force = hull_force(hull, kSeaWaterDensity, 0, v, r);
        EXPECT_NEAR(force.y, side, 1e-6 * std::abs(side));
        EXPECT_NEAR(force.moment, moment, 1e-6 * std::abs(moment));
    }
}

// By the stern she is steadier on her course: at the same rudder she turns in a wider circle (as every seaman
// knows her), by the head in a smaller one.
TEST(ShipDynamics, TrimByTheSternWidensHerTurn) {
    const auto diameter = [](double trim) {
        ShipDef ship = in_ballast(trim);
        ship.lateral_windage = ship.frontal_windage = 1e-9;
        ShipState state;
        state.surge = 5;
        ShipDynamics dynamics(ship);
        const EnvironmentDef sea = still_water(200);
        constexpr double kStep = 0.02;
        double turned = 0;
        for (int k = 0; k < 3600 / kStep && turned < std::numbers::pi; ++k) {
            dynamics.step(sea, {.engine = 0.5, .rudder = 0.35}, {}, {}, kStep, state);
            turned += kStep * state.yaw_rate;
        }
        EXPECT_GE(turned, std::numbers::pi) << trim; // in an hour
        return state.x;
    };
    EXPECT_GT(diameter(2.5), 1.1 * diameter(0));
    EXPECT_LT(diameter(-1), diameter(0));
}

TEST(HullForce, NeverGivesEnergy) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> speed(-5, 5), rate(-0.03, 0.03);
    for (const ShipDef& ship : {ShipDef{}, kvlcc2(), car_carrier(), in_ballast(2.5), in_ballast(-1)}) {
        const HullCoefficients deep = hull_coefficients(ship);
        for (const double draughts : {1.1, 1.2, 1.5, 2.0, 3.0, kDeep}) {
            const HullCoefficients hull = in_depth(deep, draughts * ship.draught);
            for (int k = 0; k < 20000; ++k) {
                const double u = speed(random), v = speed(random), r = rate(random);
                ASSERT_GT(power_lost(hull, u, v, r), 0) << draughts << ' ' << u << ' ' << v << ' ' << r;
            }
        }
    }
}

// Seen from a stream, a ship moves as in still_water water, however she turns: what the stream gives her on
// one leg of a circle it takes on the other.
TEST(ShipDynamics, MovesInAStreamAsInStillWater) {
    ShipDef ship;
    ship.lateral_windage = ship.frontal_windage = 1e-9; // the air does not go with the stream
    EnvironmentDef sea = still_water(25), stream = still_water(25);
    stream.current_speed = 1.5, stream.current_towards = 1;
    const Vec3 set = 1.5 * compass(1);
    ShipState in_still, in_stream;
    in_still.surge = 4, in_still.heading = 0.4;
    in_stream = in_still;
    in_stream.surge += set.dot(forward(in_stream)), in_stream.sway += set.dot(starboard(in_stream));
    ShipDynamics dynamics(ship);
    constexpr double kStep = 0.01, kTime = 1800;
    const Helm helm{.engine = 0.5, .rudder = 0.6};
    double turned = 0;
    for (int k = 1; k <= kTime / kStep; ++k) {
        dynamics.step(sea, helm, {}, {}, kStep, in_still);
        dynamics.step(stream, helm, {}, {}, kStep, in_stream);
        turned += kStep * in_still.yaw_rate;
    }
    EXPECT_GT(turned, 2 * std::numbers::pi);
    // The Euler step of a velocity that turns, half a step times rate times stream: 0.1 mm/s at 0.01 rad/s.
    EXPECT_NEAR(in_stream.heading, in_still.heading, 2e-3);
    EXPECT_NEAR((ship_velocity(in_stream) - set - ship_velocity(in_still)).norm(), 0, 2e-3);
    EXPECT_NEAR(in_stream.x - kTime * set.x(), in_still.x, 1);
    EXPECT_NEAR(in_stream.y - kTime * set.y(), in_still.y, 1);
}

} // namespace
} // namespace windlass::physics
