#pragma once
// Ground tackle on a hull that does as it is told: the rig of the windlass and anchor tests.

#include "server/physics/tackle/ground_tackle.hpp"

namespace windlass::rigs {

/// One substep of dt (s) of a tackle that no other cable lies across: both halves at once.
inline void step_tackle(physics::GroundTackle& tackle, const physics::EnvironmentDef& environment, double dt,
                        const physics::WindlassLevers& levers, const physics::EquipmentFaults& causes,
                        const physics::Vec3& lip, const physics::HullSurface* hull = nullptr) {
    if (tackle.begin(environment, dt, levers, causes, lip, hull)) tackle.finish(environment, causes);
}

/// Levers and lip in the hand of the test; 300 Hz as in the exercises.
struct TackleRig {
    physics::EnvironmentDef environment;
    physics::TackleSetup setup;
    physics::GroundTackle tackle;
    physics::WindlassLevers levers;
    physics::EquipmentFaults causes;
    physics::Vec3 lip{0, 0, 6};
    physics::Vec3 lip_velocity = physics::Vec3::Zero(); ///< m/s
    physics::HullSurface hull; ///< of a ship that moves with the lip, her axes along the world's; or none
    physics::Vec3 lip_on_board = physics::Vec3::Zero(); ///< m, in her frame
    double dt = 1.0 / 300;

    TackleRig(const physics::TackleSetup& s, const physics::EnvironmentDef& sea)
        : environment(sea), setup(s), tackle(s, sea, {0, 0, 6}) {
        levers.brake = s.brake;
        levers.clutch_in = s.clutch_in;
        levers.stopper_closed = s.stopper_closed;
    }

    /// Sets the hand-wheel where the brake grips with a share (0..1) of its rating; 0: the lining just clear.
    void grip(double share) { levers.brake = physics::position_of_grip(setup.windlass, share); }

    void step() {
        const int substeps = tackle.substeps(dt, 16);
        for (int k = 0; k < substeps; ++k) {
            hull.motion.position = lip - lip_on_board;
            hull.motion.velocity = lip_velocity;
            lip += lip_velocity * (dt / substeps);
            step_tackle(tackle, environment, dt / substeps, levers, causes, lip, &hull);
        }
    }
    void run(double seconds) {
        const int steps = static_cast<int>(std::lround(seconds / dt));
        for (int k = 0; k < steps; ++k)
            step();
    }
    /// Runs until the condition holds; false when it did not within the given time (s).
    template <class Condition>
    bool run_until(const Condition& condition, double max_seconds) {
        const int steps = static_cast<int>(std::lround(max_seconds / dt));
        for (int k = 0; k < steps; ++k) {
            if (condition()) return true;
            step();
        }
        return condition();
    }

    const physics::WindlassState& windlass() const { return tackle.windlass().state(); }
    const physics::DeckResult& deck() const { return tackle.windlass().loads().deck; }
};

inline physics::EnvironmentDef quiet_water(double depth) {
    physics::EnvironmentDef environment;
    environment.depth = depth;
    environment.current_speed = 0;
    return environment;
}

} // namespace windlass::rigs
