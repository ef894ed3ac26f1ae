#include "server/physics/ship/force_at_rest.hpp"

namespace windlass::physics {

namespace {

constexpr double kStep = 1e-3; ///< s: neither engine nor rudder comes far
constexpr double kPull = 1e6;  ///< N, of the size of what is looked for

/// m/s ahead and to starboard that she gains in the step.
Eigen::Vector2d gained(const ShipDef& def, const EnvironmentDef& environment, const Helm& helm,
                       const Vec3& pull, ShipState ship) {
    step_ship(def, environment, helm, {.force = pull}, kStep, ship);
    return {ship.surge, ship.sway};
}

} // namespace

Vec3 force_at_rest(const ShipDef& def, const EnvironmentDef& environment, const Helm& helm,
                   const ShipState& state) {
    ShipState ship = state;
    ship.surge = ship.sway = ship.yaw_rate = 0;
    const Vec3 ahead = forward(ship), abeam = starboard(ship);
    const Eigen::Vector2d free = gained(def, environment, helm, Vec3::Zero(), ship),
                          pulled = gained(def, environment, helm, kPull * (ahead + abeam), ship);
    const Eigen::Vector2d force = kPull * free.array() / (pulled - free).array();
    return force.x() * ahead + force.y() * abeam;
}

} // namespace windlass::physics
