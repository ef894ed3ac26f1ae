#pragma once
// The ship in surge, sway and yaw: wind, current, engine, rudder, thrusters, the pull of her cables and the
// drift of waves. What waves move her at their own pace is laid over that: heave, pitch, roll, and a little
// surge and sway; and so is how she floats: squat, and what ground under her keel makes of heave, heel, trim.
// Body axes here as seamen count: surge forward, sway to starboard, yaw clockwise.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/ship/flotation.hpp"
#include "server/physics/ship/ship_in_waves.hpp"

#include <Eigen/Geometry>

namespace windlass::physics {

/// Bridge orders.
struct Helm {
    double engine = 0;         ///< -1 full astern .. 1 full ahead
    double rudder = 0;         ///< rad, starboard positive
    double bow_thruster = 0;   ///< -1..1, bow to starboard
    double stern_thruster = 0; ///< -1..1, stern to starboard

    bool operator==(const Helm&) const = default;
};
template <class Visitor, StateOf<Helm> State>
void visit_state(Visitor& v, State& helm);

/// All that changes of a ship; a plain value.
struct ShipState {
    double x = 0, y = 0; ///< m east and north, midships, without what waves add
    double heading = 0;  ///< rad clockwise from north
    double surge = 0;    ///< m/s over ground
    double sway = 0;     ///< m/s over ground
    double yaw_rate = 0; ///< rad/s
    double engine = 0;   ///< -1..1: its revolutions squared over those of full ahead or astern, which is its
                         ///< share of the thrust while she lies still
    double engine_started = 0; ///< s, for which it stands and is being started as ordered
    double rudder = 0;         ///< rad, now
    WaveMotion waves;          ///< laid over it
    Flotation floats;          ///< and this
    double level = 0;          ///< m, world, of the still water in which she floats
    double rise = 0;           ///< m/s, at which it rises
};
template <class Visitor, StateOf<ShipState> State>
void visit_state(Visitor& v, State& state);

/// Cable's pull on the ship: world force (N) and moment about the vertical through midships (N m, clockwise).
struct CablePull {
    Vec3 force = Vec3::Zero();
    double moment = 0;
};
template <class Visitor, StateOf<CablePull> State>
void visit_state(Visitor& v, State& pull);

bool finite(const ShipState& state);        ///< no NaN or infinity
Vec3 forward(const ShipState& state);       ///< unit vector, world
Vec3 starboard(const ShipState& state);     ///< unit vector, world
Vec3 ship_velocity(const ShipState& state); ///< m/s over ground, world, midships, without what waves add
Vec3 wave_velocity(
    const ShipState& state);           ///< m/s, world, midships: what waves and flotation add, not the tide
Vec3 midships(const ShipState& state); ///< m, world, on her waterline, where waves have moved her
double roll(const ShipState& state);   ///< rad, starboard down, of waves and flotation together
double pitch(const ShipState& state);  ///< rad, bow up, of both
Vec3 spin(const ShipState& state);     ///< rad/s, world, of yaw and what waves add
/// Her axes (x forward, y to port, z up) into the world's.
Eigen::Quaterniond attitude(const ShipState& state);

/// Hawse pipe lip, m, world; side: -1 port, +1 starboard.
Vec3 hawse_position(const ShipDef& def, const ShipState& state, double side);
Vec3 hawse_velocity(const ShipDef& def, const ShipState& state, double side);

/// Adds a force (N, world) that acts at the hawse pipe lip of a side.
void add_pull(const ShipDef& def, const ShipState& state, double side, const Vec3& force, CablePull& pull);

} // namespace windlass::physics
