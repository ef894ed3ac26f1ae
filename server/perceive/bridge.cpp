// What the bridge's instruments show, and which of them work.

#include "server/perceive/perceive.hpp"
#include "server/perceive/senses.hpp"

#include "server/exercise/talk/talk.hpp"
#include "server/physics/sea/current.hpp"

namespace windlass::perceive {

namespace {

/// What a fault of the ship takes away. In a blackout GPS, gyro and VHF go on from the emergency supply.
struct Failure {
    exercise::FaultCode fault;
    bool Instruments::*fails;
};
constexpr std::array kFailures{
    Failure{exercise::FaultCode::vhf_lost, &Instruments::vhf},
    Failure{exercise::FaultCode::cctv_lost, &Instruments::cctv},
    Failure{exercise::FaultCode::ship_blackout, &Instruments::log},
    Failure{exercise::FaultCode::ship_blackout, &Instruments::anemometer},
    Failure{exercise::FaultCode::ship_blackout, &Instruments::echo_sounder},
    Failure{exercise::FaultCode::ship_blackout, &Instruments::cctv},
};
/// m/s, ahead: over ground, less what the water does where the log is, at the keel.
double through_water(const exercise::Snapshot& s, double draught) {
    const exercise::Weather& sea = s.environment.now;
    const physics::Vec3 current =
        physics::current_at(sea.current_speed, sea.current_towards, sea.current_profile, -draught);
    return s.ship.surge - current.dot(physics::compass(s.ship.heading));
}

} // namespace

Instruments working(const std::vector<exercise::FaultView>& faults) {
    Instruments works;
    for (const exercise::FaultView& fault : faults) {
        if (fault.phase != exercise::FaultPhase::active || fault.severity_now < exercise::kSetDead) continue;
        for (const Failure& failure : kFailures)
            if (failure.fault == fault.order.code) works.*failure.fails = false;
    }
    return works;
}

void perceive_bridge(const exercise::Snapshot& from, const SeatShip& ship, BridgeView& to) {
    const exercise::ShipView& own = from.ship;
    const Instruments works = working(from.faults);
    to.tick(from.tick);
    to.time(from.time);

    // GPS
    const double over_ground = in_steps(std::hypot(own.velocity.x(), own.velocity.y()), 0.1 * kKnot);
    const bool moves = works.gps && over_ground > 0; // at rest it has no course
    to.gps_works(works.gps);
    to.position().x(works.gps ? in_steps(own.position.x(), 1) : 0);
    to.position().y(works.gps ? in_steps(own.position.y(), 1) : 0);
    to.position().z(works.gps ? in_steps(own.position.z(), 1) : 0);
    to.speed_over_ground(works.gps ? over_ground : 0);
    to.course_over_ground(moves ? round_the_compass(std::atan2(own.velocity.x(), own.velocity.y()), 3600)
                                : 0);

    // Gyro
    to.gyro_works(works.gyro);
    to.heading(works.gyro ? round_the_compass(own.heading, 3600) : 0);
    to.rate_of_turn(works.gyro ? own.yaw_rate : 0);

    // Log
    to.log_works(works.log);
    to.speed_through_water(works.log ? in_steps(through_water(from, ship.draught), 0.1 * kKnot) : 0);

    // Clinometers, and indicators of what helm, engine and thrusters do
    to.roll(tilt(own).roll);
    to.pitch(tilt(own).pitch);
    to.engine(own.engine);
    to.rudder(own.rudder);
    to.bow_thruster(own.bow_thruster);
    to.stern_thruster(own.stern_thruster);

    // Telegraph, wheel and levers, as they stand
    to.engine_ordered(own.engine_ordered);
    to.rudder_ordered(own.rudder_ordered);
    to.bow_thruster_ordered(own.bow_thruster_ordered);
    to.stern_thruster_ordered(own.stern_thruster_ordered);

    // Anemometer
    const ApparentWind wind = apparent_wind(from);
    to.anemometer_works(works.anemometer);
    to.wind_speed_apparent(works.anemometer ? wind.speed : 0);
    to.wind_from_apparent(works.anemometer ? wind.from_bow : 0);

    // Echo sounder, under the bow: it shows no less than nothing
    to.echo_sounder_works(works.echo_sounder);
    const double rises =
        own.position.z() + (own.attitude * physics::Vec3(ship.sounder, 0, 0)).z(); // with her bow
    const double below = from.environment.depth - ship.draught_at_sounder + rises;
    to.depth_below_keel(works.echo_sounder ? in_steps(std::max(0.0, below), 0.1) : 0);

    // Eyes and clock
    to.visibility(from.environment.now.visibility);
    to.time_of_day(from.environment.now.time_of_day);
    to.vhf_works(works.vhf);
    to.cctv_works(works.cctv);
}

} // namespace windlass::perceive
