#pragma once
// A chain alone, stepped: both halves of the solver's step at once, where nothing comes between them.

#include "server/physics/solver/chain_solver.hpp"

namespace windlass::rigs {

/// One step of dt (s) of a chain whose upper end is at hawse (m, world) at its end; tail, drive, ledger and
/// contacts as ChainSolver has them.
inline physics::ChainStepResult step_chain(physics::ChainSolver& solver, physics::ChainState& state,
                                           const physics::EnvironmentDef& environment, double dt,
                                           const physics::ChainTail& tail, physics::UpperEnd& drive,
                                           const physics::Vec3& hawse,
                                           physics::EnergyLedger* ledger = nullptr,
                                           physics::ContactSet* contacts = nullptr) {
    solver.predict(state, environment, dt, tail, drive, hawse);
    return solver.solve(state, environment, drive, ledger, contacts);
}

} // namespace windlass::rigs
