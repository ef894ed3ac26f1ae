#include "server/physics/ship/engine.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

void step_engine(const ShipDef& def, double ordered, bool available, double dt, ShipState& state) {
    assert(dt > 0 && "a step takes time");
    assert(std::abs(ordered) <= 1 && "the telegraph has stops");
    constexpr double kStands = 0.02; // of full thrust: the shaft is braked from there
    double target = available ? ordered : 0;
    if (def.engine_start_time > 0 && state.engine * target <= 0) {
        const bool stands = std::abs(state.engine) < kStands;
        if (stands) state.engine = 0;
        state.engine_started = stands && target != 0 ? state.engine_started + dt : 0;
        if (state.engine_started < def.engine_start_time) target = 0;
    }
    state.engine += (target - state.engine) * std::min(1.0, dt / def.engine_time);
}

} // namespace windlass::physics
