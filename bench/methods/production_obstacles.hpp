#pragma once
// The solids of a case as the server's chain meets them: meshes with its own finder, planes beside it.

#include "bench/problem/obstacle.hpp"
#include "server/physics/contact/obstacle_contact.hpp"

#include <vector>

namespace windlass::lab {

/// All obstacles, ready to be asked. The chain's middle line keeps their thickness off them, as PBD's
/// particles do.
class ProductionObstacles {
public:
    /// capacity: most links. Throws std::invalid_argument for a mesh that is not thicker than nothing: links
    /// lie round its edges at that distance.
    ProductionObstacles(const std::vector<Obstacle>& obstacles, int capacity);

    bool empty() const { return planes_.empty() && meshes_.empty(); }

    /// The contacts of a step of dt (s). foot: whether the lowest node is free to be touched.
    physics::ContactSet& find(const physics::ChainDef& def, const physics::ChainState& chain, double dt,
                              bool foot);

    /// Whether something bore the node in the last step that was asked for.
    bool touched(int node) const { return touched_[node] != 0; }

private:
    struct Mesh {
        double thickness;
        physics::ObstacleMesh surface;
        SurfaceMaterial material;
        physics::ObstacleContacts finder;
    };
    std::vector<Obstacle> planes_;
    std::vector<Mesh> meshes_;
    physics::ContactSet set_;
    std::vector<char> touched_;
};

} // namespace windlass::lab
