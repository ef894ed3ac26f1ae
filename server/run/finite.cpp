#include "server/run/finite.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::server {

namespace {

bool finite(std::initializer_list<double> values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool finite(const exercise::ShipView& s) {
    return s.position.allFinite() && s.attitude.coeffs().allFinite() && s.velocity.allFinite() &&
           finite({s.heading, s.surge, s.sway, s.yaw_rate, s.engine, s.rudder, s.bow_thruster,
                   s.stern_thruster});
}

bool finite(const exercise::AnchorView& a) {
    return a.position.allFinite() && a.attitude.coeffs().allFinite() && a.velocity.allFinite() &&
           a.shackle.allFinite() &&
           finite({a.height_above_bottom, a.holding_capacity, a.holding_used, a.uplift, a.embedment,
                   a.dragged, a.fluke_angle, a.weight, a.carried, a.breakout, a.bent, a.fouled});
}

bool finite(const exercise::ChainView& c) {
    return finite({c.cable_out, c.lead_clock, c.top_angle, c.on_bottom, c.turns, c.largest_tension,
                   c.stretched, c.stretch}) &&
           std::all_of(c.nodes.begin(), c.nodes.end(), [](const auto& node) { return node.allFinite(); }) &&
           std::all_of(c.tension.begin(), c.tension.end(), [](float t) { return std::isfinite(t); });
}

bool finite(const exercise::WindlassView& w) {
    return finite({w.hawse_tension,     w.gypsy_load,      w.gypsy_load_indicated, w.brake_load,
                   w.stopper_load,      w.motor_load,      w.breaking_load,        w.brake_capacity,
                   w.brake_rating,      w.cable_out,       w.cable_out_indicated,  w.cable_speed,
                   w.gypsy_speed,       w.brake_position,  w.brake_torque,         w.brake_power,
                   w.brake_energy,      w.brake_wear,      w.lining_temperature,   w.drum_temperature,
                   w.motor_torque,      w.motor_speed,     w.motor_current,        w.motor_pressure,
                   w.motor_temperature, w.speed_lever,     w.shaft_brake_load,     w.bitter_end_load,
                   w.locker_load,       w.lining_friction, w.spurling_pipe_load});
}

} // namespace

bool is_finite(const exercise::Snapshot& s) {
    const auto& e = s.environment;
    return finite({s.time, e.depth, e.wind_speed, e.wind_from, e.current_speed, e.current_towards}) &&
           finite(s.ship) && s.cable_force.allFinite() && s.cable_moment.allFinite() &&
           std::all_of(
               s.tackle.begin(), s.tackle.end(),
               [](const auto& t) { return finite(t.anchor) && finite(t.chain) && finite(t.windlass); }) &&
           std::all_of(s.events.begin(), s.events.end(),
                       [](const auto& event) { return std::isfinite(event.value); });
}

} // namespace windlass::server
