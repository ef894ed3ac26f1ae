#pragma once
// What loads do to a cable for good: it stretches beyond the proof load and parts at the breaking load of its
// weakest link.

#include "server/physics/chain.hpp"

namespace windlass::physics {

/// What a cable has been through.
struct ChainStrain {
    double worst = 0;     ///< N, largest tension of any link so far
    double stretch = 0;   ///< permanent stretch of the link that bore it, share of its length
    double weak_at = -1;  ///< m from the anchor shackle, the weak link; -1: none
    double parted_by = 0; ///< N, tension that parted the cable; m of cable when its end ran out
};

/// A link that has had too much; link -1: none.
struct Parting {
    int link = -1;
    double tension = 0; ///< N
};

/// Permanent stretch at a tension (N): none up to the proof load, and from there in a straight line to
/// kStretchAtBreak at the breaking load. Share of the length.
double permanent_stretch(const ChainDef& def, double tension);

/// Looks at the tension of every link that is awake. weakness: share of the breaking load that the weak link
/// has lost.
Parting strain_links(const ChainDef& def, double weakness, const ChainState& chain, ChainStrain& strain);

} // namespace windlass::physics
