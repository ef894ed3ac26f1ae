#pragma once
// How finely a step of the chain must be divided.

#include "server/physics/chain/chain.hpp"

namespace windlass::physics {

/// Substeps that dt (s) needs, at most most, judged by the chain as it is now:
/// - transverse waves run at sqrt(T / mu) and must not get over more than half a link (stability needs less
/// than a
///   whole one);
/// - no link may turn by more than half a radian, nor a node fall by more than a tenth of a link: the pull of
/// a
///   link keeps its direction through a step.
int chain_substeps(const ChainDef& def, const ChainState& state, double dt, int max);

} // namespace windlass::physics
