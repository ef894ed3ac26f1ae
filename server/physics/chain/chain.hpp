#pragma once
// The chain as nodes and links: its state, and how one step is taken.
//
// Order   node 0 is the anchor shackle, node n the hawse pipe lip; link i joins node i and node i + 1.
//         Veering appends nodes at the top, heaving takes them away; the arrays never grow.
// Frame   world: x east, y north, z up, metres; z = 0 at the water surface.
// Signs   tension is positive and never negative: a link that would push goes slack.
//         Paying out is positive.
// Time    leapfrog: positions and tensions belong to the end of the step, velocities to its middle; what a
//         force does to a velocity in a step, it does from the middle of the last one to the middle of this:
//         the kick of step_kick(). With it steps of any size follow each other at second order.
//
// One step (SHAKE with compliance, the axial force weighted over three instants):
//   predict   v* = W (M v + kick f),  p* = x + dt v*
//   solve     p_i = p*_i + dt kick W_i (F_i G_i - F_(i-1) G_(i-1)),  F = T(n+1) / 4 + T(n) / 2 + T(n-1) / 4
//             in steps of one size, with structural damping by the rate of stretch added (of chain without
//             any, F has T(n-2), too), such that every taut link obeys
//             |p_(i+1) - p_i| = l_i (1 + T_i(n+1) / EA), and every other has T_i = 0
//   update    v = (p - x) / dt,  x = p
// with G_i the unit vector of link i at the start of the step (symplectic, second order) and W the inverse
// mass, added mass and implicit drag included. Sources: Ryckaert et al. (1977) for SHAKE, Newmark (1959) for
// the weights 1/4, 1/2, 1/4; Hilber, Hughes, Taylor (1977) for those of undamped chain. The matrix of
// Newton's method is tridiagonal: it is eliminated from the anchor up, and what is left at the top is one
// scalar equation that the windlass answers (UpperEnd).

#include "server/physics/base/energy_ledger.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/chain/chain_def.hpp"
#include "server/physics/sea/environment.hpp"

#include <array>
#include <vector>

namespace windlass::physics {

/// Three components of a vector at every node, one array each.
struct Field {
    std::vector<double> x, y, z;

    explicit Field(int size = 0) : x(size), y(size), z(size) {}
    Vec3 at(int i) const { return {x[i], y[i], z[i]}; }
    void set(int i, const Vec3& v) { x[i] = v.x(), y[i] = v.y(), z[i] = v.z(); }
    void add(int i, const Vec3& v) { x[i] += v.x(), y[i] += v.y(), z[i] += v.z(); }
    int size() const { return static_cast<int>(x.size()); }
};

/// All that changes of a chain; a plain value: copy it, hash it, put it back.
struct ChainState {
    int links = 0; ///< in use; nodes in use are links + 1
    int asleep =
        0; ///< links at the anchor's end that lie still and are left alone; the node above them is held
    int parted = -1;             ///< link that has parted and pulls no more; -1: none
    double last_step = 0;        ///< s, the step that led here; 0: at rest, velocities are of this instant
    int stretched = 0;           ///< pieces of the cable from the anchor up to the last one with stretch
    double top_length = 0;       ///< m, unstretched length of the top link; the others have piece_length()
    Field position, velocity;    ///< m, m/s; world
    std::vector<double> tension; ///< N, at the end of the last step, per link, structural damping in it
    /// N, of it that of the stretch alone, which the next steps weigh; and the same one step earlier, and
    /// two.
    std::vector<double> elastic_tension, elastic_tension_before, elastic_tension_earlier;
    /// Permanent, of each piece of the cable, those inboard, too: share by which it is longer than when new.
    std::vector<double> stretch;

    /// What is kept of a link's tension, to be changed alike.
    auto tensions() {
        return std::array{&tension, &elastic_tension, &elastic_tension_before, &elastic_tension_earlier};
    }
    /// Link i has had this tension (N) for a while.
    void set_tension(int i, double now) {
        for (std::vector<double>* kept : tensions())
            if (!kept->empty()) (*kept)[i] = now;
    }
};
template <class Visitor, StateOf<ChainState> State>
void visit_state(Visitor& v, State& state); ///< of the links in use

/// A chain of the given unstretched length (m) between two points, straight, at rest and without tension.
/// capacity: most links it may ever have. Throws std::invalid_argument where they do not fit.
ChainState straight_chain(const ChainDef& def, const Vec3& anchor, const Vec3& hawse, double length,
                          int capacity);

/// Unstretched length from the anchor shackle to the hawse pipe lip, m.
double chain_length(const ChainDef& def, const ChainState& state);

/// m without load of the i-th piece of node_spacing, which links have for good: more when it was overloaded.
inline double piece_length(const ChainDef& def, const ChainState& state, int i) {
    return def.node_spacing * (1 + state.stretch[i]);
}

/// Unstretched length of link i, m.
inline double link_length(const ChainDef& def, const ChainState& state, int i) {
    return i == state.links - 1 ? state.top_length : piece_length(def, state, i);
}

/// m by which pieces from the first up to, but without, the last have become longer for good.
double grown(const ChainDef& def, const ChainState& state, int first, int last);

/// m that the first so many metres of new cable have become by now, and the other way round. Length counted
/// as new is what marks, surveys and joining shackles go by; nodes below the top are whole spacings of it.
double stretched_length(const ChainDef& def, const ChainState& state, double new_length);
double new_length(const ChainDef& def, const ChainState& state, double stretched_length);

/// Time over which the forces of a step of dt (s) change the velocities, s: from the middle of the step
/// before.
inline double step_kick(const ChainState& state, double dt) {
    return 0.5 * (state.last_step + dt);
}

/// Chain that node i stands for: half of each link beside it, m. Stretch adds no mass to it. For
/// 0 < i < links.
inline double node_length(const ChainDef& def, const ChainState& state, int i) {
    return 0.5 * (def.node_spacing + (i == state.links - 1 ? state.top_length : def.node_spacing));
}

/// The chain's own energy now, J.
struct ChainEnergy {
    double kinetic = 0;   ///< with added mass
    double potential = 0; ///< weight less buoyancy, zero at z = 0
    double elastic = 0;   ///< in links and in the seabed under them
    double total() const { return kinetic + potential + elastic; }
};
/// Elastic energy of link i, J; none in a parted one. deck_length: m of chain that stretches with the top
/// link.
double link_energy(const ChainDef& def, const ChainState& state, int i, double deck_length);

ChainEnergy chain_energy(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                         double deck_length = 0);

} // namespace windlass::physics
