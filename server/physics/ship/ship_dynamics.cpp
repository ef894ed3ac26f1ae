#include "server/physics/ship/ship_dynamics.hpp"

#include "server/physics/base/turn.hpp"
#include "server/physics/sea/current.hpp"
#include "server/physics/ship/grounding.hpp"
#include "server/physics/ship/wind.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

double toward(double value, double target, double max) {
    return value + std::clamp(target - value, -max, max);
}

} // namespace

ShipDynamics::Bearings ShipDynamics::bearings(const EnvironmentDef& environment,
                                              const ShipState& state) const {
    const Vec3 ahead = forward(state);
    return {ahead, {ahead.y(), -ahead.x(), 0}, mean_current(environment, def_.draught)};
}

PlanarForce ShipDynamics::outer_force(const EnvironmentDef& environment, const Bearings& bearings,
                                      double depth, const Helm& helm, const Machinery& machinery,
                                      const ShipState& state) {
    if (depth != depth_) {
        hull_ = in_depth(deep_, depth);
        depth_ = depth;
    }
    const auto& [ahead, abeam, current] = bearings;
    // Through the water: seen from a stream she moves as in still water.
    const double u = state.surge - current.dot(ahead), v = state.sway - current.dot(abeam);
    const double r = state.yaw_rate;
    PlanarForce force = hull_force(hull_, environment.water_density, u, v, r);
    force +=
        propulsion_force(def_, propulsion_, environment.water_density, state.engine, state.rudder, u, v, r);

    const Vec3 wind =
        -compass(environment.wind_from) * environment.wind_speed - (state.surge * ahead + state.sway * abeam);
    force += wind_force(def_, wind.norm(), std::atan2(-wind.dot(abeam), -wind.dot(ahead)));

    if (machinery.thrusters_available) {
        const double share = thruster_share(u), lever = 0.45 * def_.length_overall;
        const double bow = share * helm.bow_thruster * def_.bow_thruster;
        const double stern = share * helm.stern_thruster * def_.stern_thruster;
        force += {0, bow + stern, (bow - stern) * lever};
    }
    force += {state.waves.drift_ahead, state.waves.drift_abeam, 0};
    return force;
}

Vec3 ShipDynamics::force_at_rest(const EnvironmentDef& environment, const Helm& helm,
                                 const Machinery& machinery, const ShipState& state) {
    ShipState still = state;
    still.surge = still.sway = still.yaw_rate = 0;
    constexpr double kAnyStep = 1; // s: the ground's force is not asked for
    const double depth = keel_and_ground(def_, environment, still, kAnyStep).depth;
    const Bearings bearings = ShipDynamics::bearings(environment, still);
    const PlanarForce force = outer_force(environment, bearings, depth, helm, machinery, still);
    return force.x * bearings.ahead + force.y * bearings.abeam;
}

void ShipDynamics::step(const EnvironmentDef& environment, const Helm& helm, const Machinery& machinery,
                        const CablePull& pull, double dt, ShipState& state) {
    assert(dt > 0 && "a step takes time");
    step_engine(def_, helm.engine, machinery.engine_available, dt, state);
    if (machinery.steering_available)
        state.rudder = toward(state.rudder, std::clamp(helm.rudder, -def_.rudder_max, def_.rudder_max),
                              def_.rudder_rate * dt);
    const KeelAndGround ground = keel_and_ground(def_, environment, state, dt);
    const Bearings bearings = ShipDynamics::bearings(environment, state);
    const auto& [ahead, abeam, current] = bearings;
    PlanarForce force = outer_force(environment, bearings, ground.depth, helm, machinery, state);
    force += ground.force;
    force += {pull.force.dot(ahead), pull.force.dot(abeam), pull.moment};

    const double set_ahead = current.dot(ahead), set_abeam = current.dot(abeam);
    const double u = state.surge - set_ahead, v = state.sway - set_abeam, r = state.yaw_rate;
    // Forces of the axes' turning. What of added mass turns a hull that drifts is in the hull's N_v.
    const double mass_surge = hull_.mass + hull_.added_surge, mass_sway = hull_.mass + hull_.added_sway;
    force.x += mass_sway * v * r;
    force.y -= mass_surge * u * r;
    // The stream turns, seen from axes that turn.
    state.surge += dt * (force.x / mass_surge + set_abeam * r);
    state.sway += dt * (force.y / mass_sway - set_ahead * r);
    state.yaw_rate += dt * force.moment / (hull_.inertia + hull_.added_yaw);
    step_flotation(def_, hydrostatics_, squat(def_, ground.depth, u), ground.lift, dt, state.floats);

    const Vec3 velocity = state.surge * ahead + state.sway * abeam;
    state.x += dt * velocity.x();
    state.y += dt * velocity.y();
    state.heading = remainder_of_turn(state.heading + dt * state.yaw_rate, 2 * std::numbers::pi);
}

} // namespace windlass::physics
