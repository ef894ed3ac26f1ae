#include "server/physics/free_motion.hpp"

#include "server/physics/lanes.hpp"

#include <cstdint>

namespace windlass::physics {

namespace {

/// Nodes from first to last, each standing for length (m) of chain; clear of the seabed.
void move_in_water(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                   const StepTime& time, const Vec3& current, int first, int last, double length,
                   FreeMotion& motion) {
    WINDLASS_LANES
    for (int i = first; i <= last; ++i) {
        const Vec3 at = state.position.at(i), v = state.velocity.at(i);
        const NodeMedium m =
            node_medium(def, environment, state.position.at(i - 1), at, state.position.at(i + 1), length);
        const NodeDamping damping = water_damping(def, environment, m, v, current);
        const SymmetricMatrix w = inverse_mass_afloat(m, damping, time.kick);
        motion.inverse_mass.set(i, w);
        motion.place.set(i, at + time.dt * (w * free_momentum(def, environment, m, damping, v, time.kick)));
    }
}

/// The same in air, where nothing but weight acts.
void move_in_air(const ChainDef& def, const ChainState& state, const StepTime& time, int first, int last,
                 double length, FreeMotion& motion) {
    const double inverse = 1 / (def.mass_per_metre * length);
    const Vec3 fall(0, 0, -time.kick * kGravity);
    WINDLASS_LANES
    for (int i = first; i <= last; ++i) {
        motion.even_inverse[i] = inverse;
        motion.place.set(i, state.position.at(i) + time.dt * (state.velocity.at(i) + fall));
    }
}

/// The same for those nodes that the seabed bears.
void move_on_bed(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                 const StepTime& time, const Vec3& current, int first, FreeMotion& motion) {
    for (int i = first; i < state.links; ++i) {
        if (state.position.z[i] >= -environment.depth) continue;
        const Vec3 v = state.velocity.at(i);
        const NodeMedium m = node_medium(def, environment, state, i);
        if (!on_bed(m, v, time.dt)) continue;
        const NodeDamping damping = node_damping(def, environment, m, v, current, time.dt);
        const SymmetricMatrix w = inverse_mass_on_bed(m, damping, time.dt, time.kick);
        Vec3 momentum = free_momentum(def, environment, m, damping, v, time.kick);
        momentum.z() += time.kick * m.bed_stiffness * m.penetration;
        motion.inverse_mass.set(i, w);
        motion.place.set(i, state.position.at(i) + time.dt * (w * momentum));
    }
}

bool bed_in_reach(const EnvironmentDef& environment, const ChainState& state, int first) {
    const double bed = -environment.depth;
    std::int64_t sunk = 0;
    for (int i = first; i < state.links; ++i)
        sunk += state.position.z[i] < bed ? 1 : 0;
    return sunk > 0;
}

bool is_even(const SymmetricMatrix& m) {
    return m.xx == m.yy && m.xx == m.zz && m.xy == 0 && m.xz == 0 && m.yz == 0;
}

} // namespace

void give_each_node_its_matrix(const ChainState& state, FreeMotion& motion) {
    if (!motion.even) return;
    motion.even = false;
    for (int i = state.asleep; i <= state.links; ++i) {
        const double w = motion.even_inverse[i];
        motion.inverse_mass.set(i, {.xx = w, .yy = w, .zz = w});
    }
}

void move_freely(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                 const StepTime& time, const ChainTail& tail, const Vec3& hawse, FreeMotion& motion) {
    const Vec3 current = compass(environment.current_towards) * environment.current_speed;
    const int n = state.links, foot = state.asleep;
    const double top = node_length(def, state, n - 1);
    const bool bed = bed_in_reach(environment, state, foot + 1);
    motion.even = environment.water_density == 0;
    if (motion.even) {
        move_in_air(def, state, time, foot + 1, n - 2, def.node_spacing, motion);
        if (n - 1 > foot) move_in_air(def, state, time, n - 1, n - 1, top, motion);
        if (bed || !is_even(tail.inverse_mass)) give_each_node_its_matrix(state, motion);
    } else {
        move_in_water(def, environment, state, time, current, foot + 1, n - 2, def.node_spacing, motion);
        if (n - 1 > foot) move_in_water(def, environment, state, time, current, n - 1, n - 1, top, motion);
    }
    if (bed) move_on_bed(def, environment, state, time, current, foot + 1, motion);

    motion.even_inverse[foot] = tail.inverse_mass.xx;
    motion.inverse_mass.set(foot, tail.inverse_mass);
    motion.place.set(foot, state.position.at(foot) + time.dt * tail.velocity);
    motion.even_inverse[n] = 0;
    motion.inverse_mass.set(n, {});
    motion.place.set(n, hawse);
}

} // namespace windlass::physics
