#include "server/physics/windlass/spurling_pipe.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {
constexpr double kDamping = 0.3; ///< of critical, of chain that is jerked; tuned
constexpr double kHeapRoom = 1;  ///< m of chain that finds room above the jam before it wedges; tuned
constexpr double kPacking = 1e7; ///< N/m, wedged chain: 9 cm stall the motor of 78 mm chain; tuned
} // namespace

InboardTie tie(const FastChain& chain, double dt) {
    assert(dt > 0 && chain.length > 0 && "no chain, no tie");
    const double spring = chain.stiffness / chain.length;
    const double damper = chain.stretch > 0 ? 2 * kDamping * std::sqrt(spring * chain.mass) : 0;
    return {spring * chain.stretch, spring * dt + damper, chain.holds};
}

double hanging_on_jam(const SpurlingPipeState& state, double hanging) {
    return state.jammed ? std::max(0.0, hanging - kToJam) : 0;
}

PipeLoads work_spurling_pipe(double holds, const CableInPipe& cable, double dt, SpurlingPipeState& state) {
    if (holds <= 0) state.jammed = false;
    if (holds > 0 && !state.jammed) state = {true, cable.out}; // the chain hangs straight into the pipe
    if (!state.jammed) return {};
    // What was dragged through either way.
    const double max = holds + cable.below;
    state.taut_at = std::clamp(state.taut_at, cable.out - max * kToJam / cable.stiffness,
                               cable.out + kHeapRoom + holds / kPacking);
    const double wedged = heaped(state, cable.out) - kHeapRoom;
    return {tie({cable.stiffness, kToJam, cable.out - state.taut_at, cable.mass, max}, dt),
            std::clamp(kPacking * wedged, 0.0, holds)};
}

double heaped(const SpurlingPipeState& state, double cable_out) {
    return state.jammed ? std::max(0.0, state.taut_at - cable_out) : 0;
}

template <class Visitor, StateOf<SpurlingPipeState> State>
void visit_state(Visitor& v, State& state) {
    auto& [jammed, taut_at] = state;
    WINDLASS_STATE(v, jammed, taut_at);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, taut_at);
}
WINDLASS_STATE_LISTED(SpurlingPipeState);

} // namespace windlass::physics
