#include "server/physics/state_fields.hpp"

#include <algorithm>
#include <stdexcept>

namespace windlass::physics {

std::string FieldName::text() const {
    std::string_view rest = list;
    for (int k = 0; k < index; ++k)
        rest.remove_prefix(std::min(rest.size(), rest.find(',') + 1));
    rest = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(' ')));
    while (!rest.empty() && rest.back() == '_')
        rest.remove_suffix(1);
    return std::string(rest);
}

void visit_state(StateVisitor& v, ShipState& state) {
    auto& [x, y, heading, surge, sway, yaw_rate, engine, rudder] = state;
    WINDLASS_STATE(v, x, y, heading, surge, sway, yaw_rate, engine, rudder);
}

void visit_state(StateVisitor& v, Helm& helm) {
    auto& [engine, rudder, bow_thruster, stern_thruster] = helm;
    WINDLASS_STATE(v, engine, rudder, bow_thruster, stern_thruster);
}

void visit_state(StateVisitor& v, CablePull& pull) {
    auto& [force, moment] = pull;
    WINDLASS_STATE(v, force, moment);
}

void visit_state(StateVisitor& v, EnvironmentDef& environment) {
    // Suction, profile and ground are the definition's: nothing changes them.
    auto& [depth, water_density, soil, bed_stiffness, bed_friction, bed_suction, wind_speed, wind_from,
           current_speed, current_towards, current_profile, ground] = environment;
    WINDLASS_STATE(v, depth, water_density, soil, bed_stiffness, bed_friction, wind_speed, wind_from,
                   current_speed, current_towards);
}

void visit_state(StateVisitor& v, ChainState& state) {
    auto& [links, asleep, parted, last_step, stretched, top_length, position, velocity, tension, spring,
           spring_before, stretch] = state;
    WINDLASS_STATE(v, links, asleep, parted, last_step, stretched, top_length);
    if (links < 1 || links > static_cast<int>(tension.size()))
        throw std::out_of_range("a chain of " + std::to_string(links) + " links in room for " +
                                std::to_string(tension.size()));
    if (asleep < 0 || asleep >= links || parted < -1)
        throw std::out_of_range("a chain with links asleep or parted that it has not");
    if (stretched < 0 || stretched > static_cast<int>(stretch.size()))
        throw std::out_of_range("a chain with stretched pieces that it has not");
    const auto nodes = static_cast<std::size_t>(links) + 1;
    v.numbers({"position_x"}, position.x.data(), nodes);
    v.numbers({"position_y"}, position.y.data(), nodes);
    v.numbers({"position_z"}, position.z.data(), nodes);
    v.numbers({"velocity_x"}, velocity.x.data(), nodes);
    v.numbers({"velocity_y"}, velocity.y.data(), nodes);
    v.numbers({"velocity_z"}, velocity.z.data(), nodes);
    v.numbers({"tension"}, tension.data(), nodes - 1);
    v.numbers({"spring"}, spring.data(), nodes - 1);
    v.numbers({"spring_before"}, spring_before.data(), nodes - 1);
    std::fill(stretch.begin() + stretched, stretch.end(), 0);
    v.numbers({"stretch"}, stretch.data(), static_cast<std::size_t>(stretched));
}

void visit_state(StateVisitor& v, ChainStrain& strain) {
    auto& [worst, weak_at, open_at, parted_by] = strain;
    WINDLASS_STATE(v, worst, weak_at, open_at, parted_by);
}

void visit_state(StateVisitor& v, CableTwistState& twist) {
    auto& [turns, leads, bearing, put_in] = twist;
    WINDLASS_STATE(v, turns, leads, bearing, put_in);
}

void visit_state(StateVisitor& v, CableLimits& limits) {
    auto& [home, bitter_end] = limits;
    WINDLASS_STATE(v, home, bitter_end);
}

void visit_state(StateVisitor& v, WindlassLevers& levers) {
    auto& [brake, speed, clutch_in, stopper_closed, emergency_stop] = levers;
    WINDLASS_STATE(v, brake, speed, clutch_in, stopper_closed, emergency_stop);
}

void visit_state(StateVisitor& v, WindlassState& state) {
    auto& [cable_speed, cable_out, last_direction, brake, clutch, stopper, motor, gypsy, counter, pipe,
           bitter_end_parted, chain_gone] = state;
    WINDLASS_STATE(v, cable_speed, cable_out, last_direction, brake, clutch, stopper, motor, gypsy, counter,
                   pipe, bitter_end_parted, chain_gone);
}

void visit_state(StateVisitor& v, ChainCounterState& state) {
    auto& [zero, pulses, since, missed] = state;
    WINDLASS_STATE(v, zero, pulses, since, missed);
    constexpr std::int64_t kMostPulses = 1LL << 53; // where a double still has every one
    if (pulses < -kMostPulses || pulses > kMostPulses)
        throw std::out_of_range("a chain counter with more pulses than it can count");
}

void visit_state(StateVisitor& v, BandBrakeState& state) {
    auto& [position, held, waits, skin, drum, water, glaze, heat, cooled, dried] = state;
    WINDLASS_STATE(v, position, held, waits, skin, drum, water, glaze, heat, cooled, dried);
}

void visit_state(StateVisitor& v, DogClutchState& state) {
    auto& [position, claw_offset, refused, sheared] = state;
    WINDLASS_STATE(v, position, claw_offset, refused, sheared);
}

void visit_state(StateVisitor& v, ChainStopperState& state) {
    auto& [closed, refused, sprung, room] = state;
    WINDLASS_STATE(v, closed, refused, sprung, room);
}

void visit_state(StateVisitor& v, PrimeMoverState& state) {
    auto& [speed, target, overload, pressure, tripped, trip_seen, overspeed, cut_off, burst, worst_speed] =
        state;
    WINDLASS_STATE(v, speed, target, overload, pressure, tripped, trip_seen, overspeed, cut_off, burst,
                   worst_speed);
}

void visit_state(StateVisitor& v, GypsyState& state) {
    auto& [jumping, jumps] = state;
    WINDLASS_STATE(v, jumping, jumps);
    if (jumps < 0 || jumps > 1'000'000'000) throw std::out_of_range("a gypsy that jumped so many times");
}

void visit_state(StateVisitor& v, SpurlingPipeState& state) {
    auto& [jammed, taut_at] = state;
    WINDLASS_STATE(v, jammed, taut_at);
}

void visit_state(StateVisitor& v, WindlassLoads& loads) {
    auto& [deck, brake, stopper, shaft_brake, jam, pockets, brake_capacity, brake_power] = loads;
    WINDLASS_STATE(v, deck, brake, stopper, shaft_brake, jam, pockets, brake_capacity, brake_power);
}

void visit_state(StateVisitor& v, DeckResult& result) {
    auto& [speed, hawse_tension, pipe_pull, gypsy_load, held, motor, gear, bitter_end, jam, end_stop] =
        result;
    WINDLASS_STATE(v, speed, hawse_tension, pipe_pull, gypsy_load, held, motor, gear, bitter_end, jam,
                   end_stop);
}

void visit_state(StateVisitor& v, HoldingState& state) {
    auto& [landed, dug, embedment, lowest, dragged, overrun, dragging, bent, fouled, ball] = state;
    WINDLASS_STATE(v, landed, dug, embedment, lowest, dragged, overrun, dragging, bent, fouled, ball);
}

void visit_state(StateVisitor& v, BightState& state) {
    auto& [body, shackle, share] = state;
    WINDLASS_STATE(v, body, shackle, share);
}

void visit_state(StateVisitor& v, SleepState& state) {
    auto& [to_look, still_for, still_links, holds, margin_height, settling, settled, weakest] = state;
    WINDLASS_STATE(v, to_look, still_for, still_links, holds, margin_height, settling, settled, weakest);
    if (still_links < 0 || weakest < 0) throw std::out_of_range("a sleeping chain of less than no links");
}

void visit_state(StateVisitor& v, QuietState& state) {
    auto& [active, to_look, agreed_for, correction, drag, toward, lip, lip_velocity, lip_acceleration, found,
           error] = state;
    WINDLASS_STATE(v, active, to_look, agreed_for, correction, drag, toward, lip, lip_velocity,
                   lip_acceleration, found, error);
}

void visit_state(StateVisitor& v, ModelError& error) {
    auto& [load, shape] = error;
    WINDLASS_STATE(v, load, shape);
}

} // namespace windlass::physics
