#include "bench/methods/production_obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace windlass::lab {

using namespace physics;

namespace {

/// Contact stiffness over the line's mass per metre, N/m per kg/m: what the server has for its 78 mm cable.
constexpr double kStiffness = 2.25e5;

ContactMaterial material_of(const SurfaceMaterial& surface, const ChainDef& def) {
    return {.stiffness = kStiffness * def.mass_per_metre,
            .friction = surface.friction,
            .adhesion = surface.stickiness * def.mass_per_metre};
}

void find_on_plane(const Obstacle& plane, const ChainDef& def, const ChainState& chain, double dt, int first,
                   ContactSet& set) {
    const ContactMaterial material = material_of(plane.material, def);
    for (int i = first; i < chain.links; ++i) {
        const double height = plane.normal.dot(chain.position.at(i) - plane.point) - plane.material.thickness;
        if (height + dt * plane.normal.dot(chain.velocity.at(i)) > 0 && height > 0) continue;
        const double length = def.node_spacing;
        set.add(NodeContact{.node = i,
                            .touch = set.new_touch(),
                            .normal = plane.normal,
                            .penetration = -height,
                            .stiffness = material.stiffness,
                            .damping = 2 * std::sqrt(material.stiffness * def.mass_per_metre * length),
                            .friction = material.friction,
                            .adhesion = material.adhesion * length});
    }
}

} // namespace

ProductionObstacles::ProductionObstacles(const std::vector<Obstacle>& obstacles, int capacity)
    : set_(4 * capacity * static_cast<int>(obstacles.size() + 1), 0), touched_(capacity + 1) {
    for (const Obstacle& obstacle : obstacles) {
        if (obstacle.is_plane()) {
            planes_.push_back(obstacle);
            continue;
        }
        if (obstacle.material.thickness <= 0)
            throw std::invalid_argument("production: obstacles: a mesh of thickness " +
                                        std::to_string(obstacle.material.thickness) +
                                        " is not allowed: above 0, at which links lie round its edges");
        meshes_.push_back({obstacle.material.thickness, ObstacleMesh(obstacle.corners, obstacle.triangles),
                           obstacle.material, ObstacleContacts(capacity)});
    }
}

ContactSet& ProductionObstacles::find(const ChainDef& def, const ChainState& chain, double dt, bool foot) {
    set_.clear();
    for (const Obstacle& plane : planes_)
        find_on_plane(plane, def, chain, dt, foot ? 0 : 1, set_);
    for (Mesh& mesh : meshes_) {
        ChainDef as_thick = def;
        as_thick.contact_diameter = 2 * mesh.thickness;
        mesh.finder.find(as_thick, chain, dt, mesh.surface, {}, material_of(mesh.material, def), set_, foot);
    }
    std::fill(touched_.begin(), touched_.end(), 0);
    for (const NodeContact& contact : set_.node_contacts())
        touched_[contact.node] = 1;
    return set_;
}

} // namespace windlass::lab
