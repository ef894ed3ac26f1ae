#include "server/physics/windlass/chain_counter.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/windlass/gypsy.hpp"

#include <cmath>

#include <stdexcept>

namespace windlass::physics {

namespace {
constexpr int kPulses = 2;         ///< of each pocket: 8 d of chain; tuned
constexpr double kMaxPulses = 1e6; ///< in one step
} // namespace

double counter_pulse(double chain_diameter) {
    return gypsy_revolution(chain_diameter) / (kGypsyPockets * kPulses);
}

void count_chain(double chain_diameter, double moved, bool jumping, const EquipmentFaults& causes,
                 ChainCounterState& state) {
    if (jumping) return;
    const double pulse = counter_pulse(chain_diameter);
    state.since += moved;
    const double passed = std::trunc(state.since / pulse);
    if (!(std::abs(passed) >= 1)) return;
    state.since -= passed * pulse;
    state.missed += std::abs(passed) * causes.counter_drift;
    const double blind = std::floor(state.missed);
    state.missed -= blind;
    const double seen = std::copysign(std::abs(passed) - blind, passed);
    // No cable has so many; a state from outside may say so.
    state.pulses += std::abs(seen) < kMaxPulses ? static_cast<std::int64_t>(seen) : 0;
}

double counter_reading(double chain_diameter, const ChainCounterState& state) {
    return state.zero + static_cast<double>(state.pulses) * counter_pulse(chain_diameter);
}

template <class Visitor, StateOf<ChainCounterState> State>
void visit_state(Visitor& v, State& state) {
    auto& [zero, pulses, since, missed] = state;
    WINDLASS_STATE(v, zero, pulses, since, missed);
    constexpr std::int64_t kMaxPulses = 1LL << 53; // where a double still has every one
    v.within({"pulses"}, pulses, -kMaxPulses, kMaxPulses);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, zero, since);
    WINDLASS_WITHIN(v, 0, 1, missed);
}
WINDLASS_STATE_LISTED(ChainCounterState);

} // namespace windlass::physics
