#pragma once
// A chain alone, stepped: both halves of the solver's step at once, where nothing comes between them.

#include "server/physics/solver/chain_solver.hpp"

namespace windlass::physics {

/// One step of dt (s) of a chain whose upper end is at hawse (m, world) at its end; tail, drive, ledger and
/// contacts as ChainSolver has them.
inline ChainStepResult step_chain(ChainSolver& solver, ChainState& state, const EnvironmentDef& environment,
                                  double dt, const ChainTail& tail, UpperEnd& drive, const Vec3& hawse,
                                  EnergyLedger* ledger = nullptr, ContactSet* contacts = nullptr) {
    solver.predict(state, environment, dt, tail, drive, hawse);
    return solver.solve(state, environment, drive, ledger, contacts);
}

} // namespace windlass::physics
