#pragma once
// A windlass alone on the test bench: the chain is a force.

#include "server/physics/windlass/windlass.hpp"

namespace windlass::rigs {

/// A gypsy alone on which the chain pulls with a constant force (N): the top link yields nothing.
struct GypsyBench {
    physics::WindlassDef def;
    physics::ChainDef chain;
    physics::Windlass windlass;
    physics::WindlassLevers levers;
    physics::EquipmentFaults causes;
    double dt = 1.0 / 300;
    physics::CableInHawse cable;

    /// cable_out: m; less than none is in the hawse pipe, where there is less to lift.
    explicit GypsyBench(const physics::WindlassDef& d = {}, const physics::ChainDef& c = {},
                        double cable_out = 100)
        : def(d), chain(c), windlass(d, c, {-1e6, 1e6}, cable_out) {}

    void run(double seconds, double pull) {
        for (int k = 0; k < seconds / dt; ++k) {
            const physics::TopLink link{
                .dt = dt, .pull = pull, .yielding = 1e-3, .outboard_mass = 0, .outboard_pull = 0};
            const physics::DriveLine drive(windlass.prepare(dt, levers, causes, cable));
            windlass.settle(dt, drive.result(link), causes, nullptr);
        }
    }
    template <class Condition>
    bool run_until(const Condition& condition, double pull, double max_seconds) {
        for (double t = 0; t < max_seconds && !condition(); t += dt)
            run(0.99 * dt, pull); // one step
        return condition();
    }
    const physics::WindlassState& state() const { return windlass.state(); }
    double speed() const { return windlass.state().cable_speed; }
    /// Pull outboard (N) that leaves the motor the given pull behind its gear while heaving.
    double heaving_pull(double motor_pull) const {
        const double g = chain.mass_per_metre * physics::kGravity;
        return (motor_pull + g * def.locker_lift) * physics::hawse_efficiency(cable.bend) -
               g * def.hawse_pipe_height;
    }
    /// Clutch in, brake off, lever as given.
    void drive(double lever) {
        levers.clutch_in = true;
        run(0.1, 0);
        levers.brake = windlass.state().brake.position = 0;
        levers.speed = lever;
    }
    /// Pull outboard (N) that loads the brake with the given force while the chain is about to run out.
    double pull_for(double brake_force) const {
        const double g = chain.mass_per_metre * physics::kGravity;
        return (brake_force + g * def.locker_lift) / physics::hawse_efficiency(cable.bend) -
               g * def.hawse_pipe_height;
    }
};

} // namespace windlass::rigs
