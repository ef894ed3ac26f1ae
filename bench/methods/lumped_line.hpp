#pragma once
// A problem cut into equal links whose mass is lumped at the nodes: what the methods that work on nodes
// share. Order and frame as in server/physics/chain/chain.hpp.

#include "bench/problem/problem.hpp"
#include "server/physics/chain/chain_forces.hpp"

#include <vector>

namespace windlass::lab {

using physics::Field;

/// Whether the end stays or goes where it is put, whatever pulls at it.
inline bool held(const End& end) {
    return end.kind == EndKind::fixed || end.kind == EndKind::driven;
}

/// Share of a sliding speed (m/s) that is left after a time in which Coulomb's friction takes loss (m/s) of
/// it, viscous below the server's creep: the friction at the end of that time, so that any step is stable.
/// Without branches, so that loops vectorise.
inline double kept_by_friction(double speed, double loss) {
    const double creep = physics::kFrictionCreep;
    const double sliding = 1 - loss / (speed + 1e-30), creeping = creep / (creep + loss);
    return sliding * speed > creep ? sliding : creeping;
}

/// Throws std::invalid_argument where the problem has no answer: no length, no starting shape, an end without
/// the motion or the mass that it needs; or where a step is not longer than 0 s.
void check_problem(const Problem& problem, double dt);

/// The discrete line. Constant, but for what its ends are made to do.
struct LumpedLine {
    Problem problem;
    int links = 0;
    double rest = 0;   ///< m, unstretched length of a link
    double spring = 0; ///< N/m, of a link
    double damper = 0; ///< N s/m, structural damping of a link
    int first = 0;     ///< lowest and highest node that move freely
    int last = 0;
    std::vector<double> length;     ///< m of chain that each node stands for
    std::vector<double> mass;       ///< kg of chain, without added mass
    std::vector<double> displaced;  ///< kg of water that it displaces when fully under
    std::vector<double> bed_spring; ///< N/m, of the seabed under it
    std::vector<double> end_mass;   ///< kg attached to it
    std::vector<double> end_weight; ///< N, of that mass, downwards
    Vec3 current = Vec3::Zero();    ///< m/s

    /// Throws std::invalid_argument where the problem has no answer: no links or length, an end without
    /// motion or mass that needs it, no step.
    LumpedLine(const Problem& problem, int links, double dt);

    int nodes() const { return links + 1; }
    bool in_water() const { return problem.environment.water_density > 0; }

    /// Whether any node can get to the seabed: else, in air, none need look for it.
    bool bed_in_reach() const;

    /// Puts all nodes into the starting shape, at rest but for the driven ends.
    void start(Field& position, Field& velocity) const;

    /// Puts the held ends where they are at the given time (s), with their velocity.
    void hold(double time, Field& position, Field& velocity) const;

    /// Least mass of a node in any direction, kg, and largest of the seabed's natural frequencies under the
    /// nodes, rad/s: they bound an explicit step.
    double min_mass() const;
    double bed_frequency() const;
};

} // namespace windlass::lab
