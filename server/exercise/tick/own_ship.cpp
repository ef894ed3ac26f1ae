#include "server/exercise/tick/own_ship.hpp"

#include "server/physics/base/state_limits.hpp"

#include <cmath>

namespace windlass::exercise {

using namespace physics;

namespace {

/// s between two looks at what the ship would ask of her cables at rest: engine, gusts and drift change
/// slower.
constexpr double kLookAtRest = 0.5;

/// s after a blackout at which the emergency generator must bear its load, the steering gear among it (SOLAS
/// II-1/42, 43: 45 s).
constexpr double kEmergencySupply = 45;

/// What a blackout leaves: steering, once the emergency supply is up.
Machinery machinery_of(const FaultBook& faults, double time) {
    const double dark = faults.seconds_of(FaultCode::ship_blackout, time);
    return {.engine_available = dark < 0,
            .steering_available = dark < 0 || dark >= kEmergencySupply,
            .thrusters_available = dark < 0};
}

} // namespace

OwnShip::OwnShip(const ShipDef& def, const ShipState& start, const SeaSurface& sea, double depth)
    : def_(def), in_waves_(def, depth), dynamics_(def), ship_(start) {
    ship_.waves = wave_motion(sea, 0);
}

/// What the waves do to her at a time (s).
WaveMotion OwnShip::wave_motion(const SeaSurface& sea, double time) {
    const Vec3 velocity = ship_velocity(ship_);
    return in_waves_.motion(sea, {ship_.x, ship_.y, ship_.heading, velocity.x(), velocity.y()}, time);
}

/// A telegraph that has failed passes no order on, and a thruster without power takes none.
void OwnShip::answer_helm(const Machinery& machinery, const FaultBook& faults, double time) {
    const double engine = answers_.engine;
    answers_ = helm_;
    if (!machinery.thrusters_available) answers_.bow_thruster = answers_.stern_thruster = 0;
    if (faults.seconds_of(FaultCode::telegraph_failed, time) >= 0) answers_.engine = engine;
}

bool OwnShip::step(const Surroundings& surroundings, double rise, const FaultBook& faults, double dt,
                   double time, const EventLog& log) {
    const EnvironmentDef& environment = surroundings.environment();
    const Machinery machinery = machinery_of(faults, time);
    ship_.level = environment.level, ship_.rise = rise;
    answer_helm(machinery, faults, time);
    if (foreign_ship_.drive(time) == ForeignShip::Drive::none) {
        dynamics_.step(environment, answers_, machinery, pull_, dt, ship_);
        ship_.waves = wave_motion(surroundings.sea(), time);
        foreign_ship_.fade(time, ship_.waves);
    } else {
        foreign_ship_.place(time, ship_);
    }
    tell_who_sails_her(time, log);
    pull_ = {};
    if (!finite(ship_)) return false;
    if (std::llround(time / dt) % std::llround(kLookAtRest / dt) == 1)
        at_rest_ = dynamics_.force_at_rest(environment, answers_, machinery, ship_);
    return true;
}

void OwnShip::pulled_by(const CablePull& pull) {
    pull_.force += pull.force;
    pull_.moment += pull.moment;
}

/// When it changes.
void OwnShip::tell_who_sails_her(double time, const EventLog& log) {
    const ForeignShip::Drive was = foreign_drive_, now = foreign_ship_.drive(time);
    if (now == was) return;
    foreign_drive_ = now;
    switch (now) {
    case ForeignShip::Drive::none:
        return log("own_ship.handed_back", -1, 0);
    case ForeignShip::Drive::fresh:
        return log("own_ship.foreign", -1, 0);
    case ForeignShip::Drive::late:
        return log("own_ship.late", -1, ForeignShip::kLate);
    case ForeignShip::Drive::held:
        return log("own_ship.lost", -1, ForeignShip::kStill);
    }
}

void OwnShip::steer(const Helm& ordered, const SeaSurface& sea, double time) {
    const auto drive = foreign_ship_.drive(time);
    const bool unheard = drive == ForeignShip::Drive::late || drive == ForeignShip::Drive::held;
    if (unheard && !(ordered == helm_)) foreign_ship_.release(time, wave_motion(sea, time), ship_);
    helm_ = ordered;
}

void OwnShip::follow(const OwnShipSample& sample, double time, const EventLog& log) {
    const auto answer = foreign_ship_.hear(sample, time, ship_);
    if (answer == ForeignShip::Answer::jumped && !foreign_jumped_)
        log("own_ship.jumped", -1, (sample.position + ship_.level * Vec3::UnitZ() - midships(ship_)).norm());
    foreign_jumped_ = answer == ForeignShip::Answer::jumped;
}

ShipState OwnShip::expected(const SeaSurface& sea, double time) {
    ShipState next = ship_;
    next.waves = wave_motion(sea, time);
    if (foreign_ship_.drive(time) == ForeignShip::Drive::none)
        foreign_ship_.fade(time, next.waves);
    else
        foreign_ship_.place(time, next);
    return next;
}

void OwnShip::hold(const StateVisitor& v, double level) const {
    v.within({"ship.level"}, ship_.level, level, level);
    const Vec3& at_rest = at_rest_; // by the name that the state has it under
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, at_rest);
    for (const Helm& levers : {helm_, answers_}) {
        v.within({"helm.engine"}, levers.engine, -1, 1);
        v.within({"helm.rudder"}, levers.rudder, -def_.rudder_max, def_.rudder_max);
        v.within({"helm.bow_thruster"}, levers.bow_thruster, -1, 1);
        v.within({"helm.stern_thruster"}, levers.stern_thruster, -1, 1);
    }
}

template <class Visitor, StateOf<OwnShip> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.ship_, self.foreign_ship_, self.foreign_drive_, self.foreign_jumped_, self.helm_,
                   self.answers_, self.pull_, self.at_rest_);
}
WINDLASS_STATE_LISTED(OwnShip);

} // namespace windlass::exercise
