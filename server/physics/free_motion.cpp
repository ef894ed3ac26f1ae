#include "server/physics/free_motion.hpp"

#include "server/physics/lanes.hpp"

#include <algorithm>

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

/// The same for nodes in reach of the seabed: those that it bears among them.
void move_on_bed(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                 const StepTime& time, const Vec3& current, int first, int last, double length,
                 FreeMotion& motion) {
    WINDLASS_LANES
    for (int i = first; i <= last; ++i) {
        const Vec3 at = state.position.at(i), v = state.velocity.at(i);
        const NodeMedium m =
            node_medium(def, environment, state.position.at(i - 1), at, state.position.at(i + 1), length);
        const NodeDamping damping = node_damping(def, environment, m, v, current);
        const double hold = bed_hold(damping, time.dt), push = bed_push(m, damping, v, time.dt);
        const SymmetricMatrix w = inverse_mass_on_bed(m, damping, hold, time.kick);
        const Vec3 momentum =
            free_momentum(def, environment, m, damping, v, time.kick) + Vec3(0, 0, time.kick * push);
        motion.inverse_mass.set(i, w);
        motion.place.set(i, at + time.dt * (w * momentum));
    }
}

/// Nodes from first to last.
struct Range {
    int first, last;
};

/// The smallest range of nodes, of those between the ends and awake, that holds all below the seabed's level.
Range nodes_at_bed(const EnvironmentDef& environment, const ChainState& state) {
    const double bed = -environment.depth;
    Range range{state.asleep + 1, state.links - 1};
    while (range.first <= range.last && state.position.z[range.first] >= bed)
        ++range.first;
    while (range.first <= range.last && state.position.z[range.last] >= bed)
        --range.last;
    return range;
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
    const int n = state.links, foot = state.asleep, top = n - 1;
    const Range bed = nodes_at_bed(environment, state);
    const auto everywhere = [&](auto&& move, int first, int last) { // the top node stands for another length
        move(first, std::min(last, top - 1), def.node_spacing);
        if (last == top && first <= top) move(top, top, node_length(def, state, top));
    };
    motion.even = environment.water_density == 0 && bed.first > bed.last && is_even(tail.inverse_mass);
    if (motion.even) {
        everywhere([&](int first, int last,
                       double length) { move_in_air(def, state, time, first, last, length, motion); },
                   foot + 1, top);
    } else {
        const auto afloat = [&](int first, int last, double length) {
            move_in_water(def, environment, state, time, current, first, last, length, motion);
        };
        everywhere(afloat, foot + 1, bed.first - 1);
        everywhere(
            [&](int first, int last, double length) {
                move_on_bed(def, environment, state, time, current, first, last, length, motion);
            },
            bed.first, bed.last);
        everywhere(afloat, std::max(bed.first, bed.last + 1), top);
    }

    motion.even_inverse[foot] = tail.inverse_mass.xx;
    motion.inverse_mass.set(foot, tail.inverse_mass);
    motion.place.set(foot, state.position.at(foot) + time.dt * tail.velocity);
    motion.even_inverse[n] = 0;
    motion.inverse_mass.set(n, {});
    motion.place.set(n, hawse);
}

} // namespace windlass::physics
