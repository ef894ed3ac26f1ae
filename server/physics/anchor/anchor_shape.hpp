#pragma once
// What an anchor is made of: boxes for Bullet, and the points where chain and soil act.
//
// Anchor frame: origin at the centre of mass, x from the crown to the shackle, y along the crown, z out of
// the plane of the flukes; metres.

#include "server/physics/anchor/anchor_def.hpp"
#include "server/physics/sea/environment.hpp"

#include <vector>

namespace windlass::physics {

/// A box of the anchor.
struct AnchorPart {
    Vec3 centre, half;  ///< m
    double share = 0;   ///< of the mass
    bool fluke = false; ///< goes into the soil: does not rest on the bed
    double roller = 0;  ///< m, radius; not 0: rests on the bed as a roller along y, not on its corners
};

/// The flukes as one part that turns on its pin, the crown.
struct FlukeShape {
    bool hinged = false;
    double limit = 0;             ///< rad, to either side of the shank's plane
    double length = 0;            ///< m, pin to tips
    double spread = 0;            ///< m, from the shank's axis to either tip
    double width = 0;             ///< m, of the palms together, across the shank
    double moment_over_mass = 0;  ///< m, centre of mass ahead of the pin, times their share of the mass
    double inertia_over_mass = 0; ///< m2, about the pin, of the anchor's mass
};

struct AnchorShape {
    std::vector<AnchorPart> parts; ///< flukes in the shank's plane
    FlukeShape flukes;
    Vec3 shackle = Vec3::Zero(), crown = Vec3::Zero(); ///< m, pin of the shackle, pin of the flukes
    double shank_half = 0;                             ///< m, half the shank's thickness at the shackle
    Vec3 inertia_over_mass = Vec3::Zero();             ///< m2, principal
};

AnchorShape anchor_shape(const AnchorDef& def);

} // namespace windlass::physics
