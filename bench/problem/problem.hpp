#pragma once
// A single line between two ends as every method in the comparison gets it. Order and frame as in
// server/physics/chain/chain.hpp: node 0 at the lower end, z up, still water at z = 0; SI.

#include "bench/problem/obstacle.hpp"
#include "server/physics/chain/chain.hpp"

#include <functional>
#include <vector>

namespace windlass::lab {

using physics::Vec3;

/// How an end of the line is held.
enum class EndKind {
    fixed, ///< stays where it starts
    free,  ///< nothing but the half link that the end node stands for
    mass,  ///< a point mass hangs on it
    driven ///< goes where motion says
};

/// One end.
struct End {
    EndKind kind = EndKind::fixed;
    double mass = 0;                         ///< kg, EndKind::mass
    double weight = 0;                       ///< N, of that mass, downwards (less buoyancy)
    std::function<Vec3(double time)> motion; ///< m, EndKind::driven
};

/// What is to be computed. Every method uses the same physics as far as it can: what it leaves out (bed,
/// drag, slack...) it says in its description.
struct Problem {
    physics::ChainDef line;              ///< node_spacing is set from the number of links
    physics::EnvironmentDef environment; ///< water_density 0: air; depth: of the flat bed
    double length = 100;                 ///< m, unstretched
    End lower, upper;
    std::vector<Obstacle> obstacles; ///< besides the flat bed; a method that cannot do them refuses
    std::function<Vec3(double arc)>
        start; ///< m, place of the point at unstretched length arc (m) from the lower end
    /// The same for a line that does not stretch, where start is one at rest; none: start will do.
    std::function<Vec3(double arc)> rigid_start;
    double duration = 10; ///< s
};

} // namespace windlass::lab
