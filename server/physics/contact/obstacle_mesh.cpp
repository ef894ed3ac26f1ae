#include "server/physics/contact/obstacle_mesh.hpp"

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace windlass::physics {

namespace {

/// Sides bent by less than this (sine) are taken for flat: contact never stands on them.
constexpr double kFlat = 1e-3;

btVector3 bullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// Finds ridges: which triangle lies across each side, and whether the surface falls away there.
void join_sides(const std::vector<std::array<int, 3>>& corners, std::vector<MeshTriangle>& triangles) {
    std::map<std::pair<int, int>, std::pair<std::size_t, int>> side_from_to;
    for (std::size_t t = 0; t < corners.size(); ++t)
        for (int k = 0; k < 3; ++k)
            side_from_to[{corners[t][k], corners[t][(k + 1) % 3]}] = {t, k};
    for (std::size_t t = 0; t < corners.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            MeshTriangle& here = triangles[t];
            const auto other = side_from_to.find({corners[t][(k + 1) % 3], corners[t][k]});
            here.beyond[k] = here.normal;
            here.own_side[k] = true;
            if (other == side_from_to.end()) continue; // an open border
            const MeshTriangle& there = triangles[other->second.first];
            const Vec3 far_corner = there.corner[(other->second.second + 2) % 3];
            here.beyond[k] = there.normal;
            here.own_side[k] = t < other->second.first;
            here.ridge[k] = here.normal.dot(far_corner - here.corner[k]) < 0 &&
                            here.normal.cross(there.normal).norm() > kFlat;
        }
    }
}

} // namespace

struct ObstacleMesh::Tree {
    std::vector<double> corner; ///< x, y, z of each
    std::vector<int> index;
    std::unique_ptr<btTriangleIndexVertexArray> surface;
    std::unique_ptr<btBvhTriangleMeshShape> shape;
};

ObstacleMesh::ObstacleMesh(const std::vector<Vec3>& corners, const std::vector<std::array<int, 3>>& triangles)
    : low_(Vec3::Constant(1e300)), high_(Vec3::Constant(-1e300)), tree_(std::make_unique<Tree>()) {
    for (const std::array<int, 3>& t : triangles) {
        MeshTriangle triangle;
        for (int k = 0; k < 3; ++k) {
            if (t[k] < 0 || t[k] >= static_cast<int>(corners.size()))
                throw std::invalid_argument("a triangle of the mesh names a corner that does not exist");
            triangle.corner[k] = corners[t[k]];
            low_ = low_.cwiseMin(corners[t[k]]);
            high_ = high_.cwiseMax(corners[t[k]]);
            tree_->index.push_back(t[k]);
        }
        const Vec3 area =
            (triangle.corner[1] - triangle.corner[0]).cross(triangle.corner[2] - triangle.corner[0]);
        if (area.norm() < 1e-12) throw std::invalid_argument("a triangle of the mesh has no area");
        triangle.normal = area.normalized();
        triangle.low = triangle.corner[0].cwiseMin(triangle.corner[1]).cwiseMin(triangle.corner[2]);
        triangle.high = triangle.corner[0].cwiseMax(triangle.corner[1]).cwiseMax(triangle.corner[2]);
        triangles_.push_back(triangle);
    }
    if (triangles_.empty()) throw std::invalid_argument("a mesh without triangles");
    join_sides(triangles, triangles_);

    for (const Vec3& corner : corners)
        tree_->corner.insert(tree_->corner.end(), {corner.x(), corner.y(), corner.z()});
    tree_->surface = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(triangles.size()), tree_->index.data(), static_cast<int>(3 * sizeof(int)),
        static_cast<int>(corners.size()), tree_->corner.data(), static_cast<int>(3 * sizeof(double)));
    tree_->shape = std::make_unique<btBvhTriangleMeshShape>(tree_->surface.get(), true);
}

ObstacleMesh::~ObstacleMesh() = default;
ObstacleMesh::ObstacleMesh(ObstacleMesh&&) noexcept = default;

const MeshTriangle& ObstacleMesh::triangle(int index) const {
    return triangles_[index];
}

int ObstacleMesh::near(const Vec3& low, const Vec3& high, std::vector<int>& found) const {
    if ((low.array() > high_.array()).any() || (high.array() < low_.array()).any()) return 0;
    struct Collector final : btTriangleCallback {
        std::vector<int>& list;
        std::size_t count = 0;
        explicit Collector(std::vector<int>& l) : list(l) {}
        void processTriangle(btVector3* /*corners*/, int /*part*/, int index) override {
            if (count < list.size()) list[count++] = index;
        }
    } collector(found);
    tree_->shape->processAllTriangles(&collector, bullet(low), bullet(high));
    return static_cast<int>(collector.count);
}

ObstacleMesh box_mesh(const Vec3& low, const Vec3& high) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back(k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(),
                             k & 4 ? high.z() : low.z());
    return {corners,
            {{0, 2, 3},
             {0, 3, 1},
             {4, 5, 7},
             {4, 7, 6},
             {0, 1, 5},
             {0, 5, 4},
             {2, 6, 7},
             {2, 7, 3},
             {0, 4, 6},
             {0, 6, 2},
             {1, 3, 7},
             {1, 7, 5}}};
}

} // namespace windlass::physics
