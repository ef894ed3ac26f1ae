#pragma once
// Lindahl's tank test as a problem, and what is read from it.

#include "bench/lab/method.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::lab {

/// Lindahl's tank test (domain figures: top tension at most 72.7 N, mean 26.45 N, 20.7 % of the time below 2
/// N; at rest 22.7 N).
inline Problem tank(bool driven) {
    constexpr double kLying = 20.56, kDepth = 3, kPeriod = 1.25, kSettling = 20;
    Problem problem;
    physics::ChainDef& def = problem.line;
    def.diameter = 0.0022;
    def.mass_per_metre = 0.0818;
    def.stiffness = 1e4;
    def.damping_time = 0;
    def.displacement = def.mass_per_metre / 7800;
    def.drag_normal = 2.5;
    def.drag_axial = 0.5;
    def.added_mass_normal = 0.01445 / (1000 * def.displacement);
    def.added_mass_axial = 0;
    def.contact_diameter = def.diameter;
    problem.environment.depth = kDepth;
    problem.environment.water_density = 1000;
    problem.environment.current_speed = 0;
    problem.environment.bed_friction = 0.3;
    problem.environment.bed_stiffness = 3e6;
    problem.length = 33;
    const Vec3 top(32.554, 0, 0.3), touchdown(kLying, 0, -kDepth);
    problem.start = [=](double s) {
        return s < kLying ? Vec3(s, 0, -kDepth)
                          : Vec3(touchdown + (top - touchdown) * ((s - kLying) / (33 - kLying)));
    };
    if (!driven) return problem;
    problem.upper.kind = EndKind::driven;
    problem.upper.motion = [=](double time) -> Vec3 {
        const double t = time - kSettling;
        if (t < 0) return top;
        const double turn = 2 * std::numbers::pi * t / kPeriod;
        const double grown =
            t < kPeriod ? (1 + std::sin(std::numbers::pi * t / kPeriod - 0.5 * std::numbers::pi)) / 2 : 1;
        return top + grown * 0.2 * Vec3(std::cos(turn), 0, -std::sin(turn));
    };
    return problem;
}

/// Tension of the top link while it is driven: N, N and percent of the time below 2 N.
struct TankFigures {
    double largest = 0, mean = 0, slack = 0;
};

/// Runs the driven tank test through 30 turns and reads the last 20: the first differ.
inline TankFigures measure_in_tank(Method& chain) {
    TankFigures figures;
    int counted = 0;
    while (chain.time() < 20 + 30 * 1.25) {
        chain.step();
        if (chain.time() < 20 + 10 * 1.25) continue;
        const double tension = chain.tension(chain.links() - 1);
        figures.largest = std::max(figures.largest, tension);
        figures.mean += tension;
        figures.slack += tension < 2 ? 100 : 0;
        ++counted;
    }
    figures.mean /= counted;
    figures.slack /= counted;
    return figures;
}

} // namespace windlass::lab
