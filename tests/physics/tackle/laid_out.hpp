#pragma once
// Cable laid out over the bottom, as several tests begin.

#include "rigs/tackle_rig.hpp"

namespace windlass::physics {

/// From an anchor that hangs, gear out and brake open: lets it go and lays out 100 m of cable, moving off at
/// way (m/s, world), lies still at long stay, and puts the gear in with the brake open. False: one of these
/// did not come about in time.
inline bool lay_out_and_gear_in(rigs::TackleRig& rig, const Vec3& way) {
    rig.levers.clutch_in = false;
    rig.lip_velocity = 0.4 * way;
    if (!rig.run_until([&] { return rig.windlass().cable_out > 30; }, 30)) return false;
    rig.grip(0.01);
    rig.lip_velocity = way;
    if (!rig.run_until([&] { return rig.windlass().cable_out > 100; }, 200)) return false;
    rig.levers.brake = 1;
    if (!rig.run_until([&] { return rig.deck().hawse_tension > 1.5e5; }, 200)) return false;
    rig.lip_velocity.setZero();
    rig.run(60);
    rig.levers.clutch_in = true;
    rig.run(1);
    rig.levers.brake = 0;
    rig.run(5);
    return true;
}

} // namespace windlass::physics
