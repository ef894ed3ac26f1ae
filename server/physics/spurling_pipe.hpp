#pragma once
// The spurling pipe, from the gypsy down to the locker, when the cable is jammed in it: nothing comes up, and
// what is hove in heaps between jam and gypsy. Forces in N at the gypsy's pitch line.

#include "server/physics/drive_line.hpp"

namespace windlass::physics {

/// What changes of a spurling pipe.
struct SpurlingPipeState {
    bool jammed = false;
    double taut_at = 0; ///< m of cable out at which the chain from gypsy to jam is straight
};

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

/// A jam that holds so much (N; 0: none) either way, beyond which the cable is dragged through it. cable_out:
/// m, now; stiffness: N, EA of the chain; mass: kg that is jerked when it comes taut.
PipeLoads work_spurling_pipe(double holds, double cable_out, double stiffness, double mass, double dt,
                             SpurlingPipeState& state);

/// m of chain that is heaped under the gypsy.
double heaped(const SpurlingPipeState& state, double cable_out);

} // namespace windlass::physics
