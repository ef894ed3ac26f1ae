#pragma once
// What the water does to a hull, from full ahead to beam-on and astern, in deep water and in shallow.

#include "server/physics/ship/planar_force.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// A hull's coefficients in deep water, midships being the origin. Forces are over 1/2 rho L T, with speed
/// through water squared; moments over L more, rates of turn times L. Linear terms are drift's and yaw's.
struct HullCoefficients {
    double length = 0, beam = 0, draught = 0; ///< m: L between perpendiculars, T amidships
    double trim = 0;                          ///< by the stern, of the draught
    double block = 0;                         ///< of displacement
    double friction_area = 0;                 ///< m2, wetted
    double side_drift = 0, side_yaw = 0;      ///< Y_v, Y_r
    double turn_drift = 0, turn_yaw = 0;      ///< N_v, N_r
    double cross_flow = 0;                    ///< drag coefficient beam-on
    double mass = 0, inertia = 0;             ///< kg, kg m2
    double added_surge = 0, added_sway = 0;   ///< kg
    double added_yaw = 0;                     ///< kg m2
};

/// Of a ship's particulars. Linear terms: K. Kijima and others (1990), On the manoeuvring performance of a
/// ship with the parameter of loading condition, J. Soc. Naval Arch. Japan 168, with the centre of gravity
/// amidships. Added masses: Zhou Zhaoming and others (1983), a regression of S. Motora's charts; KVLCC2's
/// come out within 5 %. Cross-flow drag: UFC 4-159-03 (2005), eq. 11. Trim, in the linear terms: S. Inoue, M.
/// Hirano, K. Kijima (1981), Hydrodynamic derivatives on ship manoeuvring, Int. Shipbuilding Progress 28 (as
/// recalled); Kijima's own (1990) are within a fifth of them at these ships' trims.
HullCoefficients hull_coefficients(const ShipDef& def);

/// The same where the water is so many metres deep.
///
/// Cross-flow drag: UFC 4-159-03, eq. 12, for streams up to 1.5 m/s. Added masses: as of the tanker of 190
/// 000 t of W. B. van Berlekom and T. A. Goddard (1972). Linear terms: Kijima (1990). Nothing is known
/// below 1.1 draughts: there it stays.
HullCoefficients in_depth(const HullCoefficients& deep, double depth);

/// Of a hull that goes ahead at u, to starboard at v (m/s through the water), and turns at r (rad/s,
/// clockwise). Form: Y. Yoshimura and others (2009), of low speeds: drag across a hull that drifts and turns,
/// beside lift that goes with speed ahead. At rest there is none; beam-on drag alone; drift and turn never
/// give energy (the ideal moment of a body in a stream, Munk's, is in N_v, where it was measured).
PlanarForce hull_force(const HullCoefficients& hull, double density, double u, double v, double r);

/// N over speed (m/s) through the water, straight ahead, without the propeller.
double resistance_over_speed(const HullCoefficients& hull, double density, double speed);

} // namespace windlass::physics
