#include "bench/lab/stability/stability.hpp"

#include "bench/lab/case/processor_time.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::lab {
namespace {

constexpr int kEnergyRate = 120;       // 1/s
constexpr double kAstray = 100;        // lengths of the line: no need to look further
constexpr double kSpeedSample = 0.001; // s

bool held(const End& end) {
    return end.kind == EndKind::fixed || end.kind == EndKind::driven;
}

/// Sums over the nodes of a line: half a link at each end, with what hangs on it. f(arc, kg, N).
template <typename F>
void each_mass(const Problem& problem, int links, const F& f) {
    const double rest = problem.length / links;
    const double weight = physics::weight_in_water(problem.line, problem.environment.water_density);
    for (int i = 0; i <= links; ++i) {
        const double length = i == 0 || i == links ? 0.5 * rest : rest;
        const End* end = i == 0 ? &problem.lower : i == links ? &problem.upper : nullptr;
        const bool loaded = end != nullptr && end->kind == EndKind::mass;
        f(i * rest, problem.line.mass_per_metre * length + (loaded ? end->mass : 0),
          weight * length + (loaded ? end->weight : 0));
    }
}

/// The held end from which a line hangs, and how far a point of it is down from there.
struct Hanging {
    const Problem& problem;
    bool from_upper = held(problem.upper);

    Vec3 top(double time) const {
        const End& end = from_upper ? problem.upper : problem.lower;
        return end.kind == EndKind::driven ? end.motion(time)
                                           : problem.start(from_upper ? problem.length : 0);
    }
    double height(double arc, double time) const {
        const double down = from_upper ? problem.length - arc : arc;
        return std::max(top(time).z() - down, -problem.environment.depth);
    }
};

/// J: potential energy of the line that hangs straight down, unstretched, or lies on the bed.
double lowest(const Problem& problem, int links, double time) {
    const Hanging hanging{problem};
    double sum = 0;
    each_mass(problem, links,
              [&](double arc, double, double weight) { sum += weight * hanging.height(arc, time); });
    return sum;
}

double largest_speed(const End& end, double duration) {
    if (end.kind != EndKind::driven) return 0;
    double speed = 0;
    for (double t = 0; t < duration; t += kSpeedSample)
        speed = std::max(speed, (end.motion(t + kSpeedSample) - end.motion(t)).norm() / kSpeedSample);
    return speed;
}

/// Largest strain of any link; not a number where a place or a tension is none.
double largest_strain(const Method& method, double rest) {
    double longest = 0, sum = 0;
    Vec3 below = method.position(0);
    for (int i = 0; i < method.links(); ++i) {
        const Vec3 above = method.position(i + 1);
        const double size = (above - below).norm();
        longest = std::max(longest, size);
        sum += size + method.tension(i);
        below = above;
    }
    return std::isfinite(sum) ? longest / rest - 1 : sum - sum;
}

} // namespace

double energy_at_play(const Problem& problem, int links) {
    double start = 0, mass = 0, weight = 0;
    each_mass(problem, links, [&](double arc, double m, double w) {
        start += w * problem.start(arc).z();
        mass += m, weight += w;
    });
    const double speed = std::max(largest_speed(problem.lower, problem.duration),
                                  largest_speed(problem.upper, problem.duration));
    return start - lowest(problem, links, 0) + 0.5 * mass * speed * speed +
           0.5 * weight * weight * problem.length / problem.line.stiffness;
}

Verdict judge(const Case& given, const MethodEntry& entry, int links, int rate, const FaultLimits& limits) {
    const Problem& problem = given.problem;
    const double at_play = energy_at_play(problem, links), rest = problem.length / links;
    const double max_strain =
        std::max(limits.strain, limits.strain_of_energy *
                                    std::sqrt(2 * at_play / (problem.line.stiffness * problem.length)));
    const long steps = std::max(1L, std::lround(problem.duration * rate));
    const long stride = std::max(1, rate / kEnergyRate);
    Verdict verdict{.when = double(steps) / rate};
    std::unique_ptr<Method> method;
    try {
        method = make_method(entry, problem, links, 1.0 / rate, given.settings);
    } catch (const std::invalid_argument& error) {
        return {.fate = Fate::cannot, .when = 0, .why = error.what()};
    }
    Meter meter(problem, *method);
    const Probe energy{"energy", Quantity::total_energy, {}, {}};
    const auto fault = [&](Fate fate, long step) {
        if (verdict.fate == Fate::bounded) verdict.when = double(step) / rate;
        if (fate > verdict.fate) verdict.fate = fate;
    };
    const double began = processor_seconds();
    double spent = 0;
    long step = 0;
    while (step < steps && verdict.fate != Fate::not_a_number) {
        const double before = processor_seconds();
        method->step();
        const double after = processor_seconds();
        spent += after - before;
        ++step;
        const double strain = largest_strain(*method, rest);
        if (!std::isfinite(strain)) {
            fault(Fate::not_a_number, step);
            break;
        }
        verdict.strain = std::max(verdict.strain, strain);
        if (strain > max_strain) fault(Fate::stretched, step);
        if (strain > kAstray * links) break;
        if (step % stride == 0) {
            const double above = (meter.read(energy) - lowest(problem, links, double(step) / rate)) / at_play;
            verdict.energy = std::max(verdict.energy, above);
            if (above > 1 + limits.energy) fault(Fate::grew, step);
        }
        if (step >= 10 && (after - began) / double(step) * double(steps) > limits.max_seconds) {
            if (verdict.fate == Fate::bounded)
                verdict = {Fate::too_long, double(step) / rate, verdict.strain, verdict.energy};
            break;
        }
    }
    if (verdict.fate == Fate::bounded && method->unsolved() > 0) verdict.fate = Fate::unsolved;
    verdict.cost = 1000 * spent * rate / double(step);
    return verdict;
}

} // namespace windlass::lab
