#include "server/physics/windlass/dog_clutch.hpp"

#include "server/physics/base/state_limits.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {
constexpr int kClaws = 6;
constexpr double kClawPlay = 0.4;        ///< of the claws' pitch, in which they fall in; tuned
constexpr double kClawLooseShare = 0.05; ///< of rated pull, below which claws slide apart; tuned
} // namespace

double claw_pitch(const WindlassDef& def) {
    return 2 * std::numbers::pi * def.gypsy_radius / kClaws;
}

bool claws_in_line(const WindlassDef& def, const DogClutchState& state) {
    const double pitch = claw_pitch(def);
    const double off = std::min(state.claw_offset, pitch - state.claw_offset);
    return off <= 0.5 * kClawPlay * pitch;
}

void work_clutch(const WindlassDef& def, double dt, bool wanted_in, double slip, double through,
                 const EquipmentFaults& causes, DogClutchState& state) {
    assert(dt > 0 && "a step takes time");
    through = std::abs(through);
    state.refused = false;
    if (state.position != Clutch::in) {
        const double pitch = claw_pitch(def), turned = state.claw_offset + slip * dt;
        state.claw_offset = turned - pitch * std::floor(turned / pitch);
    }
    if (state.sheared) {
        state.position = Clutch::out;
        state.refused = wanted_in;
        return;
    }
    if (wanted_in && state.position != Clutch::in) {
        const bool together = std::abs(slip) < kEngageSpeed && claws_in_line(def, state);
        state.position = together ? Clutch::in : Clutch::engaging;
        state.refused = !together;
    } else if (!wanted_in && state.position == Clutch::in) {
        if (through < kClawLooseShare * def.rated_pull) state.position = Clutch::out;
        state.refused = state.position == Clutch::in;
    } else if (!wanted_in) {
        state.position = Clutch::out;
    }
    if (state.position != Clutch::in) return;
    if (through > def.clutch_rating * (1 - causes.shaft_damaged)) {
        state.sheared = true;
        state.position = Clutch::out;
    } else if (causes.clutch_worn > 0 && through >= (1 - causes.clutch_worn) * def.rated_pull) {
        state.position = Clutch::engaging; // jumped out; goes in again when the chain stands
    }
}

template <class Visitor, StateOf<DogClutchState> State>
void visit_state(Visitor& v, State& state) {
    auto& [position, claw_offset, refused, sheared] = state;
    WINDLASS_STATE(v, position, claw_offset, refused, sheared);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, claw_offset);
}
WINDLASS_STATE_LISTED(DogClutchState);

} // namespace windlass::physics
