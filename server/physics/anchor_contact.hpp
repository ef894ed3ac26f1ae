#pragma once
// Chain against its own anchor: slack cable piles up on it and hangs over its arms instead of falling
// through.

#include "server/physics/anchor.hpp"
#include "server/physics/contact.hpp"

namespace windlass::physics {

/// Adds to set where a chain touches the boxes of its anchor, or is about to in a step of dt (s). The anchor
/// is where it was before the step. Links that leave the shackle do not count. A cable whose anchor nothing
/// is near costs one look at the middles of its links.
void find_anchor_contacts(const ChainDef& def, const ChainState& chain, double dt, const Anchor& anchor,
                          ContactSet& set);

} // namespace windlass::physics
