#pragma once
// Propeller, rudder and thrusters: what they do to a ship that makes way, ahead and astern.

#include "server/physics/ship/planar_force.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// What propeller and rudder go by, made once of a ship's particulars.
struct PropulsionCoefficients {
    double wake = 0;              ///< share of her speed by which the water at the propeller follows her
    double deduction = 0;         ///< share of the propeller's thrust that it takes from the hull by suction
    double revolutions = 0;       ///< 1/s, of full ahead, ship at rest
    double locked_area = 0;       ///< m2, of a propeller that stands, its drag over dynamic pressure
    double straightening = 0.40;  ///< of the flow at the rudder by hull and propeller
    double rudder_in_drift = 0.5; ///< lengths aft of midships, of the place whose drift the rudder feels
    double hull_by_rudder = 0.39; ///< side force on the hull over that on the rudder
    double rudder_deduction = 0.19; ///< share of the rudder's drag that the hull does not feel
    double rudder_wake = 1.09;      ///< water's speed at the rudder over that at the propeller
};

/// Wake: D. W. Taylor's of single screws by the block coefficient; deduction 0.6 of it. Of the locked
/// propeller: UFC 4-159-03 (2005), eq. 20, 21. Revolutions: those at which KVLCC2's propeller makes the ship
/// file's thrust. Rudder: of the Esso Osaka (propulsion.cpp).
PropulsionCoefficients propulsion_coefficients(const ShipDef& def);

/// N, forward.
struct PropellerThrust {
    double drives = 0; ///< of the engine, on the propeller; the hull loses the deduction of it
    double brakes = 0; ///< of the water, on one that it would turn faster
};

/// Of a ship that goes ahead through the water at u (m/s), engine as in ShipState.
PropellerThrust propeller_thrust(const ShipDef& def, const PropulsionCoefficients& c, double density,
                                 double engine, double u);

/// Propeller and rudder together: u, v m/s ahead and to starboard through the water, r rad/s clockwise,
/// rudder rad, starboard positive.
PlanarForce propulsion_force(const ShipDef& def, const PropulsionCoefficients& c, double density,
                             double engine, double rudder, double u, double v, double r);

/// Share of its thrust at rest that a tunnel thruster turns a ship by at a speed through the water (m/s,
/// either way).
double thruster_share(double speed);

} // namespace windlass::physics
