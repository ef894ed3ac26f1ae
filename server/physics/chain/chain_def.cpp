#include "server/physics/chain/chain_def.hpp"

#include <numbers>

namespace windlass::physics {

namespace {

/// Strength of stud-link chain: coefficient x d^2 (44 - 0.08 d) kN, d in mm (IACS UR W18), here in N.
double strength(double coefficient, double diameter) {
    const double d_mm = diameter * 1e3;
    return coefficient * d_mm * d_mm * (44 - 0.08 * d_mm) * 1e3;
}

} // namespace

ChainDef stud_link_chain(double diameter, Grade grade, double length) {
    ChainDef def;
    def.diameter = diameter;
    def.grade = grade;
    def.length = length;
    def.mass_per_metre = 21.9e3 * diameter * diameter;
    def.stiffness = 1.01e11 * diameter * diameter;
    const double equivalent_diameter = 1.89 * diameter;
    def.displacement = std::numbers::pi / 4 * equivalent_diameter * equivalent_diameter;
    def.contact_diameter = 3.6 * diameter;
    def.bend_radius = 2 * diameter;
    return def;
}

double breaking_load(const ChainDef& def) {
    switch (def.grade) {
    case Grade::k1:
        return strength(0.00981, def.diameter);
    case Grade::k2:
        return strength(0.01373, def.diameter);
    case Grade::k3:
        return strength(0.01961, def.diameter);
    }
    return 0;
}

double proof_load(const ChainDef& def) {
    switch (def.grade) {
    case Grade::k1:
        return strength(0.00686, def.diameter);
    case Grade::k2:
        return strength(0.00981, def.diameter);
    case Grade::k3:
        return strength(0.01373, def.diameter);
    }
    return 0;
}

double weight_in_air(const ChainDef& def) {
    return def.mass_per_metre * kGravity;
}

double weight_in_water(const ChainDef& def, double water_density) {
    return (def.mass_per_metre - water_density * def.displacement) * kGravity;
}

} // namespace windlass::physics
