#pragma once
// A ship as data: surge, sway and yaw, and what waves make of heave, pitch and roll.

#include <numbers>

namespace windlass::physics {

/// One ship. Defaults: a laden bulk carrier of 225 m whose equipment number fits the 9 900 kg anchor.
/// Masses and areas are the designer's figures for such a ship; what follows from them is computed where the
/// model needs it, and carries its source there.
struct ShipDef {
    double length_overall = 225;     ///< m
    double length_pp = 217;          ///< m, between perpendiculars; midships is in its middle
    double beam = 32.2;              ///< m
    double draught = 12.5;           ///< m, amidships
    double trim = 0;                 ///< m, by the stern: draught there less that at the bow
    double displacement = 7.7e7;     ///< kg
    double gyration_radius = 0.25;   ///< of the length between perpendiculars, yaw
    double lateral_windage = 2600;   ///< m2, above water
    double frontal_windage = 620;    ///< m2
    double windage_lever = -20;      ///< m, centre of the lateral windage forward of midships
    double wind_across = 0.70;       ///< coefficient of the wind from abeam, on the lateral windage
    double wind_ahead = 0.90;        ///< of that from ahead, on the frontal windage
    double wind_astern = 0.55;       ///< of that from astern
    double wind_crossing = 0.40;     ///< by how much wind from the quarters counts less: Blendermann's delta
    double thrust_ahead = 9.0e5;     ///< N, bollard, full ahead
    double thrust_astern = 5.5e5;    ///< N, bollard, full astern
    double propeller_diameter = 6.6; ///< m
    double paddle_wheel = 0.14;      ///< side force going astern over that thrust, stern to port positive
    double engine_time = 8;          ///< s, to follow the telegraph
    double engine_start_time = 0;    ///< s, to come up from standing; 0: it need not stand to reverse
    double rudder_area = 45;         ///< m2
    double rudder_max = 35 * std::numbers::pi / 180;   ///< rad
    double rudder_rate = 2.5 * std::numbers::pi / 180; ///< rad/s
    double bow_thruster = 0;                           ///< N, ship at rest; 0 where there is none
    double stern_thruster = 0;                         ///< N
    double metacentric_height = 3;                     ///< m, with free surfaces
    double roll_damping = 0.08;                        ///< of critical, linear, with bilge keels
    double hawse_forward = 104;                        ///< m, hawse pipe lip forward of midships
    double hawse_outboard = 7;                         ///< m from the centre line
    double hawse_height = 6;                           ///< m, lip above the waterline

    /// m, so many metres forward of midships.
    double draught_at(double forward) const { return draught - trim * forward / length_pp; }
};

} // namespace windlass::physics
