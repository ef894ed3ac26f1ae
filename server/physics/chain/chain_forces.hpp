#pragma once
// What water and seabed do to one node of the chain.

#include "server/physics/base/vectorise.hpp"
#include "server/physics/chain/bed_friction.hpp"
#include "server/physics/chain/chain.hpp"
#include "server/physics/sea/ground.hpp"

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
    double penetration = 0;       ///< m into the seabed along its normal, 0 above it
    double bed_stiffness = 0;     ///< N/m of this node, along the normal
};

/// The value itself where it is positive, else 0. By value: std::max's references keep loops from
/// vectorising.
inline double positive_part(double value) {
    return value > 0 ? value : 0;
}

/// Share of a piece of chain of length h (m), centred z (m) over the surface, that is under water: 0..1.
inline double submerged_share(double z, double h) {
    const double share = 0.5 - z / h;
    return share < 0 ? 0 : share > 1 ? 1 : share;
}

/// below, at, above: places of the node and its neighbours, m; length: of chain that the node stands for, m.
/// The bed is the level one; see set_on_bed() for any other.
/// Without branches, so that a loop over nodes vectorises; so are the next two.
WINDLASS_INLINE inline NodeMedium node_medium(const ChainDef& def, const EnvironmentDef& environment,
                                              const Vec3& below, const Vec3& at, const Vec3& above,
                                              double length) {
    NodeMedium m;
    const Vec3 across = above - below;
    const double size = across.norm();
    const bool point = size < 1e-9 * def.node_spacing; // a heap: any direction will do
    const double scale = point ? 0 : 1 / size;
    m.tangent = {across.x() * scale, across.y() * scale, point ? 1 : across.z() * scale};
    m.length = length;
    m.submerged = submerged_share(at.z() - environment.level, length);
    const double displaced = m.submerged * environment.water_density * def.displacement * length;
    const double mass = def.mass_per_metre * length;
    m.mass_normal = mass + def.added_mass_normal * displaced;
    m.mass_axial = mass + def.added_mass_axial * displaced;
    m.penetration = positive_part(-environment.depth - at.z());
    m.bed_stiffness = environment.bed_stiffness * def.contact_diameter * length;
    return m;
}

/// The node on another bed.
inline void set_on_bed(const ChainDef& def, const BedUnder& bed, NodeMedium& m) {
    m.penetration = bed.penetration;
    m.bed_stiffness = bed.stiffness * def.contact_diameter * m.length;
}

/// Node i of a chain; 0 < i < links.
inline NodeMedium node_medium(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                              int i) {
    return node_medium(def, environment, state.position.at(i - 1), state.position.at(i),
                       state.position.at(i + 1), node_length(def, state, i));
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
    double bed_normal = 0;       ///< against the seabed, along its normal
    double bed_spring = 0;       ///< N/m, of the seabed where it bears the node
    BedFriction friction;        ///< against the seabed, across its normal; N, N s/m
    Vec3 current = Vec3::Zero(); ///< m/s, of the water
};

/// Morison drag F = -1/2 rho C d h |u| u, with |u| from the velocity before the step and u from the one
/// after: their product is |u| u at the middle, second order, and stable for any step.
WINDLASS_INLINE inline NodeDamping water_damping(const ChainDef& def, const EnvironmentDef& environment,
                                                 const NodeMedium& m, const Vec3& velocity,
                                                 const Vec3& current) {
    NodeDamping damping;
    const Vec3 flow = velocity - current;
    const double along = flow.dot(m.tangent);
    const double across = std::sqrt(positive_part(flow.squaredNorm() - along * along));
    const double area = 0.5 * environment.water_density * def.diameter * m.length * m.submerged;
    damping.normal = area * def.drag_normal * across;
    damping.axial = area * def.drag_axial * std::abs(along);
    damping.current = current;
    return damping;
}

/// How a level seabed meets a node's motion, and how any other does: the same in two sets of axes, because
/// the first is all that most exercises need and costs less.
struct LevelBed {
    double friction = 0, suction = 0; ///< -, as in ChainBed

    double rise(const Vec3& velocity) const { return velocity.z(); } ///< m/s, out of the bed
    Vec3 slide(const Vec3& velocity) const { return {velocity.x(), velocity.y(), 0}; } ///< along it
    Vec3 out(double size) const { return {0, 0, size}; } ///< a vector out of the bed
    /// Of the given size across and along the normal.
    SymmetricMatrix resistance(double across, double along) const {
        return {.xx = across, .yy = across, .zz = along};
    }
};
struct SlopingBed {
    Vec3 normal = Vec3::UnitZ();
    double friction = 0, suction = 0;

    double rise(const Vec3& velocity) const { return velocity.dot(normal); }
    Vec3 slide(const Vec3& velocity) const { return velocity - rise(velocity) * normal; }
    Vec3 out(double size) const { return size * normal; }
    SymmetricMatrix resistance(double across, double along) const {
        return about_axis(normal, across, along);
    }
};
inline LevelBed level_bed(const EnvironmentDef& environment) {
    return {environment.bed_friction, environment.bed_suction};
}
inline SlopingBed sloping_bed(const BedUnder& bed) {
    return {bed.normal, bed.friction, bed.suction};
}

/// The seabed's damper under a node, N s/m: critical, so that chain does not bounce.
inline double bed_damper(const NodeMedium& m) {
    return 2 * std::sqrt(m.bed_stiffness * m.mass_normal);
}

/// 1 where the seabed bears the node, else 0. One that rises so fast that the damper would pull by more than
/// the soil's suction is let go. Suction is the damper's alone: chain that is lifted slowly feels none of it.
template <class Bed>
inline double bed_share(const Bed& bed, const NodeMedium& m, const Vec3& velocity) {
    const double spare =
        (1 + bed.suction) * m.bed_stiffness * m.penetration - bed_damper(m) * bed.rise(velocity);
    const double touches = m.penetration > 0 ? 1 : 0, pushes = spare > 0 ? 1 : 0;
    return touches * pushes;
}

/// The same with the seabed's resistance where it bears the node; friction as of its speed before the step.
template <class Bed>
WINDLASS_INLINE inline NodeDamping node_damping(const ChainDef& def, const EnvironmentDef& environment,
                                                const Bed& bed, const NodeMedium& m, const Vec3& velocity,
                                                const Vec3& current) {
    NodeDamping damping = water_damping(def, environment, m, velocity, current);
    const double share = bed_share(bed, m, velocity);
    damping.bed_spring = share * m.bed_stiffness;
    damping.bed_normal = share * bed_damper(m);
    damping.friction =
        friction_in_proportion(share * bed.friction * m.bed_stiffness * m.penetration, bed.slide(velocity));
    return damping;
}

/// Inverse of the effective mass of a node, whose velocity its forces change for the time kick (s): mass,
/// added mass and implicit drag, 1/kg.
WINDLASS_INLINE inline SymmetricMatrix inverse_mass_afloat(const NodeMedium& m, const NodeDamping& damping,
                                                           double kick) {
    return about_axis(m.tangent, 1 / (m.mass_normal + kick * damping.normal),
                      1 / (m.mass_axial + kick * damping.axial));
}

/// The seabed's push on a node is bed_push() - bed_hold() x its speed (out of the bed) after the step of dt
/// (s), N out of it: spring and damper weighted over the step as the links' pulls are, second order. Both are
/// nothing where it does not bear the node. rise: m/s, out of the bed, before the step.
inline double bed_hold(const NodeDamping& damping, double dt) {
    return 0.5 * damping.bed_normal + 0.25 * dt * damping.bed_spring;
}
inline double bed_push(const NodeMedium& m, const NodeDamping& damping, double rise, double dt) {
    return damping.bed_spring * m.penetration +
           (0.25 * dt * damping.bed_spring - 0.5 * damping.bed_normal) * rise;
}

/// The same for a node that the seabed bears: with its spring and damper, bed_hold(), and friction.
template <class Bed>
WINDLASS_INLINE inline SymmetricMatrix inverse_mass_on_bed(const Bed& bed, const NodeMedium& m,
                                                           const NodeDamping& damping, double hold,
                                                           double kick) {
    const double normal = m.mass_normal + kick * damping.normal;
    const double more = m.mass_axial + kick * damping.axial - normal;
    SymmetricMatrix held = bed.resistance(normal + kick * damping.friction.damping, normal + kick * hold);
    held.add(-kick * damping.friction.damping, damping.friction.direction);
    held.add(more, m.tangent);
    return held.inverse();
}

/// A vector times the effective mass that resists along and across the chain differently.
WINDLASS_INLINE inline Vec3 along_and_across(const Vec3& v, const Vec3& tangent, double normal,
                                             double axial) {
    return normal * v + ((axial - normal) * v.dot(tangent)) * tangent;
}

/// Momentum of a node after the time kick (s) if no link pulled, before the effective mass divides it, kg
/// m/s.
WINDLASS_INLINE inline Vec3 free_momentum(const ChainDef& def, const EnvironmentDef& environment,
                                          const NodeMedium& m, const NodeDamping& damping,
                                          const Vec3& velocity, double kick) {
    Vec3 momentum = along_and_across(velocity, m.tangent, m.mass_normal, m.mass_axial) +
                    along_and_across(kick * damping.current, m.tangent, damping.normal, damping.axial);
    momentum.z() -= kick * node_weight(def, environment, m);
    return momentum;
}

} // namespace windlass::physics
