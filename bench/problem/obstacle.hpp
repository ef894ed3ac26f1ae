#pragma once
// What a line can meet besides the flat seabed: deck, hull, hawse lip, dock, a seabed with shape. Fixed in
// the world; z up, metres.

#include "server/physics/sea/environment.hpp"

#include <array>
#include <vector>

namespace windlass::lab {

/// How a surface takes what touches it.
struct SurfaceMaterial {
    double thickness = 0;  ///< m, by which it lies before (positive) or behind (negative) what is drawn
    double friction = 0;   ///< Coulomb's coefficient
    double stickiness = 0; ///< m/s2, N on each kg in touch that it holds back with before that comes off
};

/// One solid. Without triangles it is the half space behind a plane; with triangles it is a surface that is
/// met from the side on which its triangles' corners run counterclockwise.
struct Obstacle {
    SurfaceMaterial material;
    physics::Vec3 point = physics::Vec3::Zero();   ///< m, on the plane
    physics::Vec3 normal = physics::Vec3::UnitZ(); ///< out of the solid, of unit length
    std::vector<physics::Vec3> corners;            ///< m, of the mesh
    std::vector<std::array<int, 3>> triangles;     ///< numbers of corners; empty: a plane

    bool is_plane() const { return triangles.empty(); }
};

} // namespace windlass::lab
