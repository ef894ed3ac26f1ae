// Wind on ships of every kind.

#include "server/physics/base/units.hpp"
#include "server/physics/ship/wind.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace windlass::physics {
namespace {

constexpr double kWind = 20; // m/s

struct Coefficients {
    double ahead, across, turn;
};
Coefficients at(const ShipDef& ship, double degrees) {
    const PlanarForce f = wind_force(ship, kWind, radians_from_degrees(degrees));
    const double pressure = 0.5 * kAirDensity * kWind * kWind;
    return {f.x / (pressure * ship.frontal_windage), -f.y / (pressure * ship.lateral_windage),
            -f.moment / (pressure * ship.lateral_windage * ship.length_overall)};
}

ShipDef car_carrier() {
    ShipDef ship;
    ship.length_overall = 200, ship.beam = 32.26;
    ship.lateral_windage = 5100, ship.frontal_windage = 880, ship.windage_lever = 1.5;
    ship.wind_across = 0.95, ship.wind_ahead = 0.55, ship.wind_astern = 0.60, ship.wind_crossing = 0.80;
    return ship;
}

ShipDef vlcc() {
    ShipDef ship;
    ship.length_overall = 333, ship.beam = 58;
    ship.lateral_windage = 3700, ship.frontal_windage = 1230, ship.windage_lever = -20;
    return ship;
}

TEST(Wind, HasNoForceInACalm) {
    const PlanarForce force = wind_force(ShipDef{}, 0, 1);
    EXPECT_EQ(std::abs(force.x) + std::abs(force.y) + std::abs(force.moment), 0);
}

TEST(Wind, PushesTheWayItBlows) {
    for (const ShipDef& ship : {ShipDef{}, car_carrier(), vlcc()}) {
        for (double degrees = -180; degrees <= 180; degrees += 5) {
            const PlanarForce force = wind_force(ship, kWind, radians_from_degrees(degrees));
            EXPECT_LE(force.x * std::cos(radians_from_degrees(degrees)), 1) << degrees;
            EXPECT_LE(force.y * std::sin(radians_from_degrees(degrees)), 1) << degrees;
            const PlanarForce other = wind_force(ship, kWind, radians_from_degrees(-degrees));
            if (degrees != -180 && degrees != 180 && degrees != 0) {
                EXPECT_EQ(other.y, -force.y);
                EXPECT_EQ(other.moment, -force.moment);
            }
        }
    }
}

TEST(Wind, NeverDrivesACarCarrierAheadFromTheBow) {
    EXPECT_LT(at(car_carrier(), 60).ahead, -0.2);
    EXPECT_GT(at(car_carrier(), 60).ahead, -0.6);
}

// The other law of the trade, R. M. Isherwood's regression (1972), on a laden Panamax (S/L 1.2, one group of
// masts, superstructure 0.2 of the side): where both hold they agree to a fifth ahead and abeam. Its moments
// are small against the arm of the windage's centre, 0.1.
TEST(Wind, AgreesWithIsherwoodWhereBothHold) {
    const Coefficients ahead = at(ShipDef{}, 0), abeam = at(ShipDef{}, 90), bow = at(ShipDef{}, 60);
    EXPECT_NEAR(ahead.ahead, -0.78, 0.2 * 0.78);
    EXPECT_NEAR(abeam.across, 0.67, 0.2 * 0.67);
    EXPECT_NEAR(bow.turn, 0.001, 0.02);
    EXPECT_NEAR(at(vlcc(), 0).ahead, -1.03, 0.2 * 1.03);
    EXPECT_NEAR(at(vlcc(), 90).across, 0.57, 0.25 * 0.57);
}

TEST(Wind, TurnsHerBeamOnFromBothSidesOfIt) {
    ShipDef ship; // windage amidships
    ship.windage_lever = 0;
    EXPECT_LT(wind_force(ship, kWind, radians_from_degrees(45)).moment, 0);  // bow falls off to port
    EXPECT_GT(wind_force(ship, kWind, radians_from_degrees(135)).moment, 0); // stern does
}

} // namespace
} // namespace windlass::physics
