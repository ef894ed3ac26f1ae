#pragma once
// A chain between a held top and an end that is fixed, free or carries a mass: the rig of the chain tests.

#include "rigs/chain_step.hpp"

namespace windlass::physics {

/// What the lower end of the chain is.
enum class Foot { fixed, hanging };

/// A chain under test. Starts straight between the two points. A hanging foot carries a mass (kg, a weight in
/// air) and the half link that node 0 stands for.
struct ChainRig {
    ChainDef def;
    EnvironmentDef environment;
    ChainState state;
    ChainSolver solver;
    LockedEnd locked;
    UpperEnd* drive = &locked;
    Vec3 hawse;
    double tail_mass = 0;   ///< kg
    double tail_weight = 0; ///< N, downwards
    EnergyLedger ledger;
    ChainStepResult last;

    ChainRig(const ChainDef& chain, const EnvironmentDef& sea, const Vec3& anchor, const Vec3& top,
             double length, Foot foot, double mass = 0)
        : def(chain),
          environment(sea),
          state(straight_chain(chain, anchor, top, length, 4096)),
          solver(chain, 4096),
          hawse(top) {
        if (foot == Foot::fixed) return;
        const double half_link = 0.5 * link_length(def, state, 0);
        tail_mass = mass + half_link * def.mass_per_metre;
        tail_weight = mass * kGravity + half_link * weight_in_water(def, environment.water_density);
    }

    ChainTail tail(double dt) const {
        ChainTail tail;
        if (tail_mass > 0) {
            tail.inverse_mass.xx = tail.inverse_mass.yy = tail.inverse_mass.zz = 1 / tail_mass;
            tail.velocity_before = state.velocity.at(0);
            tail.velocity = state.velocity.at(0) - Vec3(0, 0, step_kick(state, dt) * tail_weight / tail_mass);
        }
        return tail;
    }

    void step(double dt, ContactSet* contacts = nullptr) {
        last = rigs::step_chain(solver, state, environment, dt, tail(dt), *drive, hawse, &ledger, contacts);
    }

    void run(double seconds, double dt) {
        const int steps = static_cast<int>(std::lround(seconds / dt));
        for (int k = 0; k < steps; ++k)
            step(dt);
    }

    double top_tension() const { return state.tension[state.links - 1]; }
};

/// No water and no seabed within reach.
inline EnvironmentDef in_air() {
    EnvironmentDef environment;
    environment.water_density = 0;
    environment.depth = 1e6;
    environment.current_speed = 0;
    return environment;
}

/// Still water of the given depth, m.
inline EnvironmentDef still_water(double depth) {
    EnvironmentDef environment;
    environment.depth = depth;
    environment.current_speed = 0;
    environment.wind_speed = 0;
    return environment;
}

} // namespace windlass::physics
