#pragma once
// How a cable is marked so that its length can be told on deck: the joining shackle between two lengths is
// painted red, and so many links on either side of it white, wound with seizing wire, as it is the number of
// the shackle; the last lengths before the bitter end have a warning colour.

#include "server/physics/chain/chain.hpp"

namespace windlass::physics {

/// The joining shackle at the end of the n-th length from the anchor.
struct ShackleMark {
    int shackle = 0;        ///< n, from 1
    double from_anchor = 0; ///< m of cable
    int white_links = 0;    ///< on either side of it: n, and from the sixth on 1, 2 ... again
    bool last = false;      ///< the length that begins here is painted in the warning colour
};

/// How many joining shackles a cable has: between its lengths, not at its ends.
int joining_shackles(const ChainDef& def);

/// The n-th of them, n from 1.
ShackleMark shackle_mark(const ChainDef& def, int n);

/// Where the last joining shackle is that so many metres of cable reach, or the first when none; m from the
/// anchor shackle.
double joining_shackle_within(const ChainDef& def, double length);

/// Where the cable is at a length (m) from the anchor shackle, m, world; the lip for what is inboard.
Vec3 point_of_cable(const ChainDef& def, const ChainState& state, double from_anchor);

} // namespace windlass::physics
