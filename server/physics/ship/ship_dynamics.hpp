#pragma once
// How a ship moves under wind, current, engine, rudder, thrusters, the pull of her cables, the drift of
// waves, and the ground where she touches it; and how she floats meanwhile.

#include "server/physics/sea/environment.hpp"
#include "server/physics/ship/engine.hpp"
#include "server/physics/ship/hull_force.hpp"
#include "server/physics/ship/propulsion.hpp"
#include "server/physics/ship/ship.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// One ship in surge, sway and yaw, with her squat, and heave, heel and trim aground. Keeps nothing that
/// changes but what follows from the depth.
class ShipDynamics {
public:
    explicit ShipDynamics(const ShipDef& def)
        : ShipDynamics(def, hull_coefficients(def), propulsion_coefficients(def)) {}
    /// A ship whose coefficients were measured.
    ShipDynamics(const ShipDef& def, const HullCoefficients& deep, const PropulsionCoefficients& propulsion)
        : def_(def), deep_(deep), hull_(deep), hydrostatics_(def), propulsion_(propulsion) {}

    /// Advances by dt (s) under the mean cable pull of the step and the drift of the waves. Leaves the motion
    /// that waves lay over it as it is.
    void step(const EnvironmentDef& environment, const Helm& helm, const Machinery& machinery,
              const CablePull& pull, double dt, ShipState& state);

    /// What the elements ask of a ship that lies still: level force (N, world) of wind, stream, wave drift,
    /// engine, rudder and thrusters on her, were she at rest over the ground on her present heading. The load
    /// of her cables once she is brought up.
    Vec3 force_at_rest(const EnvironmentDef& environment, const Helm& helm, const Machinery& machinery,
                       const ShipState& state);

private:
    /// World, worked out once a step: each sine costs as much as a dozen products.
    struct Bearings {
        Vec3 ahead, abeam; ///< unit vectors
        Vec3 current;      ///< m/s, mean over her draught
    };
    Bearings bearings(const EnvironmentDef& environment, const ShipState& state) const;

    /// Of all but her cables and the ground, in water of that depth (m); forces of the axes' turning left
    /// out.
    PlanarForce outer_force(const EnvironmentDef& environment, const Bearings& bearings, double depth,
                            const Helm& helm, const Machinery& machinery, const ShipState& state);

    ShipDef def_;
    HullCoefficients deep_, hull_; ///< hull_: where the water is depth_ deep
    double depth_ = -1;            ///< m; -1: hull_ is of no depth yet
    Hydrostatics hydrostatics_;
    PropulsionCoefficients propulsion_;
};

} // namespace windlass::physics
