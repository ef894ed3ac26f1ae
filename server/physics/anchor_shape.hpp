#pragma once
// What an anchor is made of: boxes for Bullet, and the points where chain and soil act.
//
// Anchor frame: origin at the centre of mass, x from the crown to the shackle, y along the crown, z out of
// the plane of the flukes; metres.

#include "server/physics/anchor_def.hpp"
#include "server/physics/environment.hpp"

#include <vector>

namespace windlass::physics {

/// A box of the anchor.
struct AnchorPart {
    Vec3 centre, half; ///< m
    double share = 0;  ///< of the mass
};

struct AnchorShape {
    std::vector<AnchorPart> parts;
    Vec3 shackle = Vec3::Zero(), crown = Vec3::Zero(); ///< m, pin of the shackle, pin of the flukes
    Vec3 inertia_over_mass = Vec3::Zero();             ///< m2, principal
};

AnchorShape anchor_shape(const AnchorDef& def);

} // namespace windlass::physics
