#include "server/exercise/state_hash.hpp"

namespace windlass::exercise {

void StateHash::add(const physics::ShipState& ship) {
    for (const double value :
         {ship.x, ship.y, ship.heading, ship.surge, ship.sway, ship.yaw_rate, ship.engine, ship.rudder}) {
        add(value);
    }
}

void StateHash::add(const physics::GroundTackle& tackle) {
    const physics::ChainState& chain = tackle.chain();
    add(chain.links);
    add(chain.asleep);
    add(chain.top_length), add(chain.last_step);
    for (int i = 0; i <= chain.links; ++i)
        add(chain.position.at(i)), add(chain.velocity.at(i));
    for (int i = 0; i < chain.links; ++i)
        add(physics::Vec3(chain.tension[i], chain.tension_before[i], 0));

    const physics::SleepState sleep = tackle.sleep();
    add(physics::Vec3(sleep.to_look, sleep.still_for, sleep.holds));
    add(physics::Vec3(sleep.still_links, sleep.weakest, sleep.settling)), add(sleep.settled),
        add(sleep.margin_height);

    const physics::QuietState quiet = tackle.quiet();
    add(physics::Vec3(quiet.active, quiet.to_look, quiet.agreed_for)), add(quiet.correction);
    add(quiet.lip), add(quiet.lip_velocity), add(quiet.lip_acceleration), add(quiet.toward);
    add(physics::Vec3(quiet.drag, quiet.found.load, quiet.found.shape));

    const physics::WindlassState& w = tackle.windlass().state();
    for (const double value : {w.cable_speed, w.cable_out, w.brake.position, w.brake.skin, w.brake.drum,
                               w.brake.water, w.brake.glaze, w.brake.heat, w.motor.speed, w.motor.target,
                               w.motor.overload, w.motor.worst_speed, w.clutch.claw_offset}) {
        add(value);
    }
    const int flags = w.last_direction + 4 * static_cast<int>(w.clutch.position) + 16 * w.stopper.closed +
                      32 * w.motor.tripped + 64 * w.motor.overspeed + 128 * w.motor.burst +
                      256 * w.clutch.sheared + 512 * w.gypsy.jumping + 1024 * w.stopper.sprung;
    add(flags);

    const physics::AnchorPose pose = tackle.anchor().pose();
    add(pose.position), add(pose.velocity), add(pose.spin), add(pose.attitude.vec()), add(pose.attitude.w());
    const physics::HoldingState& holding = tackle.anchor().holding();
    add(holding.embedment), add(holding.dragged), add(holding.overrun);
}

} // namespace windlass::exercise
