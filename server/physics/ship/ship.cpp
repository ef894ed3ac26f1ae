#include "server/physics/ship/ship.hpp"

#include "server/physics/sea/current.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr int kStrips = 20; ///< along the hull, for cross-flow drag

/// Hull in water at a relative speed u (forward), v (to starboard) and yaw rate r. The polynomial hull models
/// do not hold at anchor, where drift angles reach 90 deg: cross-flow drag by strips does below 1-2 kn.
PlanarForce hull_force(const ShipDef& def, double density, double u, double v, double r) {
    PlanarForce force;
    const double wetted = def.length_overall * (2 * def.draught + def.beam) * 0.85;
    force.x = -0.5 * density * wetted * def.surge_drag * std::abs(u) * u;
    const double strip = def.length_overall / kStrips;
    for (int i = 0; i < kStrips; ++i) {
        const double at = (i + 0.5) * strip - 0.5 * def.length_overall;
        const double across = v + at * r;
        const double side =
            -0.5 * density * def.draught * strip * def.cross_flow_drag * std::abs(across) * across;
        force.y += side;
        force.moment += at * side;
    }
    return force;
}

/// Of her axes as they are tilted into her axes upright.
Eigen::Quaterniond tilt(const ShipState& state) {
    return Eigen::AngleAxisd(-state.waves.pitch, Vec3::UnitY()) *
           Eigen::AngleAxisd(state.waves.roll, Vec3::UnitX());
}

/// Upright into the world. Headings count clockwise from north, angles of the frame anticlockwise from east.
Eigen::Quaterniond upright(const ShipState& state) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * std::numbers::pi - state.heading, Vec3::UnitZ()));
}

/// The hawse pipe lip of a side in her own axes, m.
Vec3 lip_aboard(const ShipDef& def, double side) {
    return {def.hawse_forward, -side * def.hawse_outboard, def.hawse_height};
}

double toward(double value, double target, double max) {
    return value + std::clamp(target - value, -max, max);
}

} // namespace

bool finite(const ShipState& state) {
    return std::isfinite(state.x + state.y + state.heading + state.surge + state.sway + state.yaw_rate +
                         state.engine + state.rudder + state.waves.heave + state.waves.drift_ahead +
                         state.waves.drift_abeam);
}

Vec3 forward(const ShipState& state) {
    return compass(state.heading);
}

Vec3 starboard(const ShipState& state) {
    return {std::cos(state.heading), -std::sin(state.heading), 0};
}

Vec3 ship_velocity(const ShipState& state) {
    return state.surge * forward(state) + state.sway * starboard(state);
}

Vec3 wave_velocity(const ShipState& state) {
    const WaveMotion& w = state.waves;
    return w.surge_speed * forward(state) + w.sway_speed * starboard(state) + w.heave_speed * Vec3::UnitZ();
}

Vec3 midships(const ShipState& state) {
    const WaveMotion& w = state.waves;
    return Vec3(state.x, state.y, 0) + w.surge * forward(state) + w.sway * starboard(state) +
           w.heave * Vec3::UnitZ();
}

Eigen::Quaterniond attitude(const ShipState& state) {
    return upright(state) * tilt(state);
}

Vec3 spin(const ShipState& state) {
    return Vec3(0, 0, -state.yaw_rate) + state.waves.pitch_rate * starboard(state) +
           state.waves.roll_rate * (attitude(state) * Vec3::UnitX());
}

// Both by what tilting changes: to the bit what they are upright.
Vec3 hawse_position(const ShipDef& def, const ShipState& state, double side) {
    const Vec3 lip = lip_aboard(def, side), tilted = tilt(state) * lip - lip;
    return midships(state) + def.hawse_height * Vec3::UnitZ() + def.hawse_forward * forward(state) +
           side * def.hawse_outboard * starboard(state) + upright(state) * tilted;
}

Vec3 hawse_velocity(const ShipDef& def, const ShipState& state, double side) {
    const Vec3 tilting = spin(state) + state.yaw_rate * Vec3::UnitZ();
    // Clockwise yaw moves a point forward of midships to starboard, and one to starboard aft.
    return ship_velocity(state) +
           state.yaw_rate *
               (def.hawse_forward * starboard(state) - side * def.hawse_outboard * forward(state)) +
           wave_velocity(state) + tilting.cross(attitude(state) * lip_aboard(def, side));
}

void add_pull(const ShipDef& def, const ShipState& state, double side, const Vec3& force, CablePull& pull) {
    pull.force += force;
    pull.moment += def.hawse_forward * force.dot(starboard(state)) -
                   side * def.hawse_outboard * force.dot(forward(state));
}

void step_ship(const ShipDef& def, const EnvironmentDef& environment, const Helm& helm, const CablePull& pull,
               double dt, ShipState& state) {
    state.engine += (helm.engine - state.engine) * std::min(1.0, dt / def.engine_time);
    state.rudder =
        toward(state.rudder, std::clamp(helm.rudder, -def.rudder_max, def.rudder_max), def.rudder_rate * dt);

    const Vec3 ahead = forward(state), abeam = starboard(state);
    const Vec3 current = mean_current(environment, def.draught);
    const double u = state.surge - current.dot(ahead), v = state.sway - current.dot(abeam);
    const PlanarForce hull = hull_force(def, environment.water_density, u, v, state.yaw_rate);

    const Vec3 wind = -compass(environment.wind_from) * environment.wind_speed - ship_velocity(state);
    const PlanarForce air = wind_force(def, wind.norm(), std::atan2(-wind.dot(abeam), -wind.dot(ahead)));

    const double thrust = state.engine * (state.engine > 0 ? def.thrust_ahead : def.thrust_astern);
    const double rudder =
        def.rudder_force * std::max(0.0, thrust) * state.rudder; // side force at the stern, to port
    const double lever = 0.45 * def.length_overall;              // of rudder and thrusters
    const double bow = helm.bow_thruster * def.thruster, stern = helm.stern_thruster * def.thruster;

    const double mass = def.displacement;
    const double mass_surge = mass * (1 + def.added_mass_surge), mass_sway = mass * (1 + def.added_mass_sway);
    const double radius = def.gyration_radius * def.length_overall;
    const double inertia = mass * radius * radius * (1 + def.added_inertia_yaw);
    const double munk = -mass * (def.added_mass_sway - def.added_mass_surge) * u * v;

    const double x = hull.x + air.x + thrust + pull.force.dot(ahead) + state.waves.drift_ahead;
    const double y = hull.y + air.y - rudder + bow + stern + pull.force.dot(abeam) + state.waves.drift_abeam;
    const double n = hull.moment + air.moment + rudder * lever + (bow - stern) * lever + pull.moment + munk;
    // Of the turning motion's forces the ship's own mass feels speed over ground, the added mass speed
    // through water.
    const double r = state.yaw_rate;
    const double added_surge = mass * def.added_mass_surge, added_sway = mass * def.added_mass_sway;
    state.surge += dt * (x + (mass * state.sway + added_sway * v) * r) / mass_surge;
    state.sway += dt * (y - (mass * state.surge + added_surge * u) * r) / mass_sway;
    state.yaw_rate += dt * n / inertia;

    const Vec3 velocity = ship_velocity(state);
    state.x += dt * velocity.x();
    state.y += dt * velocity.y();
    state.heading = std::remainder(state.heading + dt * state.yaw_rate, 2 * std::numbers::pi);
}

template <class Visitor, StateOf<ShipState> State>
void visit_state(Visitor& v, State& state) {
    auto& [x, y, heading, surge, sway, yaw_rate, engine, rudder, waves] = state;
    WINDLASS_STATE(v, x, y, heading, surge, sway, yaw_rate, engine, rudder, waves);
}
WINDLASS_STATE_LISTED(ShipState);

template <class Visitor, StateOf<Helm> State>
void visit_state(Visitor& v, State& helm) {
    auto& [engine, rudder, bow_thruster, stern_thruster] = helm;
    WINDLASS_STATE(v, engine, rudder, bow_thruster, stern_thruster);
}
WINDLASS_STATE_LISTED(Helm);

template <class Visitor, StateOf<CablePull> State>
void visit_state(Visitor& v, State& pull) {
    auto& [force, moment] = pull;
    WINDLASS_STATE(v, force, moment);
}
WINDLASS_STATE_LISTED(CablePull);

} // namespace windlass::physics
