#pragma once
// Chain that lies still on the bottom sleeps, and the anchor with it: ChainState::asleep.
//
// Chain on the bottom is held by Coulomb friction, and its own stretch under a pull that friction holds is
// millimetres (T^2 / (2 mu w EA): 0.4 mm at 20 kN). So leaving it where it is costs nothing, as long as
// friction could hold it there: against the pull at the waking end along the chain, aside where it lies in a
// bend, and at last with the anchor's holding power. What friction can hold is worked out when chain falls
// asleep.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/chain/chain.hpp"
#include "server/physics/lod/model_policy.hpp"

namespace windlass::physics {

/// The anchor as the sleeping chain needs it.
struct AnchorAtRest {
    bool still = false; ///< lies on the bottom, does not move and does not drag
    double holds = 0;   ///< N, horizontally
};

/// What is remembered between steps; a plain value.
struct SleepState {
    double to_look = 0;       ///< s until the chain is looked at again
    double still_for = 0;     ///< s that the next links to sleep have been still
    int still_links = 0;      ///< links from the anchor up that were still all that time
    double holds = 0;         ///< N, pull at the waking end that friction holds
    double margin_height = 0; ///< m, of the chain just above the waking end when that fell asleep
    double settling = 0;      ///< m/s, fastest that any of it moved when it fell asleep
    double settled = 0;       ///< m that it might have gone on since
    int weakest = 0;          ///< node that gives first if it does not
};
template <class Visitor, StateOf<SleepState> State>
void visit_state(Visitor& v, State& state);

/// Decides who sleeps. Holds only what the chain is made of: what changes is in SleepState and ChainState.
class Sleep {
public:
    /// Chain wakes when the error of letting it sleep reaches the budget.
    Sleep(const ChainDef& chain, const ModelError& budget) : chain_(chain), budget_(budget) {}

    /// After a step of dt (s): wakes what might move, and lets sleep what has been still. True when the
    /// anchor has just fallen asleep.
    bool watch(const EnvironmentDef& environment, const AnchorAtRest& anchor, double dt, ChainState& chain);
    /// While the chain above the sleeping part is in equilibrium: lets dt (s) pass. False when it must wake.
    bool rest(const EnvironmentDef& environment, double dt, const ChainState& chain);
    /// Moves the waking end to a node; wakes all if that is too near the anchor.
    void move_end(const EnvironmentDef& environment, const AnchorAtRest& anchor, int node, ChainState& chain);

    /// Of letting chain sleep: by how much it would have stretched and settled, and what that means at the
    /// lip.
    ModelError error(const EnvironmentDef& environment, const ChainState& chain) const;

    const SleepState& state() const { return state_; }
    SleepState& state() { return state_; }

    /// Wakes all.
    void wake(ChainState& chain);

private:
    /// N/m, what friction holds of the chain that lies at node i against a pull in any direction.
    double friction(const EnvironmentDef& environment, const ChainState& chain, int i) const;
    bool over_budget(const EnvironmentDef& environment, const ChainState& chain) const;
    bool must_wake(const EnvironmentDef& environment, const ChainState& chain) const;
    int still_links(const EnvironmentDef& environment, const ChainState& chain) const;
    void work_out_holds(const EnvironmentDef& environment, const AnchorAtRest& anchor,
                        const ChainState& chain);
    int links_in(double metres) const;

    ChainDef chain_;
    ModelError budget_;
    SleepState state_;
};

} // namespace windlass::physics
