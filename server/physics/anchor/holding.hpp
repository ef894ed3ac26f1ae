#pragma once
// How the soil holds the anchor: digging in, holding, dragging, breaking out.

#include "server/physics/anchor/anchor_def.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/sea/environment.hpp"

namespace windlass::physics {

/// All that changes of an anchor in the ground; a plain value.
struct HoldingState {
    bool landed = false;     ///< touches the bottom
    Vec3 dug = Vec3::Zero(); ///< level, world: which way the flukes have dug in, as long as how far (0..1)
    double embedment = 0;    ///< 0 lying .. 1 dug in, for a pull the way that the shank points now
    double lowest = 0;       ///< m, height of the crown from which it breaks out by rising
    double dragged = 0;      ///< m moved on the bottom since it landed
    double overrun = 0;      ///< m slid without a stop since it was fully dug in
    bool dragging = false;   ///< pulled through the ground at less than its holding power
    double bent = 0;         ///< 0 sound .. 1: shank or flukes bent for good
    double fouled = 0;       ///< 0 clear .. 1: what lies on the bottom hangs on the flukes
    double ball = 0;         ///< N, weight in water of the soil that sticks to it
};
template <class Visitor, StateOf<HoldingState> State>
void visit_state(Visitor& v, State& state);

/// What an anchor did on the bottom in a step.
struct GroundMotion {
    bool touches = false;       ///< body or fluke tips
    double height = 0;          ///< m, of the crown
    Vec3 moved = Vec3::Zero();  ///< m, of the crown
    Vec3 shank = Vec3::UnitX(); ///< unit vector, level, from the crown to the shackle
    bool flukes_down = false;   ///< they point into the bottom
    double uplift = 0;          ///< rad, of the cable above the seabed
    double dt = 0;              ///< s
};

/// Holding power of a dug-in anchor over its weight in air.
double holding_factor(const AnchorDef& def, Soil soil);

/// m that it drags in the soil until it has dug in.
double setting_distance(const AnchorDef& def, Soil soil);

/// Share of the holding power left when the cable lifts at an angle (rad) above the seabed: 3/4 at 5 deg, 1/2
/// at 15 deg (practice; sources agree that it falls quickly above 5-8 deg).
double uplift_share(double uplift);

/// Level resistance that the ground can give now, N. poor: share of what flukes add to sliding that this
/// ground does not give.
double holding_capacity(const AnchorDef& def, Soil soil, const HoldingState& state, double uplift,
                        double poor = 0);

/// Pull straight up, beyond its own weight, that breaks it out now, N.
double breakout_capacity(const AnchorDef& def, Soil soil, const HoldingState& state);

/// Takes what happened in a step.
void update_holding(const AnchorDef& def, Soil soil, const GroundMotion& motion, HoldingState& state);

} // namespace windlass::physics
