#pragma once
// Closest points of segments, triangles and boxes.

#include "server/physics/base/vec3.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

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

/// The same of a segment and the whole of the line along v: the second share may be below 0 or beyond 1.
inline ClosestShares closest_to_line(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v) {
    const Vec3 r = a - b;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), ur = u.dot(r), vr = v.dot(r);
    const double across = uu * vv - uv * uv;
    const double first = across > 1e-12 * uu * vv ? std::clamp((uv * vr - vv * ur) / across, 0.0, 1.0) : 0;
    return {first, (uv * first + vr) / vv};
}

/// Where on a triangle a point comes closest.
struct OnTriangle {
    Vec3 point = Vec3::Zero(); ///< m
    int side = -1; ///< -1: inside; else the side from corner k to k + 1 (a corner: one of its sides)
};

inline OnTriangle closest_on_triangle(const std::array<Vec3, 3>& corner, const Vec3& normal, const Vec3& p) {
    OnTriangle best{p - normal.dot(p - corner[0]) * normal, -1};
    double min = 1e300;
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
        const Vec3 &a = corner[k], along = corner[(k + 1) % 3] - a;
        if (normal.dot(along.cross(p - a)) >= 0) continue; // on the inner hand of this side
        const double share = std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
        const Vec3 point = a + share * along;
        const double distance = (p - point).squaredNorm();
        if (inside || distance < min) best = {point, k}, min = distance;
        inside = false;
    }
    return best;
}

/// Where a segment and a box come closest.
struct OnBox {
    double share = 0;           ///< 0..1, of the segment
    Vec3 point = Vec3::Zero();  ///< m, on the box
    Vec3 normal = Vec3::Zero(); ///< unit vector out of the box
    double distance = 0;        ///< m; negative: the segment runs through it, so deep below the nearest face
};

/// Segment from a, along u (m), and a box round the origin with faces across the axes, half (m) long. What is
/// sought has a derivative that grows in straight pieces: Newton's method kept between bounds. A segment that
/// runs through the box leaves it by the face nearest to the middle of what is inside.
inline OnBox closest_on_box(const Vec3& a, const Vec3& u, const Vec3& half) {
    const auto outside = [&](double t) { // from the box to the point at t
        const Vec3 p = a + t * u;
        return Vec3(p - p.cwiseMax(-half).cwiseMin(half));
    };
    const auto slope = [&](double t) { return outside(t).dot(u); };
    double low = 0, high = 1, t = 0;
    if (slope(0) < 0) {
        t = 1;
        if (slope(1) > 0) {
            t = 0.5;
            for (int k = 0; k < 40 && high - low > 1e-12; ++k) {
                const Vec3 out = outside(t);
                const double g = out.dot(u);
                (g > 0 ? high : low) = t;
                const double curvature = (out.array() != 0).select(u.array().square(), 0).sum();
                const double next = curvature > 0 ? t - g / curvature : low;
                if (g == 0 || std::abs(next - t) < 1e-12) break;
                t = next > low && next < high ? next : 0.5 * (low + high);
            }
        }
    }
    const Vec3 out = outside(t);
    const double distance = out.norm();
    if (distance > 1e-9) {
        const Vec3 point = a + t * u - out;
        return {t, point, out / distance, distance};
    }
    double enters = 0, leaves = 1;
    for (int k = 0; k < 3; ++k) {
        if (std::abs(u[k]) < 1e-12) continue;
        const double one = (-half[k] - a[k]) / u[k], other = (half[k] - a[k]) / u[k];
        enters = std::max(enters, std::min(one, other));
        leaves = std::min(leaves, std::max(one, other));
    }
    const double middle = std::clamp(0.5 * (enters + leaves), 0.0, 1.0);
    Vec3 point = a + middle * u, normal = Vec3::Zero();
    int face = 0;
    (half - point.cwiseAbs()).minCoeff(&face);
    normal[face] = point[face] < 0 ? -1 : 1;
    const double deep = half[face] - std::abs(point[face]);
    point[face] = normal[face] * half[face];
    return {middle, point, normal, -std::max(0.0, deep)};
}

/// Where such a segment bears on the box: not at the one point that comes closest, which of a segment along a
/// face jumps from end to end, but in the middle of all that are at most so much farther (spread, m), each
/// with the weight of what it is nearer than that. It goes continuously with the segment. One that runs
/// through the box is as above, and so is one that stays farther off than it matters (m).
inline OnBox bearing_on_box(const Vec3& a, const Vec3& u, const Vec3& half, double spread,
                            double matters = 1e300) {
    const OnBox nearest = closest_on_box(a, u, half);
    if (nearest.distance <= 0 || nearest.distance > matters) return nearest;
    const auto outside = [&](double t) { // from the box to the point at t
        const Vec3 p = a + t * u;
        return Vec3(p - p.cwiseMax(-half).cwiseMin(half));
    };
    const double far = nearest.distance + spread;
    // Distance grows from the nearest point on, to either side.
    const auto end = [&](double t) {
        constexpr int kHalvings = 20;
        if (outside(t).squaredNorm() <= far * far) return t;
        double within = nearest.share;
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = 0.5 * (within + t);
            (outside(middle).squaredNorm() <= far * far ? within : t) = middle;
        }
        return within;
    };
    const double first = end(0), last = end(1);
    constexpr int kPoints = 5;
    double weights = 0, moment = 0;
    for (int k = 0; k < kPoints; ++k) {
        const double t = first + (k + 0.5) / kPoints * (last - first);
        const double weight = std::max(0.0, far - outside(t).norm());
        weights += weight, moment += weight * t;
    }
    if (!(weights > 0)) return nearest; // no length
    const double share = moment / weights;
    const Vec3 out = outside(share);
    const double distance = out.norm();
    return {share, a + share * u - out, out / distance, distance};
}

} // namespace windlass::physics
