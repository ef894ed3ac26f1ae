#include "server/physics/tackle/chain_contacts.hpp"

#include "server/physics/anchor/anchor_contact.hpp"

namespace windlass::physics {

namespace {

constexpr int kNodeContacts = 1024;

/// A link in the midst of a heap touches some dozen others; each pair counts once.
constexpr int kPairsPerLink = 8;

} // namespace

ChainContacts::ChainContacts(int capacity, bool with_itself)
    : with_itself_(with_itself),
      set_(kNodeContacts, kPairsPerLink * capacity),
      self_(capacity),
      obstacle_(capacity) {}

ContactSet& ChainContacts::find(const ChainDef& def, const EnvironmentDef& environment,
                                const ChainState& chain, double dt, const Anchor* anchor,
                                const HullSurface* hull) {
    set_.clear();
    if (with_itself_) self_.find(def, chain, dt, set_);
    if (with_itself_ && anchor != nullptr)
        set_.drop(find_anchor_contacts(def, environment, chain, dt, *anchor, {}, set_.ties()));
    if (hull != nullptr && hull->mesh != nullptr)
        obstacle_.find(def, chain, dt, *hull->mesh, hull->motion, hull->material, set_);
    return set_;
}

} // namespace windlass::physics
