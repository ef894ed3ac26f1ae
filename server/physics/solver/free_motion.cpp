#include "server/physics/solver/free_motion.hpp"

#include "server/physics/base/vectorise.hpp"
#include "server/physics/sea/current.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <type_traits>

namespace windlass::physics {

namespace {

/// No bed in reach.
struct Afloat {};

/// The level bed under a node is what the node's medium says already.
struct OnLevelBed {
    LevelBed bed;
    WINDLASS_INLINE LevelBed under(int, NodeMedium&) const { return bed; }
};

struct OnGround {
    const ChainDef& def;
    const BedField& beds;
    SlopingBed under(int i, NodeMedium& m) const {
        const BedUnder bed = beds.at(i);
        set_on_bed(def, bed, m);
        return sloping_bed(bed);
    }
};

/// Nodes from first to last, each standing for length (m) of chain. beds: Afloat, or what is in reach of the
/// nodes, those that it bears among them. current(i): m/s, at node i.
template <class Beds, class Current>
WINDLASS_WIDE void move_in_water(const ChainDef& def, const EnvironmentDef& environment,
                                 const ChainState& state, const StepTime& time, const Beds& beds,
                                 const Current& current, int first, int last, double length,
                                 FreeMotion& motion) {
    WINDLASS_VECTORISE
    for (int i = first; i <= last; ++i) {
        const Vec3 at = state.position.at(i), v = state.velocity.at(i);
        NodeMedium m =
            node_medium(def, environment, state.position.at(i - 1), at, state.position.at(i + 1), length);
        if constexpr (std::is_same_v<Beds, Afloat>) {
            const NodeDamping damping = water_damping(def, environment, m, v, current(i));
            const SymmetricMatrix w = inverse_mass_afloat(m, damping, time.kick);
            const Vec3 momentum = free_momentum(def, environment, m, damping, v, time.kick);
            motion.inverse_mass.set(i, w);
            motion.place.set(i, at + time.dt * (w * momentum));
        } else {
            const auto bed = beds.under(i, m);
            NodeDamping damping = node_damping(def, environment, bed, m, v, current(i));
            damping.friction = friction_about(damping.friction.max, bed.slide(v));
            motion.friction.set(i, damping.friction);
            const SymmetricMatrix w =
                inverse_mass_on_bed(bed, m, damping, bed_hold(damping, time.dt), time.kick);
            const double push = bed_push(m, damping, bed.rise(v), time.dt);
            const Vec3 momentum = free_momentum(def, environment, m, damping, v, time.kick) +
                                  bed.out(time.kick * push) -
                                  time.kick * damping.friction.max * damping.friction.direction;
            motion.inverse_mass.set(i, w);
            motion.place.set(i, at + time.dt * (w * momentum));
        }
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
    // Mostly there is none, which a count tells sooner than a search.
    std::int64_t below = 0;
    WINDLASS_VECTORISE
    for (int i = range.first; i <= range.last; ++i)
        below += state.position.z[i] < bed ? 1 : 0;
    if (below == 0) return {state.links, state.links - 1};
    while (range.first <= range.last && state.position.z[range.first] >= bed)
        ++range.first;
    while (range.first <= range.last && state.position.z[range.last] >= bed)
        --range.last;
    return range;
}

/// The same where the bed is not level; says what lies under each of them.
Range nodes_on_ground(const EnvironmentDef& environment, const ChainState& state, BedField& beds) {
    const Ground& ground = *environment.ground;
    Range range{state.links, state.links - 1};
    for (int i = state.asleep + 1; i < state.links; ++i) {
        const Vec3 at = state.position.at(i);
        const bool clear = at.z() + environment.depth >= ground.ceiling(at.x(), at.y());
        const BedUnder bed = clear ? BedUnder{} : ground.under(-environment.depth, at);
        beds.set(i, bed);
        if (bed.penetration <= 0) continue;
        if (range.first > i) range.first = i;
        range.last = i;
    }
    return range;
}

} // namespace

void move_freely(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                 const StepTime& time, const ChainTail& tail, const Vec3& hawse, FreeMotion& motion) {
    assert(time.dt > 0 && time.kick > 0 && "a step takes time");
    assert(state.links < static_cast<int>(motion.place.x.size()) && "a place for every node in use");
    const int n = state.links, foot = state.asleep;
    const bool level = motion.level = environment.ground == nullptr;
    const Range bed =
        level ? nodes_at_bed(environment, state) : nodes_on_ground(environment, state, motion.bed);
    motion.bed_first = bed.first, motion.bed_last = bed.last;
    // All nodes but the ends: what floats below the bed's range, what lies in it, what floats above.
    const auto move = [&](const auto& beds, const auto& current) {
        const auto run = [&](const auto& under, int first, int last) {
            const int below_top = std::min(last, n - 2);
            move_in_water(def, environment, state, time, under, current, first, below_top, def.node_spacing,
                          motion);
            if (first <= n - 1 && last == n - 1) // the top node stands for another length
                move_in_water(def, environment, state, time, under, current, last, last,
                              node_length(def, state, last), motion);
        };
        run(Afloat{}, foot + 1, bed.first - 1);
        run(beds, bed.first, bed.last);
        run(Afloat{}, std::max(bed.first, bed.last + 1), n - 1);
    };
    const auto move_over_bed = [&](const auto& current) {
        if (level)
            move(OnLevelBed{level_bed(environment)}, current);
        else
            move(OnGround{def, motion.bed}, current);
    };
    if (environment.current_profile.empty()) {
        Vec3 current = current_at(environment, 0);
        move_over_bed([=](int) WINDLASS_INLINE { return current; });
    } else {
        for (int i = foot + 1; i < n; ++i)
            motion.current.set(i, current_at(environment, state.position.z[i]));
        move_over_bed([&](int i) WINDLASS_INLINE { return motion.current.at(i); });
    }

    motion.inverse_mass.set(foot, tail.inverse_mass);
    motion.place.set(foot, state.position.at(foot) + time.dt * tail.velocity);
    motion.inverse_mass.set(n, {});
    motion.place.set(n, hawse);
}

} // namespace windlass::physics
