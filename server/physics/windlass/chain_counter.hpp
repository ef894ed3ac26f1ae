#pragma once
// The chain counter: a pick-up at the gypsy that counts the pockets as they pass. It knows the gypsy, not the
// chain: what jumps over the pockets is not counted.

#include "server/physics/base/equipment_faults.hpp"
#include "server/physics/base/state_visitor.hpp"

#include <cstdint>

namespace windlass::physics {

/// What changes of a chain counter.
struct ChainCounterState {
    double zero = 0;         ///< m, what it showed before it counted anything
    std::int64_t pulses = 0; ///< counted since, paying out positive
    double since = 0;        ///< m of chain past the pick-up since the last pulse, paying out positive
    double missed = 0;       ///< 0..1, of the next pulse that it will not see
};
template <class Visitor, StateOf<ChainCounterState> State>
void visit_state(Visitor& v, State& state);

/// m of chain for each pulse, two for each pocket of 8 d.
double counter_pulse(double chain_diameter);

/// m of chain that ran over the gypsy, paying out positive; jumping: over a gypsy that stands.
void count_chain(double chain_diameter, double moved, bool jumping, const EquipmentFaults& causes,
                 ChainCounterState& state);

/// What it shows, m of cable out.
double counter_reading(double chain_diameter, const ChainCounterState& state);

} // namespace windlass::physics
