#pragma once
// The spurling pipe, from the gypsy down to the locker, when the cable is jammed in it: nothing comes up, and
// what is hove in heaps between jam and gypsy. The chain below hangs on the jam. Forces in N at the gypsy's
// pitch line.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/windlass/drive_line.hpp"

namespace windlass::physics {

/// What changes of a spurling pipe.
struct SpurlingPipeState {
    bool jammed = false;
    double taut_at = 0; ///< m of cable out at which the chain from gypsy to jam is straight
};
template <class Visitor, StateOf<SpurlingPipeState> State>
void visit_state(Visitor& v, State& state);

/// Chain inboard of the gypsy whose end is fast, as the next step of dt (s) meets it: a spring with its
/// damper.
struct FastChain {
    double stiffness = 0; ///< N, EA
    double length = 0;    ///< m, from gypsy to where it is fast
    double stretch = 0;   ///< m; negative: it hangs in a bight
    double mass = 0;      ///< kg that it jerks
    double holds = 0;     ///< N, most that it bears
};
InboardTie tie(const FastChain& chain, double dt);

/// What a jam does in the next step.
struct PipeLoads {
    InboardTie jam;  ///< against paying out
    double heap = 0; ///< most that the heap under the gypsy resists heaving; it does not push back
};

/// Where a cable jams: m of chain below the gypsy; tuned: the pipe's mouth on deck.
inline constexpr double kToJam = 2;

/// Of so much chain hanging below the gypsy (m), what hangs on the jam.
double hanging_on_jam(const SpurlingPipeState& state, double hanging);

/// The cable that may jam.
struct CableInPipe {
    double out = 0;       ///< m of cable out
    double stiffness = 0; ///< N, EA
    double mass = 0;      ///< kg that is jerked when it comes taut
    double below = 0;     ///< N, weight of the chain below the place of the jam
};

/// A jam that holds so much (N; 0: none) either way beside the weight below it; with more the cable is
/// dragged through.
PipeLoads work_spurling_pipe(double holds, const CableInPipe& cable, double dt, SpurlingPipeState& state);

/// m of chain that is heaped under the gypsy.
double heaped(const SpurlingPipeState& state, double cable_out);

} // namespace windlass::physics
