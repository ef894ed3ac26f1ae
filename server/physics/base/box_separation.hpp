#pragma once
// How far apart two boxes are, or how deep in each other.

#include "server/physics/base/closest.hpp"

#include <cmath>

namespace windlass::physics {

/// A box in the world.
struct Box {
    Vec3 centre = Vec3::Zero(), half = Vec3::Zero(); ///< m
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// The plane that parts two boxes best.
struct BoxSeparation {
    Vec3 normal = Vec3::UnitZ(); ///< unit vector from b to a
    double distance = -1e300;    ///< m along it; negative: how far they must be moved to be clear
    Vec3 point = Vec3::Zero();   ///< m, world, where they meet
};

/// The shortest way that parts two boxes leads along the normal of a face, or square to an edge of either
/// (the theorem of separating axes; Gottschalk, Lin, Manocha 1996). Its length changes as the point where
/// they meet moves along it, so a spring of that length is one of the boxes' places alone and makes no
/// energy. While they are apart it is not more than their distance. Ends early, with less than the best,
/// where they are further apart than room (m).
inline BoxSeparation separation(const Box& a, const Box& b, double room) {
    constexpr double kParallel = 1e-3;  // edges that cross at less (sine) are left to the faces
    constexpr double kFaceFirst = 1e-6; // m; boxes that lie square touch with a face
    const Vec3 apart = a.centre - b.centre;
    const auto reach = [](const Box& box, const Vec3& n) {
        return box.half.dot((box.axes.transpose() * n).cwiseAbs());
    };
    BoxSeparation best;
    int first = -1, second = -1; // axes of a and of b
    const auto try_axis = [&](const Vec3& axis, int of_a, int of_b, double handicap) {
        const Vec3 n = axis.dot(apart) < 0 ? Vec3(-axis) : axis;
        const double distance = n.dot(apart) - reach(a, n) - reach(b, n);
        if (distance <= best.distance + handicap) return;
        best.normal = n, best.distance = distance;
        first = of_a, second = of_b;
    };
    for (int i = 0; i < 3; ++i)
        try_axis(a.axes.col(i), i, -1, 0);
    for (int i = 0; i < 3; ++i)
        try_axis(b.axes.col(i), -1, i, 0);
    if (best.distance > room) return best;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const Vec3 across = a.axes.col(i).cross(b.axes.col(j));
            const double sine = across.norm();
            if (sine > kParallel) try_axis(across / sine, i, j, kFaceFirst);
        }
    }
    if (best.distance > room) return best;
    // The corner of a box that reaches farthest along n; along its axis k: its middle.
    const auto corner = [](const Box& box, const Vec3& n, int k) {
        Vec3 at = Vec3::Zero();
        for (int i = 0; i < 3; ++i)
            if (i != k) at[i] = std::copysign(box.half[i], box.axes.col(i).dot(n));
        return Vec3(box.centre + box.axes * at);
    };
    const auto into = [](const Box& box, const Vec3& at) { // brought on to the box
        const Vec3 on = box.axes.transpose() * (at - box.centre);
        return Vec3(box.centre + box.axes * on.cwiseMax(-box.half).cwiseMin(box.half));
    };
    const Vec3 n = best.normal;
    if (first >= 0 && second >= 0) {
        const Vec3 u = a.half[first] * a.axes.col(first), v = b.half[second] * b.axes.col(second);
        const Vec3 from = corner(a, -n, first) - u, other = corner(b, n, second) - v;
        const ClosestShares at = closest_shares(from, 2 * u, other, 2 * v);
        best.point = 0.5 * (from + 2 * at.first * u + other + 2 * at.second * v);
    } else {
        best.point = first >= 0 ? into(a, corner(b, n, -1)) : into(b, corner(a, -n, -1));
    }
    return best;
}

} // namespace windlass::physics
