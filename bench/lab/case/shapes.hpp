#pragma once
// Starting shapes: where the point at an unstretched length (m, from the lower end) lies.

#include "bench/problem/problem.hpp"

namespace windlass::lab {

using Shape = std::function<Vec3(double arc)>;

/// Straight between two points, stretched or slack as their distance has it.
Shape straight_shape(const Vec3& lower, const Vec3& upper, double length);

/// Straight down from the upper end, at rest: stretched by the weight (N/m) of the line below each point and
/// by a pull (N) at its lower end.
Shape hanging_shape(const Vec3& upper, double length, double weight, double stiffness, double pull);

/// Two straight legs without slack, from the lower end to a bight in the given direction and back to the
/// upper end. Throws std::invalid_argument when the line is too short to reach.
Shape folded_shape(const Vec3& lower, const Vec3& upper, double length, const Vec3& direction);

/// What the elastic catenary needs: weight in N/m, stiffness (EA) in N.
struct CatenaryLine {
    double length = 0, weight = 0, stiffness = 0;
};

/// The elastic catenary (Irvine 1981) between two points, the upper one not below the lower one. On the bed
/// the line leaves the lower end lying, without friction. Throws std::invalid_argument when the line cannot
/// hang so: too long for a line that lies on the bed, or weightless.
Shape catenary_shape(const Vec3& lower, const Vec3& upper, const CatenaryLine& line, bool on_bed);

/// Through points in order, the unstretched length shared out by the distances between them.
Shape points_shape(std::vector<Vec3> points, double length);

} // namespace windlass::lab
