#pragma once
// A turn of cable over its anchor: drawn tight, it pulls the anchor by crown or flukes, or the shackle back
// over the crown, instead of the shackle away from it.

#include "server/physics/environment.hpp"

namespace windlass::physics {

/// What its cable does to an anchor in a step.
struct BightPull {
    Vec3 body = Vec3::Zero();    ///< N, on crown, shank and flukes
    Vec3 shackle = Vec3::Zero(); ///< N
    Vec3 shank = Vec3::UnitX();  ///< unit vector from crown to shackle
    double touching = 0;         ///< N, largest tension of the links that touch the body
    double taut = 0;             ///< N: cable that pulls by less is slack
    double dt = 0;               ///< s
};

/// A plain value.
struct BightState {
    Vec3 body = Vec3::Zero(), shackle = Vec3::Zero(); ///< N, of taut cable, over some seconds
    /// 0 clear .. 1: how much of what the cable pulled, when it last was taut, came on to the anchor's body
    /// instead of its shackle; 1 where it pulls the anchor crown first.
    double share = 0;
};

/// From this share on the anchor is foul. With the cable clear of it, it is zero; tuned.
inline constexpr double kFoul = 0.25;

/// Takes what happened in a step. Slack cable that lies on the anchor does not count.
void update_bight(const BightPull& pull, BightState& state);

} // namespace windlass::physics
