#pragma once
// An anchor chain as data: what is bought, and how finely it is modelled.

#include "server/physics/base/units.hpp"

#include <numbers>

namespace windlass::physics {

/// Stud-link grade of IACS UR W18: ordinary, high and extra high strength.
enum class Grade { k1, k2, k3 };

inline constexpr double kLinksInDiameters = 4; ///< pitch of a common link, in bar diameters (ISO 1704)

/// One cable. A file gives diameter, grade and length; stud_link_chain() makes the rest of them, and other
/// chain (of a test tank, say) is made field by field. Defaults: 78 mm K3, 12 shackles (UR A1 row EN
/// 3210-3400). Plain values. Sources: Orcina, OrcaFlex help "Chain" (mass, EA, added mass, drag), IACS UR W18
/// (strength).
struct ChainDef {
    double diameter = 0.078; ///< m, bar diameter d
    Grade grade = Grade::k3;
    double length = 330;                            ///< m on board, 12 shackles, bitter end to anchor shackle
    double mass_per_metre = 21.9e3 * 0.078 * 0.078; ///< kg/m in air; stud link 21.9 d^2 t/m
    double stiffness = 1.01e11 * 0.078 * 0.078;     ///< N, axial stiffness EA; stud link 1.01e8 d^2 kN
    double displacement = 0.25 * std::numbers::pi * (1.89 * 0.078) *
                          (1.89 * 0.078); ///< m3/m, volume-equivalent diameter 1.89 d
    double damping_time = 2.0e-3;   ///< s, structural damping over stiffness (BA/EA); tuned: ringing of a 1 m
                                    ///< link dies in a few cycles, 0.1 % of a swing's energy is lost
    double drag_normal = 2.6;       ///< -, on d, across the chain
    double drag_axial = 0.34;       ///< -, on d, along; tuned: let go in 20, 40, 100 m, free pay-out settles
                                    ///< at 6.5, 7.6, 8.4 m/s (docs/physics.md). Offshore values (1.4) are for
                                    ///< oscillating lines, not for chain running lengthwise
    double added_mass_normal = 1.0; ///< -, of the displaced mass
    double added_mass_axial = 0.5;  ///< -, of the displaced mass
    double contact_diameter = 3.6 * 0.078; ///< m, width of a link (ISO 1704)
    double bend_radius = 2.0 * 0.078;      ///< m, sharpest fold: from one link to the next (pitch 4 d) chain
                                           ///< turns at most a quarter, so folded double its parts lie one
                                           ///< pitch apart; geometry of ISO 1704 links, not measured
    double node_spacing = 1.0;             ///< m of unstretched chain between nodes
};

/// Chain of the given bar diameter (m) with every property that follows from it.
ChainDef stud_link_chain(double diameter, Grade grade, double length);

/// Breaking load of the certificate, N (IACS UR W18: 0.01961 d^2 (44 - 0.08 d) kN for grade 3, d in mm).
double breaking_load(const ChainDef& def);

/// Proof load, N (IACS UR W18: 0.01373 d^2 (44 - 0.08 d) kN for grade 3, d in mm).
double proof_load(const ChainDef& def);

/// Weight in air and in the given water, N/m.
double weight_in_air(const ChainDef& def);
double weight_in_water(const ChainDef& def, double water_density);

/// Shortest cable that is modelled outboard of the hawse pipe, m. What is hove in beyond draws the cable's
/// upper end up the pipe; without a pipe it is the least that can be out.
inline double home_length(const ChainDef& def) {
    return 0.5 * def.node_spacing;
}

} // namespace windlass::physics
