#pragma once
// Turns in a cable between hawse pipe and anchor: how the ship puts them in, and what they do at the lip. The
// gypsy takes links flat and on edge by turns and leaves none of them inboard, so that they crowd together as
// the cable is hove in.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/chain/chain_def.hpp"
#include "server/physics/sea/environment.hpp"

namespace windlass::physics {

/// What changes of a cable's turns.
struct CableTwistState {
    double turns = 0;   ///< clockwise seen from above, as the ship turned
    bool leads = false; ///< it led off to the anchor in the last step, on this bearing
    double bearing = 0; ///< rad, from lip to anchor shackle
    double put_in = 0;  ///< severity of the fault that has been taken over
};
template <class Visitor, StateOf<CableTwistState> State>
void visit_state(Visitor& v, State& twist);

/// What a step of dt (s) brought.
struct TwistStep {
    double dt = 0;
    double turned = 0;             ///< rad, by which the ship turned, clockwise
    Vec3 to_anchor = Vec3::Zero(); ///< m, from lip to anchor shackle
    bool anchored = false;         ///< anchor on the bottom at the other end: its swivel lies in the ground
    double put_in = 0;             ///< severity of the fault
};

/// The ship turns one end of the cable; a cable that swings about its anchor turns with her. With the anchor
/// off the bottom its swivel lets the turns out.
void follow_twist(const TwistStep& step, CableTwistState& state);

/// rad that each link is turned against the next, with so many turns in so much cable (m).
double twist_per_link(const ChainDef& chain, double turns, double cable_out);

/// Share of the hawse pipe's efficiency that links turned by so much (rad) against each other leave: 1 as
/// far as links turn freely, next to nothing where they knot up and wedge at the lip.
double twisted_efficiency(double per_link);

/// rad, from which chain is stiff in torsion, and at which it knots up.
double free_twist();
double knotting_twist();

} // namespace windlass::physics
