#include "server/physics/ship/ship.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/sea/environment.hpp"

#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

// m/s and rad/s, of a state that is brought back
constexpr double kFastestShip = 100, kFastestSwing = 10;

/// Of her axes as they are tilted into her axes upright.
Eigen::Quaterniond tilt(const ShipState& state) {
    return Eigen::AngleAxisd(-pitch(state), Vec3::UnitY()) * Eigen::AngleAxisd(roll(state), Vec3::UnitX());
}

/// Upright into the world. Headings count clockwise from north, angles of the frame anticlockwise from east.
Eigen::Quaterniond upright(const ShipState& state) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * std::numbers::pi - state.heading, Vec3::UnitZ()));
}

/// Forward and to starboard of her on the level, told at once: each sine costs as much as all the rest.
struct LevelAxes {
    Vec3 ahead, abeam;
    explicit LevelAxes(const ShipState& state) : ahead(forward(state)), abeam(ahead.y(), -ahead.x(), 0) {}

    Vec3 midships(const ShipState& state) const {
        const WaveMotion& w = state.waves;
        return Vec3(state.x, state.y, state.level) + w.surge * ahead + w.sway * abeam +
               (w.heave + state.floats.heave) * Vec3::UnitZ();
    }
};

/// The hawse pipe lip of a side in her own axes, m.
Vec3 lip_aboard(const ShipDef& def, double side) {
    return {def.hawse_forward, -side * def.hawse_outboard, def.hawse_height};
}

} // namespace

bool finite(const ShipState& state) {
    return std::abs(state.x) < kFarthest && std::abs(state.y) < kFarthest &&
           std::abs(state.surge) < kFastest && std::abs(state.sway) < kFastest &&
           std::abs(state.yaw_rate) < kFastestTurn && std::abs(state.waves.heave) < kFarthest &&
           std::isfinite(state.heading + state.engine + state.engine_started + state.rudder +
                         state.waves.drift_ahead + state.waves.drift_abeam + state.floats.heave +
                         state.floats.heel + state.floats.trim);
}

Vec3 forward(const ShipState& state) {
    return compass(state.heading);
}

Vec3 starboard(const ShipState& state) {
    return {std::cos(state.heading), -std::sin(state.heading), 0};
}

Vec3 ship_velocity(const ShipState& state) {
    const LevelAxes axes(state);
    return state.surge * axes.ahead + state.sway * axes.abeam;
}

Vec3 wave_velocity(const ShipState& state) {
    const WaveMotion& w = state.waves;
    const LevelAxes axes(state);
    return w.surge_speed * axes.ahead + w.sway_speed * axes.abeam +
           (w.heave_speed + state.floats.heave_speed) * Vec3::UnitZ();
}

Vec3 midships(const ShipState& state) {
    return LevelAxes(state).midships(state);
}

double roll(const ShipState& state) {
    return state.waves.roll + state.floats.heel;
}

double pitch(const ShipState& state) {
    return state.waves.pitch + state.floats.trim;
}

Eigen::Quaterniond attitude(const ShipState& state) {
    return upright(state) * tilt(state);
}

Vec3 spin(const ShipState& state) {
    return Vec3(0, 0, -state.yaw_rate) +
           (state.waves.pitch_rate + state.floats.trim_rate) * starboard(state) +
           (state.waves.roll_rate + state.floats.heel_rate) * (attitude(state) * Vec3::UnitX());
}

// Both by what tilting changes: to the bit what they are upright.
Vec3 hawse_position(const ShipDef& def, const ShipState& state, double side) {
    const LevelAxes axes(state);
    const Vec3 level = axes.midships(state) + def.hawse_height * Vec3::UnitZ() +
                       def.hawse_forward * axes.ahead + side * def.hawse_outboard * axes.abeam;
    if (roll(state) == 0 && pitch(state) == 0) return level;
    const Vec3 lip = lip_aboard(def, side), tilted = tilt(state) * lip - lip;
    return level + upright(state) * tilted;
}

Vec3 hawse_velocity(const ShipDef& def, const ShipState& state, double side) {
    const Vec3 tilting = spin(state) + state.yaw_rate * Vec3::UnitZ();
    // Clockwise yaw moves a point forward of midships to starboard, and one to starboard aft.
    return ship_velocity(state) +
           state.yaw_rate *
               (def.hawse_forward * starboard(state) - side * def.hawse_outboard * forward(state)) +
           wave_velocity(state) + state.rise * Vec3::UnitZ() +
           tilting.cross(attitude(state) * lip_aboard(def, side));
}

void add_pull(const ShipDef& def, const ShipState& state, double side, const Vec3& force, CablePull& pull) {
    pull.force += force;
    pull.moment += def.hawse_forward * force.dot(starboard(state)) -
                   side * def.hawse_outboard * force.dot(forward(state));
}

template <class Visitor, StateOf<ShipState> State>
void visit_state(Visitor& v, State& state) {
    auto& [x, y, heading, surge, sway, yaw_rate, engine, engine_started, rudder, waves, floats, level, rise] =
        state;
    WINDLASS_STATE(v, x, y, heading, surge, sway, yaw_rate, engine, engine_started, rudder, waves, floats,
                   level, rise);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, x, y);
    WINDLASS_WITHIN(v, -kMostTurned, kMostTurned, heading);
    WINDLASS_WITHIN(v, -kFastestShip, kFastestShip, surge, sway, rise);
    WINDLASS_WITHIN(v, -kFastestSwing, kFastestSwing, yaw_rate);
    WINDLASS_WITHIN(v, -2, 2, engine, rudder);
    WINDLASS_WITHIN(v, 0, kLongest, engine_started);
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
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, force, moment);
}
WINDLASS_STATE_LISTED(CablePull);

} // namespace windlass::physics
