#pragma once
// How a driven end moves about its place in the starting shape. Everything starts at that place, at time 0.

#include "bench/problem/problem.hpp"

#include <array>

namespace windlass::lab {

using Motion = std::function<Vec3(double time)>;

/// amplitude sin(2 pi t / period + phase).
struct Harmonic {
    double amplitude = 0; ///< m
    double period = 1;    ///< s
    double phase = 0;     ///< rad
};

/// Grows from 0 to 1 within ramp (s) as (1 + sin(pi t / ramp - pi / 2)) / 2; 1 at once when ramp is 0.
double grown(double time, double ramp);

/// A harmonic along each axis. Without a ramp the phases must be 0: the end would jump.
Motion harmonic_motion(const Vec3& place, const std::array<Harmonic, 3>& axes, double ramp);

/// A vertical circle in the x-z plane about the place: x = r cos, z = -r sin when clockwise seen from -y.
Motion circle_motion(const Vec3& place, double radius, double period, bool clockwise, double ramp);

/// Through offsets (m) at times (s, rising, the first 0 with no offset), by cubic pieces with a continuous
/// velocity; after the last it stands still.
Motion table_motion(const Vec3& place, std::vector<double> times, std::vector<Vec3> offsets);

/// The same motion after the end has stood still for a while (s).
Motion delayed(Motion motion, double wait);

} // namespace windlass::lab
