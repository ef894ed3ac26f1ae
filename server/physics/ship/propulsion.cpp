#include "server/physics/ship/propulsion.hpp"

#include "server/physics/base/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

/// Thrust coefficient by advance, K_T = k0 + k1 J + k2 J^2, of KVLCC2 (Yasukawa and Yoshimura 2015).
constexpr double kThrust0 = 0.2931, kThrust1 = -0.2753, kThrust2 = -0.1385;
/// Of it: advance at which it is none, over the revolutions' share.
constexpr double kIdle = 0.768;

// Going astern, of the Esso Osaka (H. Hachii, as in Y. Miyauchi and others 2022, doi
// 10.1007/s00773-022-00889-3), by J = u / nD: thrust over that at rest and the same revolutions, and side
// force at the stern over the same.
constexpr double kAsternByAdvance = 1.886, kMostAstern = 1.434;
double side_share_astern(double advance) {
    if (advance > -0.06) return 1;
    if (advance > -0.35) return 0.14 - 14.3 * advance;
    return std::max(0.0, 8.75 + 10.3 * advance);
}
constexpr double kSideLever = 0.40; ///< lengths aft of midships

// Rudder: Yasukawa and Yoshimura (2015), the race in Yoshimura's form, which is finite at rest.
constexpr double kRace = 0.50;      ///< of the propeller's race that the rudder feels
constexpr double kLift = 2.75;      ///< of the normal force, by the sine of the angle to the flow
constexpr double kStalled = 1.6;    ///< coefficient of the normal force that is never exceeded: 35 deg
constexpr double kAspect = 2.2;     ///< height over mean chord
constexpr double kHullLever = 0.45; ///< lengths aft, of the side force on the hull by the rudder

double square_signed(double x) {
    return x * std::abs(x);
}

} // namespace

PropulsionCoefficients propulsion_coefficients(const ShipDef& def) {
    PropulsionCoefficients c;
    const double block = def.displacement / (kSeaWaterDensity * def.length_pp * def.beam * def.draught);
    c.wake = std::clamp(0.5 * block - 0.05, 0.1, 0.4);
    c.deduction = 0.6 * c.wake;
    const double disc = def.propeller_diameter * def.propeller_diameter;
    c.revolutions =
        std::sqrt(def.thrust_ahead / ((1 - c.deduction) * kThrust0 * kSeaWaterDensity * disc * disc));
    c.locked_area = def.length_pp * def.beam / (0.838 * 240);
    return c;
}

PropellerThrust propeller_thrust(const ShipDef& def, const PropulsionCoefficients& c, double density,
                                 double engine, double u) {
    const double turns = std::sqrt(std::abs(engine));          // over those of full ahead
    const double tip = c.revolutions * def.propeller_diameter; // m/s
    const double advance = tip > 0 ? u / tip : 0, inflow = (1 - c.wake) * advance;
    PropellerThrust thrust;
    if (engine > 0) {
        const double j = std::clamp(inflow / turns, -1.0, kIdle);
        thrust.drives = def.thrust_ahead / (1 - c.deduction) * engine *
                        (1 + kThrust1 / kThrust0 * j + kThrust2 / kThrust0 * j * j);
    } else if (engine < 0) {
        thrust.drives = def.thrust_astern / (1 - c.deduction) * engine *
                        std::clamp(1 + kAsternByAdvance * advance / turns, 0.0, kMostAstern);
    }
    // One that turns more slowly than the water would turn it brakes, at most as one that stands.
    const double idle = std::abs(inflow) / kIdle;
    if (idle > turns) {
        const double share = 1 - turns / idle;
        thrust.brakes = -0.5 * density * c.locked_area * u * std::abs(u) * share * share;
    }
    return thrust;
}

PlanarForce propulsion_force(const ShipDef& def, const PropulsionCoefficients& c, double density,
                             double engine, double rudder, double u, double v, double r) {
    const double length = def.length_pp;
    const PropellerThrust propeller = propeller_thrust(def, c, density, engine, u);
    const double thrust = propeller.drives + propeller.brakes;
    PlanarForce force;
    force.x = (1 - c.deduction) * propeller.drives + propeller.brakes;

    if (engine < 0) { // its race strikes the quarter: stern to port with a right-handed screw
        const double tip = c.revolutions * def.propeller_diameter * std::sqrt(-engine);
        const double side = def.paddle_wheel * def.thrust_astern * -engine * side_share_astern(-u / tip);
        force.y -= side;
        force.moment += side * kSideLever * length;
    }

    const double disc = def.propeller_diameter * def.propeller_diameter;
    const double follows = (1 - c.wake) * u; // at the propeller
    const double jet = 8 * std::abs(thrust) / (std::numbers::pi * std::max(density, 1.0) * disc);
    double race = follows;
    if (thrust > 0)
        race += kRace * (std::sqrt(follows * follows + jet) - std::abs(follows));
    else if (follows > 0) // what brakes before the rudder shadows it
        race = std::max(0.0, follows - kRace * std::sqrt(jet));
    const double in_race = std::min(1.0, def.propeller_diameter / std::sqrt(kAspect * def.rudder_area));
    const double pressure = in_race * square_signed(race) + (1 - in_race) * square_signed(follows);
    const double along = c.rudder_wake * std::copysign(std::sqrt(std::abs(pressure)), pressure);
    const double across = c.straightening * (c.rudder_in_drift * length * r - v); // from starboard
    const double flow = std::hypot(along, across);
    if (!(flow > 0)) return force;
    const double sine = (along * std::sin(rudder) - across * std::cos(rudder)) / flow;
    const double normal =
        0.5 * density * def.rudder_area * flow * flow * std::clamp(kLift * sine, -kStalled, kStalled);
    force.x -= (1 - c.rudder_deduction) * normal * std::sin(rudder);
    force.y -= (1 + c.hull_by_rudder) * normal * std::cos(rudder);
    force.moment += (0.5 + kHullLever * c.hull_by_rudder) * length * normal * std::cos(rudder);
    return force;
}

double thruster_share(double speed) {
    struct Place {
        double knots, share;
    };
    // Through a 60 000 t tanker's half at 4 kn and all at 15 (KMW/HyA 1967, doi 10.3233/ISP-1967-1415601),
    // worst at 4 to 6 kn (Wartsila, encyclopedia): the hull's pressure beside the jet.
    static constexpr std::array<Place, 6> kPlaces{
        {{0, 1}, {1, 0.85}, {2, 0.65}, {4, 0.5}, {6, 0.5}, {15, 1}}};
    const double knots = knots_from_mps(std::abs(speed));
    for (std::size_t k = 1; k < kPlaces.size(); ++k) {
        const Place &a = kPlaces[k - 1], &b = kPlaces[k];
        if (knots < b.knots) return a.share + (b.share - a.share) * (knots - a.knots) / (b.knots - a.knots);
    }
    return kPlaces.back().share;
}

} // namespace windlass::physics
