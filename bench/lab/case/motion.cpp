#include "bench/lab/case/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::lab {

using std::numbers::pi;

double grown(double time, double ramp) {
    return time < ramp ? 0.5 * (1 + std::sin(pi * time / ramp - 0.5 * pi)) : 1;
}

Motion harmonic_motion(const Vec3& place, const std::array<Harmonic, 3>& axes, double ramp) {
    return [=](double t) {
        Vec3 offset;
        for (int k = 0; k < 3; ++k)
            offset[k] = axes[k].amplitude * std::sin(2 * pi * t / axes[k].period + axes[k].phase);
        return Vec3(place + grown(t, ramp) * offset);
    };
}

Motion circle_motion(const Vec3& place, double radius, double period, bool clockwise, double ramp) {
    return [=](double t) {
        const double turn = 2 * pi * t / period;
        const double up = clockwise ? -std::sin(turn) : std::sin(turn);
        return Vec3(place + grown(t, ramp) * radius * Vec3(std::cos(turn), 0, up));
    };
}

Motion table_motion(const Vec3& place, std::vector<double> times, std::vector<Vec3> offsets) {
    // Slopes at the points: central differences, and at rest at both ends (Hermite's cubic).
    const std::size_t n = times.size();
    std::vector<Vec3> slopes(n, Vec3::Zero());
    for (std::size_t i = 1; i + 1 < n; ++i)
        slopes[i] = (offsets[i + 1] - offsets[i - 1]) / (times[i + 1] - times[i - 1]);
    return [=](double t) -> Vec3 {
        if (t <= times.front()) return place + offsets.front();
        if (t >= times.back()) return place + offsets.back();
        const std::size_t i = std::upper_bound(times.begin(), times.end(), t) - times.begin() - 1;
        const double h = times[i + 1] - times[i], u = (t - times[i]) / h, u2 = u * u, u3 = u2 * u;
        return place + (2 * u3 - 3 * u2 + 1) * offsets[i] + (u3 - 2 * u2 + u) * h * slopes[i] +
               (3 * u2 - 2 * u3) * offsets[i + 1] + (u3 - u2) * h * slopes[i + 1];
    };
}

Motion delayed(Motion motion, double wait) {
    return [motion = std::move(motion), wait](double t) { return motion(std::max(0.0, t - wait)); };
}

} // namespace windlass::lab
