#pragma once
// Veering and heaving: nodes come and go at the hawse pipe lip.

#include "server/physics/chain/chain.hpp"

namespace windlass::physics {

/// Keeps the top link between half and one and a half of the node spacing; the last link of a bare end may
/// become shorter. A new node is laid on the arc that its neighbours suggest, with its share of speed and
/// tension, and a node taken away leaves the tension of the link that closes the gap: so the load at the
/// gypsy does not notice. feed_speed: m/s at which chain leaves the lip, paying out positive; deck_length: as
/// UpperEnd::deck_length(). Returns false when the chain is full.
bool feed_chain(const ChainDef& def, ChainState& state, double feed_speed, double deck_length);

} // namespace windlass::physics
