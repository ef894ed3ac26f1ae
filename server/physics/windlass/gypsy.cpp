#include "server/physics/windlass/gypsy.hpp"

#include <cmath>

#include <stdexcept>

namespace windlass::physics {

namespace {
constexpr double kJumpingShare = 0.3; ///< of the grip, dragged by links that ride over the pockets; tuned
constexpr double kSeatingSpeed = 0.3; ///< m/s, slower than this links fall back into the pockets; tuned
} // namespace

double gypsy_grip(const WindlassDef& def, const EquipmentFaults& causes) {
    return def.gypsy_grip * (1 - causes.pockets_worn);
}

double jumping_drag(const WindlassDef& def, const EquipmentFaults& causes) {
    return kJumpingShare * gypsy_grip(def, causes);
}

void watch_pockets(const WindlassDef& def, double speed, double through, const EquipmentFaults& causes,
                   GypsyState& state) {
    if (!state.jumping) {
        if (std::abs(through) <= gypsy_grip(def, causes)) return;
        state.jumping = true;
        ++state.jumps;
    } else if (std::abs(speed) < kSeatingSpeed && std::abs(through) < jumping_drag(def, causes)) {
        state.jumping = false;
    }
}

void visit_state(StateVisitor& v, GypsyState& state) {
    auto& [jumping, jumps] = state;
    WINDLASS_STATE(v, jumping, jumps);
    v.within({"jumps"}, jumps, 0, 1'000'000'000);
}

} // namespace windlass::physics
