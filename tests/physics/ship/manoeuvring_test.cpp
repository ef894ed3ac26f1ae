// KVLCC2 on trial, at 15.5 kn: the MMG standard method as published, and the server's hull of her
// particulars.

#include "server/physics/base/units.hpp"
#include "server/physics/ship/ship_dynamics.hpp"
#include "tests/physics/ship/kvlcc2.hpp"
#include "tests/physics/ship/mmg.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace windlass::physics {
namespace {

constexpr double kLength = 320;
const double kSpeed = mps_from_knots(15.5);

double degrees(double angle) {
    return degrees_from_radians(angle);
}

Trial mmg(double resistance) {
    const MmgKvlcc2 ship(resistance, kSpeed);
    return {[ship](double rudder, double dt, TrialMotion& m) { ship.step(rudder, dt, m); }, kSpeed};
}

/// In still, deep water, at the thrust that keeps up her speed. measured: with her own coefficients where
/// they are known of a model, in place of those that the server makes of her particulars.
Trial server_ship(bool measured) {
    ShipDef def = kvlcc2();
    def.propeller_diameter = 9.86, def.rudder_area = 112.5;
    def.lateral_windage = def.frontal_windage = 1e-9;
    HullCoefficients hull = hull_coefficients(def);
    const auto propulsion = [&] {
        PropulsionCoefficients c = propulsion_coefficients(def);
        if (measured) {
            c.straightening = 0.5 * (0.395 + 0.640), c.rudder_in_drift = 0.71;
            c.hull_by_rudder = 0.312, c.rudder_deduction = 0.387;
        }
        return c;
    };
    if (measured) {
        using Measured = Kvlcc2Measured;
        hull.side_drift = Measured::y_v, hull.side_yaw = Measured::y_r, hull.turn_drift = Measured::n_v;
        const double mass = hull.mass / (0.5 * kSeaWaterDensity * kLength * kLength * def.draught);
        hull.turn_yaw = Measured::n_r - mass * Measured::gravity / kLength; // gravity is amidships here
    }
    double low = 1e5, high = 1e7;
    while (high - low > 1) {
        def.thrust_ahead = 0.5 * (low + high);
        const PlanarForce push = propulsion_force(def, propulsion(), kSeaWaterDensity, 1, 0, kSpeed, 0, 0);
        const PlanarForce drag = hull_force(hull, kSeaWaterDensity, kSpeed, 0, 0);
        push.x + drag.x < 0 ? low = def.thrust_ahead : high = def.thrust_ahead;
    }
    EnvironmentDef sea;
    sea.depth = 1e4, sea.wind_speed = sea.current_speed = 0;
    return {[dynamics = ShipDynamics(def, hull, propulsion()), sea](double rudder, double dt,
                                                                    TrialMotion& m) mutable {
                ShipState state;
                state.surge = m.u, state.sway = m.v, state.yaw_rate = m.r, state.engine = 1;
                state.rudder = rudder;
                dynamics.step(sea, {.engine = 1, .rudder = rudder}, {}, {}, dt, state);
                m = {state.surge, state.sway, state.yaw_rate};
            },
            kSpeed};
}

struct Told {
    double advance, diameter, speed; ///< lengths, lengths, share
};
void expect_turn(const Trial::Turn& turn, const Told& told, double share) {
    EXPECT_NEAR(turn.advance / kLength, told.advance, share * told.advance);
    EXPECT_NEAR(turn.diameter / kLength, told.diameter, share * told.diameter);
    EXPECT_NEAR(turn.speed, told.speed, share * told.speed);
}
void expect_zigzag(const std::array<double, 2>& overshoot, double first, double second, double within) {
    EXPECT_NEAR(degrees(overshoot[0]), first, within);
    EXPECT_NEAR(degrees(overshoot[1]), second, within);
}

constexpr double kHelm = 35 * std::numbers::pi / 180, kTen = 10 * std::numbers::pi / 180;

} // namespace

// The method itself, worked twice: by this code and by another (a table of it is in docs/physics.md).
TEST(Kvlcc2, MmgIsTheStandardMethod) {
    expect_turn(mmg(0.022).turn(kHelm), {2.97, 3.00, 0.377}, 0.02);
    expect_turn(mmg(0.022).turn(-kHelm), {3.00, 3.01, 0.380}, 0.02);
    expect_zigzag(mmg(0.022).zigzag(kTen), 4.9, 13.2, 0.5);
    expect_zigzag(mmg(0.022).zigzag(-kTen), 6.9, 8.5, 0.5);
    expect_zigzag(mmg(0.022).zigzag(2 * kTen), 10.5, 15.3, 0.5);
    expect_zigzag(mmg(0.022).zigzag(-2 * kTen), 13.6, 11.5, 0.5);
}

// With the ship's own resistance, to which the model tests' polynomials are turned as well (0.0095; the
// model's 0.022 makes her propeller race much harder on the rudder). The table is in docs/physics.md. Advance
// and diameter within 10 %, first overshoots within 7 degrees. What falls short is said there: in a steady
// turn she keeps 0.15 to 0.19 of her speed in place of 0.29, and second overshoots are up to 12 degrees
// smaller.
TEST(Kvlcc2, ServersHullTurnsAsTheStandardMethods) {
    for (const bool measured : {false, true}) {
        for (const double side : {1.0, -1.0}) {
            const Trial::Turn turn = server_ship(measured).turn(side * kHelm);
            const Trial::Turn told = mmg(0.0095).turn(side * kHelm);
            EXPECT_NEAR(turn.advance, told.advance, 0.10 * told.advance) << measured;
            EXPECT_NEAR(turn.diameter, told.diameter, 0.10 * told.diameter) << measured;
            for (const double angle : {kTen, 2 * kTen}) {
                const auto checked = server_ship(measured).zigzag(side * angle);
                const auto expected = mmg(0.0095).zigzag(side * angle);
                EXPECT_NEAR(degrees(checked[0]), degrees(expected[0]), 7) << measured;
                EXPECT_NEAR(degrees(checked[1]), degrees(expected[1]), 12) << measured;
            }
        }
    }
}

// IMO MSC.137(76): advance 4.5 lengths, diameter 5, overshoots 20 and 40 (10/10) and 25 degrees (20/20) for
// so slow a ship.
TEST(Kvlcc2, ServersHullIsWithinWhatIsAllowed) {
    const Trial::Turn turn = server_ship(false).turn(kHelm);
    EXPECT_LT(turn.advance, 4.5 * kLength);
    EXPECT_LT(turn.diameter, 5 * kLength);
    const auto ten = server_ship(false).zigzag(kTen), twenty = server_ship(false).zigzag(2 * kTen);
    EXPECT_LT(degrees(ten[0]), 20);
    EXPECT_LT(degrees(ten[1]), 40);
    EXPECT_LT(degrees(twenty[0]), 25);
}

// The table of docs/physics.md.
TEST(Kvlcc2, DISABLED_PrintsTheTable) {
    for (const double side : {1.0, -1.0}) {
        for (int k = 0; k < 4; ++k) {
            const auto make = [&] { return k < 2 ? mmg(k == 0 ? 0.022 : 0.0095) : server_ship(k == 3); };
            const Trial::Turn t = make().turn(side * kHelm);
            const auto a = make().zigzag(side * kTen), b = make().zigzag(side * 2 * kTen);
            std::printf("%+g %d: %.2f %.2f %.2f %.2f | %.1f %.1f | %.1f %.1f\n", side, k, t.advance / kLength,
                        t.diameter / kLength, t.speed, t.rate * kLength / (t.speed * kSpeed), degrees(a[0]),
                        degrees(a[1]), degrees(b[0]), degrees(b[1]));
        }
    }
}

} // namespace windlass::physics
