#pragma once
// How far an anchor has gone, as the ship sees it, since it was last looked at closely: as long as that is
// less than what lay between them, nothing has touched, and nothing need be looked for.

#include "server/physics/base/vec3.hpp"

#include <Eigen/Geometry>

namespace windlass::physics {

/// Place of an anchor in the ship's frame.
struct AnchorPlace {
    Vec3 centre = Vec3::Zero();                                   ///< m, of mass
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity(); ///< the anchor's axes into the ship's
    double flukes = 0;                                            ///< rad, from the shank's plane
};

/// Remembers where the anchor was, and how clear of the ship. It decides whether is looked, never what is
/// found: it is no part of the state.
class AnchorDrift {
public:
    /// clear: m, that every point of the anchor could go from there without touching the ship.
    void mark(const AnchorPlace& place, double clear) { marked_ = place, clear_ = clear; }

    /// m, that every point of it can still go from this place without touching; none: it must be looked.
    /// reach: m, of its farthest point from the centre of mass.
    double clear(const AnchorPlace& place, double reach) const;

private:
    AnchorPlace marked_;
    double clear_ = 0;
};

} // namespace windlass::physics
