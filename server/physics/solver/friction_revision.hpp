#pragma once
// Friction of the seabed after an iteration of Newton's method: does each node slide as it was taken to?

#include "server/physics/solver/free_motion.hpp"

namespace windlass::physics {

/// Whether every node that the seabed bears slides, or sticks, as its friction was worked out for. placed: m,
/// where the nodes end the step.
bool friction_fits(const ChainState& state, const StepTime& time, const Field& placed,
                   const FreeMotion& motion);

/// Works out anew the friction of the nodes that do not, and with it where they would go and how they yield.
void revise_friction(const ChainState& state, const StepTime& time, const Field& placed, FreeMotion& motion);

/// Makes the friction of all nodes proportional to their speed, Coulomb's at that before the step: first
/// order, but it can push none of them on. For a step in which their sliding cannot be found, or is not
/// looked for.
void make_friction_proportional(const ChainState& state, const StepTime& time, FreeMotion& motion);

} // namespace windlass::physics
