#pragma once
// A turn of cable over its anchor: drawn tight, it pulls the anchor by crown or flukes, or the shackle back
// over the crown, instead of the shackle away from it.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/sea/environment.hpp"

namespace windlass::physics {

/// What its cable does to an anchor in a step.
struct BightPull {
    Vec3 body = Vec3::Zero();    ///< N, on crown, shank and flukes
    Vec3 shackle = Vec3::Zero(); ///< N
    Vec3 shank = Vec3::UnitX();  ///< unit vector from crown to shackle
    double touching = 0;         ///< N, largest tension of the links that touch the body
    double taut = 0;             ///< N: cable that touches it and pulls by less is slack
    double slides = 0;           ///< N, that an anchor takes to slide which only lies there
    double moved = 0;            ///< m, of the anchor: the less of its two ends
    double dt = 0;               ///< s
};

/// A plain value.
struct BightState {
    Vec3 body = Vec3::Zero(), shackle = Vec3::Zero(); ///< N, of taut cable, over some seconds
    /// 0 clear .. 1: how much of what the cable pulled, when it last moved the anchor, came on to its body
    /// instead of its shackle; 1 where it pulled the anchor crown first.
    double share = 0;
};
template <class Visitor, StateOf<BightState> State>
void visit_state(Visitor& v, State& state);

/// From this share on the anchor is foul. With the cable clear of it, it is zero; tuned.
inline constexpr double kFoul = 0.25;

/// Takes what happened in a step. Slack cable that lies on the anchor does not count. Nor does cable that
/// leads away across it and does not move it, or only turns it round: what that will do shows when it comes
/// to strain, and most of it slips off.
void update_bight(const BightPull& pull, BightState& state);

} // namespace windlass::physics
