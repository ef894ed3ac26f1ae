#pragma once
// How a ship floats: by how much, upright and on her draught no longer, she is sunk by her own speed (squat)
// and lifted, heeled and trimmed by ground that she rests on.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// Away from floating upright on her draught, beside what waves do; all 0 of a ship that lies still, afloat.
struct Flotation {
    double heave = 0;                    ///< m, up
    double heel = 0, trim = 0;           ///< rad, starboard down, bow up
    double heave_speed = 0;              ///< m/s
    double heel_rate = 0, trim_rate = 0; ///< rad/s
};
template <class Visitor, StateOf<Flotation> State>
void visit_state(Visitor& v, State& flotation);

/// What the ground that she touches does to her in the vertical, about midships and the centre line.
struct GroundLift {
    double bearing = 0;  ///< N, of her weight that it bears
    double heeling = 0;  ///< N m, starboard down
    double trimming = 0; ///< N m, bow up
};

/// A hull's hydrostatics, from her main dimensions and block coefficient C_B: waterplane coefficient
/// (1 + 2 C_B) / 3 (Schneekluth), its inertias across and along (0.1216 C_W - 0.0410) L B^3 and
/// (0.350 C_W^2 - 0.405 C_W + 0.146) L^3 B (D'Arcangelo 1969, in Parsons's parametric design), centre of
/// buoyancy T (5/6 - C_B / 3 C_W) above the keel (Morrish).
struct Hydrostatics {
    explicit Hydrostatics(const ShipDef& def);

    double block;              ///< -
    double waterplane;         ///< m2
    double metacentre;         ///< m above the keel, KM
    double metacentric_radius; ///< m, BM across
    double trim_stiffness;     ///< N m/rad
};

/// m, by which a ship sinks that makes speed (m/s) ahead or astern through open water of a depth (m), most
/// at one end: C. B. Barrass (2004), C_B S^0.81 V^2.08 / 20 with V in kn and the blockage S of a width of
/// 7.04 / C_B^0.85 beams. None to 1 m/s, where it is 3 cm at most, and the whole from 1.5 on: what lies at
/// anchor, or dredges one, is not moved by it.
double squat(const ShipDef& def, double depth, double speed);

/// Heave, heel and trim about what buoyancy asks, for dt (s). Upright, the ground's bearing R takes R KM from
/// the righting moment W GM (virtual loss of metacentric height: D. R. Derrett, Ship Stability, drydocking
/// and grounding), R from off the centre line heels; righting beyond small angles by the wall-sided formula,
/// and never farther than kMostHeel, where nothing of this holds. The water's inertia is as large as her own,
/// its damping half of critical, in heel the ship's own (all tuned: they say how soon, not how far).
void step_flotation(const ShipDef& def, const Hydrostatics& hull, double squat, const GroundLift& ground,
                    double dt, Flotation& flotation);

inline constexpr double kMostHeel = 0.6; ///< rad

} // namespace windlass::physics
