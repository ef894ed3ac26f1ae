#pragma once
// How sharply chain folds: links turn about each other only until their bars touch, so that slack chain keeps
// its room and never collapses to a point.

#include "server/physics/contact/contact.hpp"

namespace windlass::physics {

/// Least distance, m, between two points of a chain that are the given length (m) apart along it: an arc of
/// the least radius, and beyond half a turn its diameter.
double min_distance(const ChainDef& def, double along);

/// Adds to set where a link, or two links in a row, is folded as far as the chain allows or about to be.
void find_bend_limits(const ChainDef& def, const ChainState& chain, double dt, ContactSet& set);

/// The same of the links at the lip alone.
void find_bend_limits_at_top(const ChainDef& def, const ChainState& chain, double dt, ContactSet& set);

/// By so much (m) links and pairs of links are longer than the least, all but those at the lip, whose length
/// changes.
double bend_room(const ChainDef& def, const ChainState& chain);

} // namespace windlass::physics
