#pragma once
// Lindahl's tank test as a problem, and what is read from it.

#include "bench/problem/method.hpp"
#include "tests/physics/solver/lindahl.hpp"

#include <algorithm>

namespace windlass::lab {

/// The tank test as every method gets it.
inline Problem tank(bool driven) {
    constexpr double kSettling = 20; // s
    Problem problem;
    problem.line = physics::lindahl::chain();
    problem.environment = physics::lindahl::tank();
    problem.length = physics::lindahl::kLength;
    problem.start = physics::lindahl::laid_out;
    if (!driven) return problem;
    problem.upper.kind = EndKind::driven;
    problem.upper.motion = [=](double time) { return physics::lindahl::top_at(time - kSettling); };
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
