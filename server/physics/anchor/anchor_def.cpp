#include "server/physics/anchor/anchor_def.hpp"

#include <array>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kOrdinaryMass = 9900; ///< kg, that the lengths below belong to

/// A type at 9 900 kg.
struct Pattern {
    double mass_factor;
    double shank, fluke, crown; ///< m
    double fluke_angle;         ///< degrees
    double drag_area;           ///< m2
    double setting_drag;        ///< fluke lengths, in sand
    double mud, sand, clay, gravel, rock, coral, mixed, dragging;
    double test_mass; ///< its proof load is that of an ordinary anchor of so many times its mass
};

// Lengths: proportions of common drawings, tuned. Fluke angles: about 45 degrees of Hall and Spek, 35 of
//   AC-14; of the others so, too, tuned. Setting drag: 5 to 10 fluke lengths in sand (practice).
// Drag, crown first: 1 on the area that the boxes of anchor_shape.cpp show with the flukes open, crown and
//   what of the flukes stands out beside it. Blunt boxes and plates have 1.05 to 1.2, rounded ones less
//   (Hoerner 1965, from memory); no measured fall of a ship's anchor was found.
// Holding, Hall and Spek: mud 3 (realtrawlers; 3.2 Japan P&I Bulletin 25; 2.4 at 4.5 t UFC 4-159-03), sand
//   3.5 and 1.5 dragging (Japan P&I; 7 realtrawlers, 4.4 UFC), clay 3 to 5, gravel 2 to 3, rock 0 to 2
//   (practice), coral as rock, mixed between mud and sand.
// AC-14: mud 10, sand 8, 2 dragging (Japan P&I; realtrawlers has 5 for mud); clay and gravel twice Hall's.
// HHP, SHHP: twice and four times Hall's, where flukes dig in (UR A1: at least).
// Stock: fixed flukes hold better than movable ones that have not opened (UFC: 4.6 in mud, 7 in sand at 4.5
//   t for a stockless anchor with its flukes fixed open), but only one arm is in: half between, tuned.
// Proof loads: HHP are tested as ordinary anchors of 4/3, SHHP of twice their mass (UR A1).
constexpr std::array<Pattern, 6> kPatterns{{
    {1, 2.9, 1.9, 2.1, 45, 2.4, 8, 3.0, 3.5, 3.5, 2.5, 1, 1, 3.25, 1.5, 1},         // Hall
    {1, 2.9, 1.9, 2.1, 45, 2.4, 8, 3.0, 3.5, 3.5, 2.5, 1, 1, 3.25, 1.5, 1},         // Spek
    {0.75, 3.1, 2.2, 2.9, 35, 3.6, 6, 10, 8.0, 7.0, 5.0, 1, 1, 9.0, 2.0, 4.0 / 3},  // AC-14
    {0.75, 3.1, 2.2, 2.6, 35, 3.1, 6, 6.0, 7.0, 7.0, 5.0, 1, 1, 6.5, 2.0, 4.0 / 3}, // HHP
    {0.5, 3.4, 2.6, 3.0, 35, 4.2, 6, 12, 14, 14, 10, 1, 1, 13, 3.0, 2},             // SHHP
    {1, 3.6, 1.6, 1.2, 0, 1.5, 5, 3.5, 4.5, 4.5, 3.0, 1, 1, 4.0, 2.0, 1},           // stock
}};

const Pattern& pattern(AnchorType type) {
    return kPatterns.at(static_cast<std::size_t>(type));
}

/// Proof load of an ordinary anchor, N: 1.0 MN at 9 900 kg, growing with the 2/3 power of the mass (IACS UR
/// W29, from memory).
double proof_load(double mass) {
    return 1000.0e3 * std::pow(mass / kOrdinaryMass, 2.0 / 3);
}

} // namespace

double mass_factor(AnchorType type) {
    return pattern(type).mass_factor;
}

AnchorDef typical_anchor(AnchorType type, double mass) {
    const Pattern& p = pattern(type);
    AnchorDef def;
    def.type = type;
    def.mass = mass > 0 ? mass : p.mass_factor * kOrdinaryMass;
    const double scale = std::cbrt(def.mass / kOrdinaryMass);
    def.shank_length = scale * p.shank;
    def.fluke_length = scale * p.fluke;
    def.crown_width = scale * p.crown;
    def.fluke_angle = radians_from_degrees(p.fluke_angle);
    def.drag_area = scale * scale * p.drag_area;
    def.setting_drag = p.setting_drag;
    def.holding_mud = p.mud;
    def.holding_sand = p.sand;
    def.holding_clay = p.clay;
    def.holding_gravel = p.gravel;
    def.holding_rock = p.rock;
    def.holding_coral = p.coral;
    def.holding_mixed = p.mixed;
    def.holding_dragging = p.dragging;
    def.proof_load = proof_load(p.test_mass * def.mass);
    return def;
}

} // namespace windlass::physics
