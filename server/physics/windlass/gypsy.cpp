#include "server/physics/windlass/gypsy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace windlass::physics {

namespace {
constexpr double kJumpingShare = 0.3; ///< of the grip, dragged by links that ride over the pockets; tuned
constexpr double kSeatingSpeed = 0.3; ///< m/s, slower than this links fall back into the pockets; tuned
constexpr double kEasing = 1;         ///< rad/s, of a gypsy that turns on into the nearest pocket; tuned
constexpr double kTurn = 2 * std::numbers::pi;

/// rad, from the nearest pocket.
double off_pocket(const GypsyState& state) {
    return std::remainder(state.behind, kTurn / kGypsyPockets);
}
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

void turn_gypsy(double chain_diameter, double dt, double passed, GypsyState& state) {
    if (state.jumping) {
        state.behind =
            std::remainder(state.behind + kTurn * passed / gypsy_revolution(chain_diameter), kTurn);
    } else if (state.behind != 0) {
        state.behind -= std::clamp(off_pocket(state), -kEasing * dt, kEasing * dt);
    }
}

double gypsy_turn(double chain_diameter, double cable_out, const GypsyState& state) {
    const double turn = std::fmod(kTurn * cable_out / gypsy_revolution(chain_diameter) - state.behind, kTurn);
    return turn < 0 ? turn + kTurn : turn; // an anchor that is home has less than no cable out
}

double gypsy_speed(double chain_diameter, double speed, const GypsyState& state) {
    if (state.jumping) return 0;
    const double off = off_pocket(state);
    // What is left over by rounding is no motion.
    const double easing = std::abs(off) < 1e-9 ? 0 : std::copysign(kEasing, off);
    return kTurn * speed / gypsy_revolution(chain_diameter) + easing;
}

template <class Visitor, StateOf<GypsyState> State>
void visit_state(Visitor& v, State& state) {
    auto& [jumping, jumps, behind] = state;
    WINDLASS_STATE(v, jumping, jumps, behind);
    v.within({"jumps"}, jumps, 0, 1'000'000'000);
    v.within({"behind"}, behind, -kTurn, kTurn);
}
WINDLASS_STATE_LISTED(GypsyState);

} // namespace windlass::physics
