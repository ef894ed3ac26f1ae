#pragma once
// What water and seabed do to one node of the chain.

#include "server/physics/chain.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

/// A node as water and seabed see it, at its present place.
struct NodeMedium {
    Vec3 tangent = Vec3::UnitZ(); ///< unit vector along the chain
    double length = 0;            ///< m of chain that the node stands for
    double submerged = 0;         ///< 0..1
    double mass_normal = 0;       ///< kg, across the chain, added mass included
    double mass_axial = 0;        ///< kg, along the chain, added mass included
    double penetration = 0;       ///< m into the seabed, 0 above it
    double bed_stiffness = 0;     ///< N/m of this node
};

/// Share of a piece of chain of length h (m), centred at height z (m), that is under water: 0..1, continuous.
inline double submerged_share(double z, double h) {
    return std::clamp(0.5 - z / h, 0.0, 1.0);
}

inline NodeMedium node_medium(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                              int i) {
    NodeMedium m;
    const Vec3 across = state.position.at(i + 1) - state.position.at(i - 1);
    const double size = across.norm();
    if (size > 1e-9 * def.node_spacing) m.tangent = across / size;
    m.length = node_length(def, state, i);
    m.submerged = submerged_share(state.position.z[i], m.length);
    const double displaced = m.submerged * environment.water_density * def.displacement * m.length;
    const double mass = def.mass_per_metre * m.length;
    m.mass_normal = mass + def.added_mass_normal * displaced;
    m.mass_axial = mass + def.added_mass_axial * displaced;
    m.penetration = std::max(0.0, -environment.depth - state.position.z[i]);
    m.bed_stiffness = environment.bed_stiffness * def.contact_diameter * m.length;
    return m;
}

/// Weight less buoyancy of node i, N, downwards.
inline double node_weight(const ChainDef& def, const EnvironmentDef& environment, const NodeMedium& m) {
    return (def.mass_per_metre - m.submerged * environment.water_density * def.displacement) * m.length *
           kGravity;
}

/// Potential energy of node i, J: the integral of node_weight() over height, zero at the water surface.
double node_potential(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state, int i);

/// Resistances that depend on speed, as the coefficients of an implicit step, N s/m.
struct NodeDamping {
    double normal = 0;           ///< across the chain, against the water
    double axial = 0;            ///< along the chain, against the water
    double bed_normal = 0;       ///< against the seabed, vertical
    double friction = 0;         ///< against the seabed, horizontal
    Vec3 current = Vec3::Zero(); ///< m/s, of the water
};

/// Speed below which seabed friction is viscous, m/s: chain held by half its friction creeps 0.2 m an hour.
inline constexpr double kFrictionCreep = 1e-4;

/// Morison drag F = -1/2 rho C d h |u| u, with |u| from the velocity before the step and u from the one
/// after: their product is |u| u at the middle, second order, and stable for any step. Friction on the seabed
/// in the same way, Coulomb's force divided by the speed, but at least kFrictionCreep.
inline NodeDamping node_damping(const ChainDef& def, const EnvironmentDef& environment, const NodeMedium& m,
                                const Vec3& velocity, const Vec3& current, double dt) {
    NodeDamping damping;
    if (m.submerged > 0) {
        damping.current = current;
        const Vec3 flow = velocity - current;
        const double along = flow.dot(m.tangent);
        const double across = std::sqrt(std::max(0.0, flow.squaredNorm() - along * along));
        const double area = 0.5 * environment.water_density * def.diameter * m.length * m.submerged;
        damping.normal = area * def.drag_normal * across;
        damping.axial = area * def.drag_axial * std::abs(along);
    }
    // A node about to leave the seabed is let go: mud does not pull.
    if (m.penetration > 0 && velocity.z() * dt < m.penetration) {
        damping.bed_normal =
            2 * std::sqrt(m.bed_stiffness * m.mass_normal); // critical: chain does not bounce
        const double sliding = std::hypot(velocity.x(), velocity.y());
        damping.friction =
            environment.bed_friction * m.bed_stiffness * m.penetration / std::max(sliding, kFrictionCreep);
    }
    return damping;
}

/// Symmetric 3 x 3 matrix.
struct SymmetricMatrix {
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

    Vec3 operator*(const Vec3& v) const {
        return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
                xz * v.x() + yz * v.y() + zz * v.z()};
    }
    /// The inverse; the matrix must be positive definite.
    SymmetricMatrix inverse() const {
        const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
        const double scale = 1 / (xx * a + xy * b + xz * c);
        return {.xx = a * scale,
                .yy = (xx * zz - xz * xz) * scale,
                .zz = (xx * yy - xy * xy) * scale,
                .xy = b * scale,
                .xz = c * scale,
                .yz = (xy * xz - xx * yz) * scale};
    }
};

/// Inverse of the effective mass of a node in a step of dt: mass, added mass, implicit drag and seabed, 1/kg.
inline SymmetricMatrix inverse_effective_mass(const NodeMedium& m, const NodeDamping& damping, double dt) {
    const double normal = m.mass_normal + dt * damping.normal;
    const double axial = m.mass_axial + dt * damping.axial;
    const Vec3& t = m.tangent;
    if (damping.bed_normal == 0) {
        const double even = 1 / normal, more = 1 / axial - even;
        return {.xx = even + more * t.x() * t.x(),
                .yy = even + more * t.y() * t.y(),
                .zz = even + more * t.z() * t.z(),
                .xy = more * t.x() * t.y(),
                .xz = more * t.x() * t.z(),
                .yz = more * t.y() * t.z()};
    }
    const double more = axial - normal;
    const double level = normal + dt * damping.friction;
    const double upright = normal + dt * damping.bed_normal + dt * dt * m.bed_stiffness;
    return SymmetricMatrix{.xx = level + more * t.x() * t.x(),
                           .yy = level + more * t.y() * t.y(),
                           .zz = upright + more * t.z() * t.z(),
                           .xy = more * t.x() * t.y(),
                           .xz = more * t.x() * t.z(),
                           .yz = more * t.y() * t.z()}
        .inverse();
}

} // namespace windlass::physics
