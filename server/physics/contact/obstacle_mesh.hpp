#pragma once
// A solid body as a closed surface of triangles that chain may lie against: hull, stem, dock, a block.

#include "server/physics/sea/environment.hpp"

#include <array>
#include <memory>
#include <vector>

namespace windlass::physics {

/// A triangle of a mesh as contact sees it.
struct MeshTriangle {
    std::array<Vec3, 3> corner{Vec3::Zero(), Vec3::Zero(),
                               Vec3::Zero()}; ///< m, anticlockwise seen from outside
    Vec3 low = corner[0], high = corner[0];   ///< m, of the box round it
    Vec3 normal = Vec3::UnitZ();              ///< unit vector out of the body
    std::array<Vec3, 3> beyond = corner; ///< normal of the triangle across the side from corner k to k + 1
    std::array<bool, 3> ridge{};    ///< whether that side is a ridge: the surface falls away on both hands
    std::array<bool, 3> own_side{}; ///< of the two triangles at a side one owns it, so that it counts once
};

/// Triangles with a bounding-volume tree (Bullet's). Does not change after it is built.
class ObstacleMesh {
public:
    /// corners: m, in the body's frame; triangles: three corners each, anticlockwise seen from outside. The
    /// surface may be open where chain does not come. Throws std::invalid_argument for a corner that does not
    /// exist or a triangle without area.
    ObstacleMesh(const std::vector<Vec3>& corners, const std::vector<std::array<int, 3>>& triangles);
    ~ObstacleMesh();
    ObstacleMesh(ObstacleMesh&&) noexcept;

    /// Puts into found the triangles whose box meets the given one (m), in a fixed order; at most its size.
    /// Returns their number.
    int near(const Vec3& low, const Vec3& high, std::vector<int>& found) const;
    const MeshTriangle& triangle(int index) const;
    int triangles() const { return static_cast<int>(triangles_.size()); }
    const Vec3& low() const { return low_; }
    const Vec3& high() const { return high_; }

private:
    struct Tree; // Bullet stays in the source file
    std::vector<MeshTriangle> triangles_;
    Vec3 low_, high_;
    std::unique_ptr<Tree> tree_;
};

/// Whether a direction (of any length) points out of a ridge, between the normals a and b of its two faces;
/// by so much (of its length) it may point past them.
inline bool between_normals(const Vec3& direction, const Vec3& a, const Vec3& b, double tolerance) {
    const double cosine = a.dot(b), da = direction.dot(a), db = direction.dot(b);
    return da - cosine * db >= -tolerance && db - cosine * da >= -tolerance;
}

/// A box with its faces along the axes, from low to high (m).
ObstacleMesh box_mesh(const Vec3& low, const Vec3& high);

} // namespace windlass::physics
