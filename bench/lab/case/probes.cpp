#include "bench/lab/case/probes.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::lab {

std::string unit_of(Quantity quantity) {
    if (quantity == Quantity::tension) return "N";
    return quantity <= Quantity::z ? "m" : "J";
}

Meter::Meter(const Problem& problem, const Method& method)
    : problem_(problem), method_(method), def_(problem.line) {
    def_.node_spacing = problem.length / method.links();
    state_ = physics::straight_chain(def_, Vec3::Zero(), Vec3::UnitX(), problem.length, method.links());
}

double Meter::read(const Probe& probe) {
    const double spacing = def_.node_spacing;
    const double arc = probe.node ? *probe.node * spacing : probe.arc.value_or(0);
    switch (probe.quantity) {
    case Quantity::tension:
        return tension(arc);
    case Quantity::x:
        return place(arc).x();
    case Quantity::y:
        return place(arc).y();
    case Quantity::z:
        return place(arc).z();
    case Quantity::kinetic_energy:
        return energy().kinetic;
    case Quantity::potential_energy:
        return energy().potential;
    case Quantity::elastic_energy:
        return energy().elastic;
    case Quantity::total_energy:
        return energy().total();
    }
    return 0;
}

double Meter::tension(double arc) const {
    const int last = method_.links() - 1;
    const double middle = std::clamp(arc / def_.node_spacing - 0.5, 0.0, double(last));
    const int below = std::min(static_cast<int>(middle), std::max(0, last - 1));
    const int above = std::min(below + 1, last);
    const double share = middle - below;
    return (1 - share) * method_.tension(below) + share * method_.tension(above);
}

Vec3 Meter::place(double arc) const {
    const double along = std::clamp(arc / def_.node_spacing, 0.0, double(method_.links()));
    const int below = std::min(static_cast<int>(along), method_.links() - 1);
    const double share = along - below;
    return (1 - share) * method_.position(below) + share * method_.position(below + 1);
}

physics::ChainEnergy Meter::energy() {
    const int n = method_.links();
    for (int i = 0; i <= n; ++i) {
        state_.position.set(i, method_.position(i));
        state_.velocity.set(i, method_.velocity(i));
    }
    physics::ChainEnergy energy = physics::chain_energy(def_, problem_.environment, state_);
    // The ends: half a link and what hangs on it. A held end does not count: what moves it gives it its
    // energy.
    const auto add_end = [&](const End& end, int node) {
        if (end.kind != EndKind::mass && end.kind != EndKind::free) return;
        const double half = 0.5 * def_.node_spacing;
        const double z = state_.position.z[node];
        const double mass = end.mass + half * def_.mass_per_metre;
        const double wet = z < 0 ? problem_.environment.water_density * def_.displacement : 0;
        energy.kinetic += 0.5 * mass * state_.velocity.at(node).squaredNorm();
        energy.potential += (end.weight + half * (def_.mass_per_metre - wet) * physics::kGravity) * z;
    };
    add_end(problem_.lower, 0);
    add_end(problem_.upper, n);
    return energy;
}

} // namespace windlass::lab
