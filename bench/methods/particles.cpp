#include "bench/methods/particles.hpp"

// The arrays do not overlap.
#define WINDLASS_VECTORISE _Pragma("GCC ivdep")

namespace windlass::lab {

using namespace physics;

namespace {

Problem with_spacing(Problem problem, int links) {
    if (links > 0) problem.line.node_spacing = problem.length / links;
    return problem;
}

} // namespace

Particles::Particles(const Problem& problem, int links, double step, SeabedBy seabed)
    : line(with_spacing(problem, links), links, step),
      dt(step),
      wet(line.in_water() || (seabed == SeabedBy::prediction && line.bed_in_reach())),
      target(line.nodes()),
      inverse_mass(line.nodes()),
      inverse_matrix(line.nodes()),
      seabed_(seabed) {
    line.start(position, velocity);
    for (int i = line.first; i <= line.last; ++i)
        inverse_mass[i] = 1 / (line.mass[i] + line.end_mass[i]);
}

void Particles::predict() {
    if (wet) {
        predict_in_water();
    } else {
        predict_in_air();
    }
    hold(line.problem.lower, 0);
    hold(line.problem.upper, line.links);
}

void Particles::hold(const End& end, int node) {
    if (end.kind == EndKind::fixed) target.set(node, position.at(node));
    if (end.kind == EndKind::driven) target.set(node, end.motion(static_cast<double>(steps + 1) * dt));
}

void Particles::predict_in_air() {
    const auto drift = [this](double* p, const double* x, const double* v, double fall) {
        const int n = nodes();
        WINDLASS_VECTORISE
        for (int i = 0; i < n; ++i)
            p[i] = x[i] + dt * v[i] - fall;
    };
    drift(target.x.data(), position.x.data(), velocity.x.data(), 0);
    drift(target.y.data(), position.y.data(), velocity.y.data(), 0);
    drift(target.z.data(), position.z.data(), velocity.z.data(), dt * dt * kGravity);
    for (const int i : {0, line.links}) // the weight of what hangs there need not be its mass times g
        target.z[i] -= dt * dt * inverse_mass[i] * (line.end_weight[i] - line.end_mass[i] * kGravity);
}

void Particles::predict_in_water() {
    const ChainDef& def = line.problem.line;
    const EnvironmentDef& sea = line.problem.environment;
    const double h = dt, length = line.rest;
    const Vec3 current = line.current;
    const int n = line.links;
    WINDLASS_VECTORISE
    for (int i = 1; i < n; ++i) {
        const Vec3 v = velocity.at(i), at = position.at(i);
        const NodeMedium m = node_medium(def, sea, position.at(i - 1), at, position.at(i + 1), length);
        const NodeDamping damping = water_damping(def, sea, m, v, current);
        const SymmetricMatrix w = inverse_mass_afloat(m, damping, h);
        inverse_mass[i] = 1 / m.mass_normal;
        inverse_matrix.set(i, w);
        target.set(i, at + h * (w * free_momentum(def, sea, m, damping, v, h)));
    }
    predict_node(0);
    predict_node(n);
    if (seabed_ == SeabedBy::method) return;
    for (int i = 1; i < n; ++i)
        if (position.z[i] < -sea.depth) predict_node(i);
}

/// Any node, with what hangs on it and the seabed under it.
void Particles::predict_node(int i) {
    if (i < line.first || i > line.last) return;
    const ChainDef& def = line.problem.line;
    const EnvironmentDef& sea = line.problem.environment;
    const Vec3 v = velocity.at(i), at = position.at(i);
    NodeMedium m = node_medium(def, sea, position.at(std::max(i - 1, 0)), at,
                               position.at(std::min(i + 1, line.links)), line.length[i]);
    m.mass_normal += line.end_mass[i];
    m.mass_axial += line.end_mass[i];
    const LevelBed bed = level_bed(sea);
    const bool borne = seabed_ == SeabedBy::prediction && bed_share(bed, m, v) > 0;
    const NodeDamping damping =
        borne ? node_damping(def, sea, bed, m, v, line.current) : water_damping(def, sea, m, v, line.current);
    Vec3 momentum = free_momentum(def, sea, m, damping, v, dt);
    momentum.z() += dt * ((borne ? bed_push(m, damping, v.z(), dt) : 0) - line.end_weight[i]);
    const SymmetricMatrix w = borne ? inverse_mass_on_bed(bed, m, damping, bed_hold(damping, dt), dt)
                                    : inverse_mass_afloat(m, damping, dt);
    inverse_mass[i] = 1 / m.mass_normal;
    inverse_matrix.set(i, w);
    target.set(i, at + dt * (w * momentum));
}

void Particles::accept() {
    const auto one = [this](double* x, double* v, const double* p) {
        const double rate = 1 / dt;
        const int n = nodes();
        WINDLASS_VECTORISE
        for (int i = 0; i < n; ++i) {
            v[i] = (p[i] - x[i]) * rate;
            x[i] = p[i];
        }
    };
    one(position.x.data(), velocity.x.data(), target.x.data());
    one(position.y.data(), velocity.y.data(), target.y.data());
    one(position.z.data(), velocity.z.data(), target.z.data());
    ++steps;
}

} // namespace windlass::lab
