#pragma once
// The chain stopper: a bar across a link, or a pawl that only stops chain running out.

#include "server/physics/base/equipment_faults.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/windlass/windlass_def.hpp"

namespace windlass::physics {

/// What changes of a chain stopper.
struct ChainStopperState {
    bool closed = false;
    bool refused = false; ///< asked for, but the chain runs, or the bar is loaded
    bool sprung = false;  ///< its pin worked out and the bar flew open; stays so
    double room = 0;      ///< m, that the chain has come in from where the bar bears against its running out
};
template <class Visitor, StateOf<ChainStopperState> State>
void visit_state(Visitor& v, State& state);

/// m, that chain can move between a bar that stops it running out and the same bar stopping it coming in:
/// upright links are 8 d apart and 6 d long (ISO 1704), and a bar of one d lies between them. It is what lets
/// a bar be lifted: the weight is off it as soon as the windlass takes it.
inline double stopper_play(double diameter) {
    return diameter;
}

/// The chain has run out by so much (m; less than zero: come in) under the bar.
void follow_chain(double run_out, double play, ChainStopperState& state);

/// Moves bar or pawl as the lever wants. speed: m/s, paying out positive; load: N on the bar, against paying
/// out positive.
void work_stopper(const WindlassDef& def, bool wanted_closed, double speed, double load,
                  const EquipmentFaults& causes, ChainStopperState& state);

/// Most that it holds against paying out and against heaving in, N: nothing while the chain has room.
double stopper_holds_out(const WindlassDef& def, const ChainStopperState& state);
double stopper_holds_in(const WindlassDef& def, double play, const ChainStopperState& state);

} // namespace windlass::physics
