#pragma once
// The chain stopper: a bar across a link, or a pawl that only stops chain running out.

#include "server/physics/windlass_causes.hpp"
#include "server/physics/windlass_def.hpp"

namespace windlass::physics {

/// What changes of a chain stopper.
struct ChainStopperState {
    bool closed = false;
    bool refused = false; ///< asked for, but the chain runs, or the bar is loaded
    bool sprung = false;  ///< its pin worked out and the bar flew open; stays so
};

/// Moves bar or pawl as the lever wants. speed: m/s, paying out positive; load: N on the bar.
void work_stopper(const WindlassDef& def, bool wanted_closed, double speed, double load,
                  const WindlassCauses& causes, ChainStopperState& state);

/// Most that it holds against paying out and against heaving in, N.
double stopper_holds_out(const WindlassDef& def, const ChainStopperState& state);
double stopper_holds_in(const WindlassDef& def, const ChainStopperState& state);

} // namespace windlass::physics
