#pragma once
// What a step is given: its size, and the lower end that the chain meets in it.

#include "server/physics/base/symmetric_matrix.hpp"

namespace windlass::physics {

/// A step's size and the time for which forces act on velocities, s; see step_kick().
struct StepTime {
    double dt = 0, kick = 0;
};

/// The lower end as the chain meets it in one step: a point with an inverse mass, moving freely unless
/// pulled.
struct ChainTail {
    SymmetricMatrix inverse_mass;        ///< 1/kg, of the point; zero for a fixed end
    Vec3 velocity = Vec3::Zero();        ///< m/s, after the step if the chain did not pull
    Vec3 velocity_before = Vec3::Zero(); ///< m/s, before it; for the energy balance
};

} // namespace windlass::physics
