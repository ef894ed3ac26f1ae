#pragma once
// A band brake for tests of the cable and of the pipe, which the brake's own law should not decide.

#include "server/physics/windlass/windlass_def.hpp"

namespace windlass::rigs {

/// Grip in proportion to the hand-wheel, hard on in 2 s.
inline void grip_in_proportion(physics::WindlassDef& def) {
    def.brake_free_play = 0;
    def.brake_stiffening = 1;
    def.brake_travel_time = 2;
}

} // namespace windlass::rigs
