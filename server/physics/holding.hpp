#pragma once
// How the soil holds the anchor: a first model of digging in, holding and dragging.

#include "server/physics/anchor_def.hpp"
#include "server/physics/environment.hpp"

namespace windlass::physics {

/// All that changes of an anchor in the ground; a plain value.
struct HoldingState {
    bool landed = false;   ///< touches the bottom
    double embedment = 0;  ///< 0 lying .. 1 dug in
    double dragged = 0;    ///< m moved on the bottom since it landed
    double overrun = 0;    ///< m slid without a stop since it was fully dug in
    bool dragging = false; ///< pulled through the ground beyond its holding power
};

/// Holding power of a dug-in anchor over its weight in air, and that left while it drags.
double holding_factor(const AnchorDef& def, Soil soil);

/// Share of the holding power left when the cable lifts at an angle (rad) above the seabed: 3/4 at 5 deg, 1/2
/// at 15 deg (practice; sources agree that it falls quickly above 5-8 deg).
double uplift_share(double uplift);

/// Horizontal resistance that the ground can give now, N.
double holding_capacity(const AnchorDef& def, Soil soil, const HoldingState& state, double uplift);

/// Takes what happened in a step of dt (s): the anchor moved (m) along the bottom, or was lifted off it.
void update_holding(const AnchorDef& def, HoldingState& state, bool on_bottom, double moved, double dt,
                    double uplift);

} // namespace windlass::physics
