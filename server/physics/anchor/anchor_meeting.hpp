#pragma once
// Anchor against anchor: swung together, let go on each other or hove up foul, they bear on each other.

#include "server/physics/anchor/anchor.hpp"
#include "server/physics/contact/pair_contacts.hpp"

namespace windlass::physics {

/// Whether any point of one may be nearer to any of the other than the given distance (m).
bool anchors_near(const Anchor& a, const Anchor& b, double distance);

/// Adds to ties where boxes of one anchor touch boxes of the other, or are about to in a step of dt (s): a is
/// the anchor of the first of the cables that the step is taken with, b that of the second. Flukes give way
/// on their pin unless they are pressed on their stop or the bed. Costs one look while the anchors are apart.
void find_anchor_meetings(const EnvironmentDef& environment, const Anchor& a, const Anchor& b, double dt,
                          PairContacts& ties);

} // namespace windlass::physics
