#pragma once
// The cable of a ship that lies quietly: the hanging part is in equilibrium at every moment.
//
// A cable follows its ends as a string of equilibria as long as what moving it takes is small beside its
// tension: inertia m s a and the change of drag, over the length s that hangs, the lip's acceleration a. (For
// a lip that swings to and fro at w that is (w / w1)^2 of the tension's change, w1 the lowest frequency of
// the hanging part: the static solution is the first term of the series in it.) Whether the equilibrium is
// the right one, current, friction on the bottom and bends in the lying chain included, is measured: the
// dynamic cable must have agreed with it for as long as its own slowest swing takes, and is asked again every
// ten minutes.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/chain/chain.hpp"
#include "server/physics/lod/catenary.hpp"
#include "server/physics/lod/model_policy.hpp"

namespace windlass::physics {

/// What is remembered between steps; a plain value.
struct QuietState {
    bool active = false;         ///< the cable is left to the catenary
    double to_look = 0;          ///< s to the next look at the dynamic cable, or to placing the nodes
    double agreed_for = 0;       ///< s that the dynamic cable has agreed; or, once left to it, not been asked
    double correction = 0;       ///< m of length that the nodes' chords and the deck's stretch make
    double drag = 0;             ///< N on the hanging part when it last agreed
    Vec3 toward = Vec3::UnitX(); ///< level, from foot to lip when it last agreed
    Vec3 lip = Vec3::Zero();     ///< m, of the last step
    Vec3 lip_velocity = Vec3::Zero();     ///< m/s
    Vec3 lip_acceleration = Vec3::Zero(); ///< m/s2, smoothed over half a second
    ModelError found;                     ///< difference from the dynamic cable when it last agreed
    ModelError error;                     ///< estimated now
};
template <class Visitor, StateOf<QuietState> State>
void visit_state(Visitor& v, State& state);

/// Decides when the catenary will do, and is the cable while it does.
class QuasiStaticCable {
public:
    /// budget: that the catenary may err. deck_length: as UpperEnd::deck_length(). capacity: most links.
    QuasiStaticCable(const ChainDef& chain, const EnvironmentDef& environment, const ModelError& budget,
                     double deck_length, int capacity);

    /// After a dynamic step of dt (s): the node near the touchdown from which the cable may be left to the
    /// catenary and below which the chain may sleep; 0 while it may not. pull: N, of the cable on the ship.
    /// at_rest: the windlass holds, part of the chain sleeps, and nothing but water and bottom touches it.
    int agrees(const EnvironmentDef& environment, const ChainState& chain, double dt, const Vec3& pull,
               bool at_rest);
    void take_over(); ///< from the next step on

    /// Moves the lip for a step of dt (s), and the sleeping part's end with the touchdown. False when the
    /// catenary no longer does; nothing has happened then. foot_holds: N, pull at the foot that friction
    /// holds there.
    bool follow(const EnvironmentDef& environment, ChainState& chain, double dt, const Vec3& lip,
                double foot_holds);
    /// Gives the cable back: the nodes where the catenary has them, with its speeds and tensions.
    void give_back(ChainState& chain);

    double tension() const { return cable_.tension(); } ///< N, at the lip
    Vec3 pull() const;                                  ///< N, of the cable on the ship
    const QuietState& state() const { return state_; }

    /// All that is remembered between steps, the last solution with it, but for the nodes: they are laid out
    /// before they are read, each time, and what is left there of nodes that were hove in is nobody's state.
    template <class Visitor, StateOf<QuasiStaticCable> Self>
    friend void visit_state(Visitor& v, Self& self) {
        WINDLASS_STATE(v, self.cable_, self.state_, self.foot_, self.toward_);
        // Of the last look, and found anew before it is used: the cable may have been hove in since.
        v.within({"foot"}, self.foot_, 0, self.nodes_.size() - 1);
    }

private:
    bool compare(const EnvironmentDef& environment, const ChainState& chain, const Vec3& pull);
    void track(const Vec3& lip, double dt);
    /// water: m, world, of its surface.
    bool solve(const ChainState& chain, int foot, const Vec3& lip, double water);
    void lay_out(const ChainState& chain, int foot);
    void place(ChainState& chain, double seconds);
    void move_foot(ChainState& chain);
    double drag(const EnvironmentDef& environment) const;
    ModelError moving(const EnvironmentDef& environment) const;

    ChainDef chain_;
    ModelError budget_;
    double deck_length_, bed_friction_;
    Catenary cable_;
    QuietState state_;
    int foot_ = 0;                ///< of the last look at the dynamic cable
    Vec3 toward_ = Vec3::UnitX(); ///< level, from foot to lip, of the last solution
    Field nodes_;                 ///< m, of the last solution; laid out before it is read
};

} // namespace windlass::physics
