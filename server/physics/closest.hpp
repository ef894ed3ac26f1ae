#pragma once
// Closest points of segments and triangles: the projection on the line or plane, kept inside its ends.

#include "server/physics/environment.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace windlass::physics {

/// Shares (0..1) of two segments at which they come closest.
struct ClosestShares {
    double first = 0, second = 0;
};

/// Segments from a, along u, and from b, along v (m). Where they are parallel, the middle of the overlap's
/// first end; where one has no length, its start.
inline ClosestShares closest_shares(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v) {
    const Vec3 r = a - b;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), ur = u.dot(r), vr = v.dot(r);
    const auto inside = [](double share) { return std::clamp(share, 0.0, 1.0); };
    constexpr double kPoint = 1e-18; // m2
    if (uu < kPoint) return {0, vv < kPoint ? 0 : inside(vr / vv)};
    if (vv < kPoint) return {inside(-ur / uu), 0};
    const double across = uu * vv - uv * uv;
    const double first = across > 1e-12 * uu * vv ? inside((uv * vr - vv * ur) / across) : 0;
    const double second = (uv * first + vr) / vv;
    if (second < 0) return {inside(-ur / uu), 0};
    if (second > 1) return {inside((uv - ur) / uu), 1};
    return {first, second};
}

/// Where on a triangle a point comes closest.
struct OnTriangle {
    Vec3 point = Vec3::Zero(); ///< m
    int side = -1; ///< -1: inside; else the side from corner k to k + 1 (a corner: one of its sides)
};

inline OnTriangle closest_on_triangle(const std::array<Vec3, 3>& corner, const Vec3& normal, const Vec3& p) {
    OnTriangle best{p - normal.dot(p - corner[0]) * normal, -1};
    double least = 1e300;
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
        const Vec3 &a = corner[k], along = corner[(k + 1) % 3] - a;
        if (normal.dot(along.cross(p - a)) >= 0) continue; // on the inner hand of this side
        const double share = std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
        const Vec3 point = a + share * along;
        const double distance = (p - point).squaredNorm();
        if (inside || distance < least) best = {point, k}, least = distance;
        inside = false;
    }
    return best;
}

} // namespace windlass::physics
