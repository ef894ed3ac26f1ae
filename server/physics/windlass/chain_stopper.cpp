#include "server/physics/windlass/chain_stopper.hpp"

#include "server/physics/base/state_limits.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {
constexpr double kStandstill = 0.05;    ///< m/s, chain as good as stopped: a bar can be dropped
constexpr double kBarLooseShare = 0.05; ///< of rated pull, below which a bar lifts; tuned
} // namespace

void work_stopper(const WindlassDef& def, bool wanted_closed, double speed, double load,
                  const EquipmentFaults& causes, ChainStopperState& state) {
    if (causes.stopper_pin_out > 0 && state.closed &&
        std::abs(load) >= (1 - causes.stopper_pin_out) * def.stopper_rating) {
        state.sprung = true;
        state.closed = false;
    }
    if (causes.stopper_pin_out == 0) state.sprung = false; // a new pin is in
    state.refused = state.sprung && wanted_closed;
    if (state.sprung || wanted_closed == state.closed) return;
    // A pawl falls on chain that comes in; nothing can be closed on chain that runs out.
    const bool may_drop =
        def.stopper == StopperKind::pawl ? speed < kStandstill : std::abs(speed) < kStandstill;
    // Cable that would run out holds a bar down. One that is hove in against it lifts it, once its pin is
    // drawn, with the round end of the next link.
    const bool free = wanted_closed ? may_drop : load < kBarLooseShare * def.rated_pull;
    if (free) state.closed = wanted_closed, state.room = 0;
    state.refused = !free;
}

void follow_chain(double run_out, double play, ChainStopperState& state) {
    if (state.closed) state.room = std::clamp(state.room - run_out, 0.0, play);
}

double stopper_holds_out(const WindlassDef& def, const ChainStopperState& state) {
    return state.closed && state.room == 0 ? def.stopper_rating : 0;
}

double stopper_holds_in(const WindlassDef& def, double play, const ChainStopperState& state) {
    const bool bears = state.closed && def.stopper == StopperKind::bar && state.room == play;
    return bears ? def.stopper_rating : 0;
}

template <class Visitor, StateOf<ChainStopperState> State>
void visit_state(Visitor& v, State& state) {
    auto& [closed, refused, sprung, room] = state;
    WINDLASS_STATE(v, closed, refused, sprung, room);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, room);
}
WINDLASS_STATE_LISTED(ChainStopperState);

} // namespace windlass::physics
