#include "server/dds/convert.hpp"

#include "server/dds/wire_fields.hpp"
#include "server/physics/base/units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::dds {

namespace {

// Enumerators of the exercise stand in the order of the IDL.
static_assert(static_cast<int>(exercise::RunState::replay) == RUN_REPLAY);
static_assert(static_cast<int>(exercise::AnchorPhase::lost) == ANCHOR_LOST);
static_assert(static_cast<int>(exercise::Soil::mixed) == SOIL_MIXED);
static_assert(static_cast<int>(exercise::Stay::long_stay) == STAY_LONG);
static_assert(static_cast<int>(exercise::ClutchState::in) == CLUTCH_IN);
static_assert(static_cast<int>(exercise::Severity::alarm) == EVENT_ALARM);
static_assert(static_cast<int>(exercise::FaultPhase::cleared) == FAULT_PHASE_CLEARED);
static_assert(static_cast<int>(exercise::FaultTrigger::at_chance) == TRIGGER_AT_CHANCE);
static_assert(static_cast<int>(exercise::ModelLevel::catenary) == MODEL_CATENARY);
static_assert(static_cast<int>(exercise::StayGiven::long_stay) == STAY_GIVEN_LONG);
static_assert(static_cast<int>(exercise::Growing::tight) == GROWING_TIGHT);
static_assert(static_cast<int>(exercise::CableWeight::too_much) == WEIGHT_TOO_MUCH);
static_assert(static_cast<int>(exercise::BridgeOrderState::cancelled) == ORDER_CANCELLED);
static_assert(static_cast<int>(run::AlertPriority::emergency) == ALERT_EMERGENCY);
static_assert(static_cast<int>(run::AlertCondition::normal) == ALERT_NORMAL);
static_assert(static_cast<int>(run::PredictionState::foreign) == PREDICTION_FOREIGN);

/// Whatever is published says to which tick it belongs.
template <class From, class To>
void stamp(const From& from, To& to) {
    to.tick(from.tick);
    to.time(from.time);
}

/// And which of the cables.
template <class To>
void stamp(const exercise::Snapshot& from, const exercise::TackleView& tackle, To& to) {
    stamp(from, to);
    to_wire(tackle.side, to.side());
}

double compass_angle(double east, double north) {
    const double angle = std::atan2(east, north);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

} // namespace

void convert(const exercise::Snapshot& from, const run::RunStatus& run, ExerciseStatus& to) {
    stamp(from, to);
    to_wire(run, to);
    to_wire(run.title_trainee, to.title());
}

void convert(const exercise::Snapshot& from, const run::RunStatus& run, ExerciseTruth& to) {
    to_wire(from, to);
    to_wire(run, to);
    to_wire(run.title_instructor, to.title());
    to_wire(from.model_error.load, to.model_error_load());
    to_wire(from.model_error.shape, to.model_error_shape());
    to_wire(from.environment.depth, to.depth());
    for (std::size_t k = 0; k < to.faults().size(); ++k)
        to_wire(from.faults[k].order, to.faults()[k]);
}

void convert(const exercise::Snapshot& from, EnvironmentState& to) {
    stamp(from, to);
    to_wire(from.environment, to);
}

void convert(const exercise::Snapshot& from, ShipState& to) {
    const exercise::ShipView& ship = from.ship;
    stamp(from, to);
    to_wire(ship, to);
    const Eigen::Matrix3d axes = ship.attitude.toRotationMatrix(); // columns: forward, port, up
    to.pitch(std::asin(std::clamp(axes(2, 0), -1.0, 1.0)));
    to.roll(std::atan2(axes(2, 1), axes(2, 2)));
    to.speed_over_ground(std::hypot(ship.velocity.x(), ship.velocity.y()));
    to.course_over_ground(compass_angle(ship.velocity.x(), ship.velocity.y()));
}

void convert(const exercise::Snapshot& from, CableForce& to) {
    stamp(from, to);
    to_wire(from.cable_force, to.force());
    to_wire(from.cable_moment, to.moment());
    to.hawse().resize(from.tackle.size());
    for (std::size_t k = 0; k < from.tackle.size(); ++k) {
        to_wire(from.tackle[k], to.hawse()[k]);
        to_wire(from.tackle[k].hawse, to.hawse()[k].position());
    }
}

void convert(const exercise::Snapshot& from, const exercise::TackleView& tackle, AnchorState& to) {
    stamp(from, tackle, to);
    to_wire(tackle.anchor, to);
}

void convert(const exercise::Snapshot& from, const exercise::TackleView& tackle, ChainState& to) {
    stamp(from, tackle, to);
    to_wire(tackle.chain, to);
    to.cable_out_shackles(physics::shackles_from_metres(tackle.chain.cable_out));
}

void convert(const exercise::Snapshot& from, const exercise::TackleView& tackle, WindlassLoad& to) {
    const exercise::WindlassView& windlass = tackle.windlass;
    stamp(from, tackle, to);
    to_wire(windlass, to);
    to.utilisation(windlass.breaking_load > 0 ? windlass.hawse_tension / windlass.breaking_load : 0);
}

void convert(const exercise::ExerciseEvent& from, Event& to) {
    to_wire(from, to);
}

void convert(const run::AlertView& from, Alert& to) {
    to_wire(from, to);
}

void convert(const run::CheckpointView& from, Checkpoint& to) {
    to_wire(from, to);
}

void convert(const exercise::BridgeOrderView& from, std::uint64_t run, BridgeOrder& to) {
    to_wire(from, to);
    to_wire(from.given, to);
    to.run(run);
}

void convert(const run::QuestionView& from, Question& to) {
    to_wire(from, to);
}

void convert(const run::PredictionView& from, Prediction& to) {
    to_wire(from, to);
}

} // namespace windlass::dds
