#include "server/physics/chain_forces.hpp"

namespace windlass::physics {

double node_potential(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                      int i) {
    const double h = node_length(def, state, i);
    const double z = state.position.z[i];
    // Integral of submerged_share() from z upwards.
    double submerged_height = 0;
    if (z < -0.5 * h) {
        submerged_height = -z;
    } else if (z < 0.5 * h) {
        submerged_height = (0.5 * h - z) * (0.5 * h - z) / (2 * h);
    }
    return kGravity * h *
           (def.mass_per_metre * z + environment.water_density * def.displacement * submerged_height);
}

NodeDamping node_damping(const ChainDef& def, const EnvironmentDef& environment, const NodeMedium& m,
                         const Vec3& velocity, double dt) {
    NodeDamping damping;
    if (m.submerged > 0) {
        damping.current = compass(environment.current_towards) * environment.current_speed;
        const Vec3 flow = velocity - damping.current;
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

SymmetricMatrix SymmetricMatrix::inverse() const {
    const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
    const double scale = 1 / (xx * a + xy * b + xz * c);
    return {.xx = a * scale,
            .yy = (xx * zz - xz * xz) * scale,
            .zz = (xx * yy - xy * xy) * scale,
            .xy = b * scale,
            .xz = c * scale,
            .yz = (xy * xz - xx * yz) * scale};
}

SymmetricMatrix inverse_effective_mass(const NodeMedium& m, const NodeDamping& damping, double dt) {
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
