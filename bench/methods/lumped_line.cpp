#include "bench/methods/lumped_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::lab {

namespace {

void check_end(const End& end, const char* name) {
    if (end.kind == EndKind::driven && !end.motion)
        throw std::invalid_argument(std::string(name) + " end is driven, but has no motion");
    if (end.kind == EndKind::mass && end.mass <= 0)
        throw std::invalid_argument(std::string(name) + " end carries a mass, which must be more than 0 kg");
}

/// Velocity of a motion that is known only by its places, m/s: central difference, one-sided at the start.
Vec3 speed_of(const End& end, double time) {
    constexpr double kSmall = 1e-5; // s
    const double before = std::max(0.0, time - kSmall), after = time + kSmall;
    return (end.motion(after) - end.motion(before)) / (after - before);
}

} // namespace

void check_problem(const Problem& problem, double dt) {
    if (problem.length <= 0) throw std::invalid_argument("a line needs a length of more than 0 m");
    if (dt <= 0) throw std::invalid_argument("a step must be longer than 0 s");
    if (!problem.start) throw std::invalid_argument("a line needs a starting shape");
    check_end(problem.lower, "lower");
    check_end(problem.upper, "upper");
}

LumpedLine::LumpedLine(const Problem& given, int number, double dt) : problem(given), links(number) {
    check_problem(problem, dt);
    if (links < 2) throw std::invalid_argument("a line needs 2 links or more");
    const physics::ChainDef& def = problem.line;
    const physics::EnvironmentDef& sea = problem.environment;
    rest = problem.length / links;
    spring = def.stiffness / rest;
    damper = spring * def.damping_time;
    first = held(problem.lower) ? 1 : 0;
    last = held(problem.upper) ? links - 1 : links;
    current = physics::compass(sea.current_towards) * sea.current_speed;

    length.assign(nodes(), rest);
    length.front() = length.back() = 0.5 * rest;
    for (const double h : length) {
        mass.push_back(def.mass_per_metre * h);
        displaced.push_back(sea.water_density * def.displacement * h);
        bed_spring.push_back(sea.bed_stiffness * def.contact_diameter * h);
    }
    end_mass.assign(nodes(), 0);
    end_weight.assign(nodes(), 0);
    const auto attach = [this](const End& end, int node) {
        if (end.kind == EndKind::mass) end_mass[node] = end.mass, end_weight[node] = end.weight;
    };
    attach(problem.lower, 0);
    attach(problem.upper, links);
}

bool LumpedLine::bed_in_reach() const {
    constexpr double kStretched = 1.1; // more than any chain bears
    const auto lowest = [this](const End& end, double arc) {
        return end.kind == EndKind::fixed ? problem.start(arc).z() - kStretched * problem.length : -1e5;
    };
    return std::max(lowest(problem.lower, 0), lowest(problem.upper, problem.length)) <
           -problem.environment.depth;
}

void LumpedLine::start(Field& position, Field& velocity) const {
    position = velocity = Field(nodes());
    for (int i = 0; i < nodes(); ++i)
        position.set(i, problem.start(i == links ? problem.length : i * rest));
    hold(0, position, velocity);
}

void LumpedLine::hold(double time, Field& position, Field& velocity) const {
    const auto drive = [&](const End& end, int node) {
        if (end.kind != EndKind::driven) return;
        position.set(node, end.motion(time));
        velocity.set(node, speed_of(end, time));
    };
    drive(problem.lower, 0);
    drive(problem.upper, links);
}

double LumpedLine::min_mass() const {
    return problem.line.mass_per_metre * rest;
}

double LumpedLine::bed_frequency() const {
    return std::sqrt(problem.environment.bed_stiffness * problem.line.contact_diameter /
                     problem.line.mass_per_metre);
}

} // namespace windlass::lab
