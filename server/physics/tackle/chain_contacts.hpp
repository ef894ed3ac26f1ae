#pragma once
// All that one cable touches in a step: itself, its anchor, the hull.

#include "server/physics/anchor/anchor.hpp"
#include "server/physics/contact/chain_self_contact.hpp"
#include "server/physics/ship/hull_surface.hpp"

namespace windlass::physics {

/// Finds and keeps the contacts of a cable. No memory is taken after the constructor.
class ChainContacts {
public:
    /// capacity: most links; with_itself: whether the chain feels itself.
    ChainContacts(int capacity, bool with_itself);

    /// The contacts of a step of dt (s); anchor, hull: may be null. The anchor is where it was before the
    /// step.
    ContactSet& find(const ChainDef& def, const EnvironmentDef& environment, const ChainState& chain,
                     double dt, const Anchor* anchor, const HullSurface* hull);

private:
    bool with_itself_;
    ContactSet set_;
    SelfContacts self_;
    ObstacleContacts obstacle_;
};

} // namespace windlass::physics
