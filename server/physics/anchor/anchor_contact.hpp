#pragma once
// Chain against its own anchor: slack cable piles up on it and hangs over its arms instead of falling
// through.

#include "server/physics/anchor/anchor.hpp"
#include "server/physics/contact/contact.hpp"

namespace windlass::physics {

/// The cable that may touch an anchor, and the anchor, as places among those that a step is taken with.
struct AnchorTouch {
    int cable = 0, anchor = 0;
    bool own() const { return cable == anchor; } ///< its links that leave the shackle do not count
};

/// Adds to ties where a chain touches the boxes of an anchor, or is about to in a step of dt (s). The anchor
/// is where it was before the step. Costs one look at the middles of the links while the anchor is far. A
/// link that lies on the bed has its middle half a width above it, and so meets an anchor's side and does not
/// go under it. Returns how many contacts there was no place for.
int find_anchor_contacts(const ChainDef& def, const EnvironmentDef& environment, const ChainState& chain,
                         double dt, const Anchor& anchor, const AnchorTouch& touch, PairContacts& ties);

} // namespace windlass::physics
