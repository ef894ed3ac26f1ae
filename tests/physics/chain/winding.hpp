#pragma once
// Whether a point is inside a mesh.

#include "server/physics/contact/obstacle_mesh.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace windlass::physics {

/// Solid angle under which the mesh is seen from a point, over 4 pi: 1 inside a closed surface whose
/// triangles face outwards, 0 outside (van Oosterom, Strackee 1983).
inline double winding(const ObstacleMesh& mesh, const Vec3& point) {
    std::vector<int> all(4096);
    const int count = mesh.near(mesh.low(), mesh.high(), all);
    double angle = 0;
    for (int t = 0; t < count; ++t) {
        const auto& corner = mesh.triangle(all[t]).corner;
        const Vec3 a = corner[0] - point, b = corner[1] - point, c = corner[2] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle +=
            2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle / (4 * std::numbers::pi);
}

} // namespace windlass::physics
