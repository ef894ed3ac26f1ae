#pragma once
// How finely a step of the chain must be divided.

#include "server/physics/chain/chain.hpp"

namespace windlass::physics {

/// Into how many substeps.
struct Substeps {
    int count = 1;
    bool enough = true; ///< false: it asks for more than the most
};

/// Substeps that dt (s) needs, at most max, judged by the chain as it is now:
/// - transverse waves run at sqrt(T / mu) and must not get over more than half a link (stability needs less
///   than a whole one);
/// - no link may turn by more than half a radian, nor a node fall by more than a tenth of a link: the pull of
///   a link keeps its direction through a step.
Substeps chain_substeps(const ChainDef& def, const ChainState& state, double dt, int max);

} // namespace windlass::physics
