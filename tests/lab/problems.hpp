#pragma once
// The problems that the tests put to the methods.

#include "bench/problem/method.hpp"

#include <stdexcept>
#include <string>

namespace windlass::lab {

/// The method of that name. Throws std::out_of_range when there is none.
inline const MethodEntry& method_named(const std::string& name) {
    for (const MethodEntry& entry : methods())
        if (entry.name == name) return entry;
    throw std::out_of_range("no method " + name);
}

/// 78 mm chain in air, no seabed within reach, no structural damping.
inline Problem chain_in_air(double length) {
    Problem problem;
    problem.line = physics::stud_link_chain(0.078, physics::Grade::k3, 330);
    problem.line.damping_time = 0;
    problem.environment.water_density = 0;
    problem.environment.depth = 1e6;
    problem.environment.current_speed = 0;
    problem.length = length;
    return problem;
}

/// Hanging at rest from the origin in elastic balance; a weight at its end if tail_mass (kg) is not 0.
inline Problem hanging_chain(double length, double tail_mass) {
    Problem problem = chain_in_air(length);
    problem.lower = {.kind = tail_mass > 0 ? EndKind::mass : EndKind::free,
                     .mass = tail_mass,
                     .weight = tail_mass * physics::kGravity,
                     .motion = {}};
    const double weight = problem.line.mass_per_metre * physics::kGravity;
    const double stiffness = problem.line.stiffness;
    problem.start = [=](double s) { // the stretch of what hangs below each point, summed from the top
        const double up = length - s;
        const double pull = tail_mass * physics::kGravity;
        return Vec3(0, 0, -up - (pull * up + weight * (length * up - 0.5 * up * up)) / stiffness);
    };
    return problem;
}

/// Released from horizontal with a weight of tail_mass (kg) at its end.
inline Problem swinging_chain(double length, double tail_mass) {
    Problem problem = hanging_chain(length, tail_mass);
    problem.start = [length](double s) { return Vec3(length - s, 0, 0); };
    return problem;
}

} // namespace windlass::lab
