#pragma once
// A ship as data: surge, sway and yaw, and what waves make of heave, pitch and roll.

#include <numbers>

namespace windlass::physics {

/// One ship. Defaults: a laden bulk carrier of 225 m whose equipment number fits the 9 900 kg anchor.
/// Masses and areas are the designer's figures for such a ship; coefficients carry their source in ship.cpp.
struct ShipDef {
    double length_overall = 225;                     ///< m
    double beam = 32.2;                              ///< m
    double draught = 12.5;                           ///< m
    double displacement = 7.7e7;                     ///< kg
    double added_mass_surge = 0.05;                  ///< of the displacement
    double added_mass_sway = 0.80;                   ///< of the displacement, shallow water
    double gyration_radius = 0.25;                   ///< of the length, yaw
    double added_inertia_yaw = 0.60;                 ///< of the yaw inertia
    double cross_flow_drag = 0.8;                    ///< strips, 0.6-1.0 below 1-2 kn (domain practice)
    double surge_drag = 0.0035;                      ///< on wetted surface, friction and form at low speed
    double lateral_windage = 2600;                   ///< m2, above water
    double frontal_windage = 620;                    ///< m2
    double windage_lever = -20;                      ///< m, centre of the lateral windage forward of midships
    double thrust_ahead = 9.0e5;                     ///< N, bollard, full ahead
    double thrust_astern = 5.5e5;                    ///< N, bollard, full astern
    double engine_time = 8;                          ///< s, to follow the telegraph
    double rudder_max = 35 * std::numbers::pi / 180; ///< rad
    double rudder_rate = 2.5 * std::numbers::pi / 180; ///< rad/s
    double rudder_force = 0.45;                        ///< side force per thrust ahead and rad of rudder
    double thruster = 1.5e5;       ///< N, bow and stern thruster each; 0 where there is none
    double metacentric_height = 3; ///< m, with free surfaces
    double roll_damping = 0.08;    ///< of critical, linear, with bilge keels
    double hawse_forward = 104;    ///< m, hawse pipe lip forward of midships
    double hawse_outboard = 7;     ///< m from the centre line
    double hawse_height = 6;       ///< m, lip above the waterline
};

} // namespace windlass::physics
