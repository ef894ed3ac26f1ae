#pragma once
// An anchor as data.

#include "server/physics/base/units.hpp"

namespace windlass::physics {

/// Kinds of anchor. Hall and Spek: ordinary stockless, the Spek's flukes balanced about their pin. AC-14: the
/// usual one of high holding power. HHP and SHHP: any of high and of super high holding power, by class rules
/// (IACS UR A1) of at least twice and four times an ordinary one's. Stock: admiralty pattern, fixed arms.
enum class AnchorType { hall, spek, ac14, hhp, shhp, stock };

// Of every anchor.
inline constexpr double kAnchorAddedMass = 1.0;   ///< -, of the displaced mass; tuned
inline constexpr double kAnchorBedFriction = 0.3; ///< -, steel sliding on the bed without digging in; tuned
inline constexpr double kAnchorSuction = 2.0; ///< pull beyond its weight that breaks it out of mud, over its
                                              ///< weight in air: 1 to 3 (practice)

/// One anchor. Defaults: 9 900 kg stockless (UR A1 row EN 3210-3400). Plain values; other types and masses by
/// typical_anchor(), which a file may change in its main dimensions.
struct AnchorDef {
    AnchorType type = AnchorType::hall;
    double mass = 9900;        ///< kg
    double shank_length = 2.9; ///< m, crown pin to anchor shackle; tuned to the mass: common Hall drawings
    double fluke_length = 1.9; ///< m, crown pin to tips
    double crown_width = 2.1;  ///< m, across the flukes
    double fluke_angle = radians_from_degrees(45); ///< rad, that the flukes turn to either side
    double drag_area = 2.4;    ///< m2, drag coefficient times area, crown first: falls at about 8 m/s alone
    double setting_drag = 8.0; ///< fluke lengths dragged in sand until dug in: 5-10; other soils: holding.cpp
    // Holding power / weight in air by soil; sources in anchor_def.cpp, spread by 2.
    double holding_mud = 3.0;
    double holding_sand = 3.5;
    double holding_clay = 3.5;
    double holding_gravel = 2.5;
    double holding_rock = 1.0;     ///< unreliable
    double holding_coral = 1.0;    ///< unreliable
    double holding_mixed = 3.25;   ///< mud with sand
    double holding_dragging = 1.5; ///< what is left of it while it drags
    double proof_load = 1000.0e3;  ///< N, along the shank, at the flukes
};

/// What an anchor of the type weighs of an ordinary one for the same ship: UR A1 allows HHP 75 %, SHHP 50 %.
double mass_factor(AnchorType type);

/// An anchor of the type and mass (kg; 0: the one in place of an ordinary one of 9 900 kg). Lengths go with
/// the cube root of the mass.
AnchorDef typical_anchor(AnchorType type, double mass = 0);

} // namespace windlass::physics
