#pragma once
// Where the energy of a step of the chain went.

#include "server/physics/chain/chain.hpp"
#include "server/physics/contact/link_wrap.hpp"
#include "server/physics/solver/free_motion.hpp"

namespace windlass::physics {

/// A step as the solver found it.
struct ChainStepTaken {
    const Field& placed;               ///< m, the nodes at its end
    const Field& direction;            ///< along which each link pulled
    const std::vector<double>& pull;   ///< N, mean, of each link
    const std::vector<double>& length; ///< m, of each link at its start
    double dt = 0, kick = 0;           ///< s
    double travel = 0;                 ///< m paid out
    double feed_speed = 0;             ///< m/s, mean at the top, paying out
    double deck_length = 0;            ///< m, see UpperEnd
    Vec3 foot_velocity = Vec3::Zero(); ///< m/s, of the lowest node before the step
    const LinkWraps* wraps = nullptr;  ///< links round edges; null: none
    const FrictionField& friction;     ///< of the seabed on the nodes that it bears
};

/// Books what the step turned into heat or gave away: each force times the mean of the speeds before and
/// after, which is what it takes from leapfrog's kinetic energy. state: as at the start of the step.
void balance_chain(const ChainDef& def, const EnvironmentDef& environment, const ChainState& state,
                   const ChainStepTaken& step, EnergyLedger& ledger);

} // namespace windlass::physics
