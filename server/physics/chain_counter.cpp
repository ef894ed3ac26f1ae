#include "server/physics/chain_counter.hpp"

#include "server/physics/gypsy.hpp"

#include <cmath>

namespace windlass::physics {

double counter_pulse(const WindlassDef& def, double chain_diameter) {
    return gypsy_revolution(chain_diameter) / (kGypsyPockets * def.counter_pulses);
}

void count_chain(const WindlassDef& def, double chain_diameter, double moved, bool jumping,
                 const WindlassCauses& causes, ChainCounterState& state) {
    if (jumping) return;
    const double pulse = counter_pulse(def, chain_diameter);
    state.since += moved;
    while (std::abs(state.since) >= pulse) {
        const int way = state.since > 0 ? 1 : -1;
        state.since -= way * pulse;
        state.missed += causes.counter_drift;
        if (state.missed >= 1) {
            state.missed -= 1;
        } else {
            state.pulses += way;
        }
    }
}

double counter_reading(const WindlassDef& def, double chain_diameter, const ChainCounterState& state) {
    return state.zero + static_cast<double>(state.pulses) * counter_pulse(def, chain_diameter);
}

} // namespace windlass::physics
