#include "server/dds/convert.hpp"
#include "server/dds/last_codes.hpp"

#include "common/text.hpp"
#include "server/physics/base/units.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::server {

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
static_assert(static_cast<int>(AlertPriority::emergency) == ALERT_EMERGENCY);
static_assert(static_cast<int>(AlertCondition::normal) == ALERT_NORMAL);

void copy(const physics::Vec3& from, Vec3& to) {
    to.x(from.x());
    to.y(from.y());
    to.z(from.z());
}

void copy(const Eigen::Vector3f& from, Point3f& to) {
    to.x(from.x());
    to.y(from.y());
    to.z(from.z());
}

void copy(const Eigen::Quaterniond& from, Quaternion& to) {
    to.w(from.w());
    to.x(from.x());
    to.y(from.y());
    to.z(from.z());
}

template <class FixedString>
void copy(const std::string& from, FixedString& to) {
    to = std::string(clipped(from, FixedString::max_size));
}

/// Whatever is published says to which tick it belongs.
template <class From, class To>
void stamp(const From& from, To& to) {
    to.tick(from.tick);
    to.time(from.time);
}

double compass_angle(double east, double north) {
    const double angle = std::atan2(east, north);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

} // namespace

void convert(const exercise::Snapshot& from, const RunStatus& run, ExerciseStatus& to) {
    stamp(from, to);
    to.state(static_cast<RunState>(run.state));
    to.time_scale(run.time_scale);
    to.time_scale_achieved(run.time_scale_achieved);
    copy(run.exercise, to.exercise());
    copy(run.title_trainee, to.title());
    to.run(run.run);
}

void convert(const exercise::Snapshot& from, const RunStatus& run, ExerciseTruth& to) {
    constexpr std::size_t kFaultsOnTheWire = 96; // as many as there are codes and sides
    static_assert(kFaultsOnTheWire >= 2 * (kLastFault + 1));
    stamp(from, to);
    copy(run.title, to.title());
    to.state_hash(from.state_hash);
    to.definition_hash(run.definition_hash);
    to.run(run.run);
    to.orders_taken(run.orders_taken);
    to.lateness(run.lateness);
    to.overruns(run.overruns);
    to.commands_refused(run.commands_refused);
    to.samples_dropped(run.samples_dropped);
    to.model_level(static_cast<ModelLevel>(from.model_level));
    to.model_nodes(from.model_nodes);
    to.model_substeps(from.model_substeps);
    to.model_error_load(from.model_error.load);
    to.model_error_shape(from.model_error.shape);
    to.depth(from.environment.depth);
    to.faults().resize(std::min(from.faults.size(), kFaultsOnTheWire));
    for (std::size_t i = 0; i < to.faults().size(); ++i) {
        const auto& fault = from.faults[i];
        auto& out = to.faults()[i];
        out.code(static_cast<FaultCode>(fault.order.code));
        out.side(static_cast<int>(fault.order.side));
        out.phase(static_cast<FaultPhase>(fault.phase));
        out.severity(fault.order.severity);
        out.severity_now(fault.severity_now);
        out.ramp(fault.order.ramp);
        out.trigger(static_cast<FaultTrigger>(fault.order.trigger));
        out.trigger_value(fault.order.trigger_value);
        out.trigger_until(fault.order.trigger_until);
        copy(fault.order.trigger_event, out.trigger_event());
        out.trigger_order(static_cast<std::int32_t>(fault.order.trigger_order));
        out.target(fault.order.target);
    }
}

void convert(const exercise::Weather& from, Weather& to) {
    to.wind_speed(from.wind_speed);
    to.wind_from(from.wind_from);
    to.gust_factor(from.gust_factor);
    to.gust_period(from.gust_period);
    to.veering(from.veering);
    to.wave_height(from.wave_height);
    to.wave_period(from.wave_period);
    to.wave_from(from.wave_from);
    to.swell_height(from.swell_height);
    to.swell_period(from.swell_period);
    to.swell_from(from.swell_from);
    to.wave_seed(from.wave_seed);
    to.current_speed(from.current_speed);
    to.current_towards(from.current_towards);
    constexpr std::size_t kLayersOnTheWire = 64; // as many as a definition may have
    to.current_profile().resize(std::min(from.current_profile.size(), kLayersOnTheWire));
    for (std::size_t i = 0; i < to.current_profile().size(); ++i) {
        to.current_profile()[i].depth(from.current_profile[i].depth);
        to.current_profile()[i].share(from.current_profile[i].share);
        to.current_profile()[i].turn(from.current_profile[i].turn);
    }
    to.tide_height(from.tide_height);
    to.visibility(from.visibility);
    to.time_of_day(from.time_of_day);
}

void convert(const exercise::Snapshot& from, EnvironmentState& to) {
    stamp(from, to);
    convert(from.environment.now, to.now());
    convert(from.environment.after, to.after());
    to.ramp_left(from.environment.ramp_left);
}

void convert(const exercise::Snapshot& from, ShipState& to) {
    const auto& ship = from.ship;
    stamp(from, to);
    copy(ship.position, to.position());
    copy(ship.attitude, to.attitude());
    to.heading(ship.heading);
    const Eigen::Matrix3d axes = ship.attitude.toRotationMatrix(); // columns: forward, port, up
    to.pitch(std::asin(std::clamp(axes(2, 0), -1.0, 1.0)));
    to.roll(std::atan2(axes(2, 1), axes(2, 2)));
    copy(ship.velocity, to.velocity());
    to.surge(ship.surge);
    to.sway(ship.sway);
    to.yaw_rate(ship.yaw_rate);
    to.speed_over_ground(std::hypot(ship.velocity.x(), ship.velocity.y()));
    to.course_over_ground(compass_angle(ship.velocity.x(), ship.velocity.y()));
    to.engine(ship.engine);
    to.rudder(ship.rudder);
    to.bow_thruster(ship.bow_thruster);
    to.stern_thruster(ship.stern_thruster);
}

void convert(const exercise::Snapshot& from, CableForce& to) {
    stamp(from, to);
    copy(from.cable_force, to.force());
    copy(from.cable_moment, to.moment());
    to.hawse().resize(from.tackle.size());
    for (std::size_t i = 0; i < from.tackle.size(); ++i) {
        to.hawse()[i].side(static_cast<int>(from.tackle[i].side));
        copy(from.tackle[i].hawse, to.hawse()[i].position());
        copy(from.tackle[i].force, to.hawse()[i].force());
    }
}

void convert(const exercise::Snapshot& from, const exercise::TackleView& tackle, AnchorState& to) {
    const auto& anchor = tackle.anchor;
    stamp(from, to);
    to.side(static_cast<int>(tackle.side));
    to.phase(static_cast<AnchorPhase>(anchor.phase));
    copy(anchor.position, to.position());
    copy(anchor.attitude, to.attitude());
    copy(anchor.velocity, to.velocity());
    copy(anchor.shackle, to.shackle());
    to.height_above_bottom(anchor.height_above_bottom);
    to.holding_capacity(anchor.holding_capacity);
    to.holding_used(anchor.holding_used);
    to.uplift(anchor.uplift);
    to.embedment(anchor.embedment);
    to.dragged(anchor.dragged);
    to.soil(static_cast<Soil>(anchor.soil));
    to.fluke_angle(anchor.fluke_angle);
    to.weight(anchor.weight);
    to.carried(anchor.carried);
    to.breakout(anchor.breakout);
    to.bent(anchor.bent);
    to.fouled(anchor.fouled);
}

void convert(const exercise::Snapshot& from, const exercise::TackleView& tackle, ChainState& to) {
    const auto& chain = tackle.chain;
    stamp(from, to);
    to.side(static_cast<int>(tackle.side));
    to.cable_out(chain.cable_out);
    to.cable_out_shackles(physics::shackles_from_metres(chain.cable_out));
    to.lead_clock(chain.lead_clock);
    to.stay(static_cast<Stay>(chain.stay));
    to.top_angle(chain.top_angle);
    to.on_bottom(chain.on_bottom);
    to.turns(chain.turns);
    to.largest_tension(chain.largest_tension);
    to.stretched(chain.stretched);
    to.stretch(chain.stretch);
    to.nodes().resize(chain.nodes.size());
    for (std::size_t i = 0; i < chain.nodes.size(); ++i)
        copy(chain.nodes[i], to.nodes()[i]);
    to.tension().assign(chain.tension.begin(), chain.tension.end());
    constexpr std::size_t kMarksOnTheWire = 64;
    to.marks().resize(std::min(chain.marks.size(), kMarksOnTheWire));
    for (std::size_t i = 0; i < to.marks().size(); ++i) {
        const exercise::MarkView& mark = chain.marks[i];
        CableMark& out = to.marks()[i];
        out.shackle(mark.shackle);
        out.outboard(static_cast<float>(mark.outboard));
        out.white_links(mark.white_links);
        out.last(mark.last);
        copy(mark.position, out.position());
    }
}

void convert(const exercise::Snapshot& from, const exercise::TackleView& tackle, WindlassLoad& to) {
    const auto& windlass = tackle.windlass;
    stamp(from, to);
    to.side(static_cast<int>(tackle.side));
    to.hawse_tension(windlass.hawse_tension);
    to.gypsy_load(windlass.gypsy_load);
    to.gypsy_load_indicated(windlass.gypsy_load_indicated);
    to.brake_load(windlass.brake_load);
    to.stopper_load(windlass.stopper_load);
    to.motor_load(windlass.motor_load);
    to.shaft_brake_load(windlass.shaft_brake_load);
    to.bitter_end_load(windlass.bitter_end_load);
    to.spurling_pipe_load(windlass.spurling_pipe_load);
    to.locker_load(windlass.locker_load);
    to.breaking_load(windlass.breaking_load);
    to.utilisation(windlass.breaking_load > 0 ? windlass.hawse_tension / windlass.breaking_load : 0);
    to.brake_capacity(windlass.brake_capacity);
    to.lining_friction(windlass.lining_friction);
    to.brake_rating(windlass.brake_rating);
    to.cable_out(windlass.cable_out);
    to.cable_out_indicated(windlass.cable_out_indicated);
    to.cable_speed(windlass.cable_speed);
    to.gypsy_speed(windlass.gypsy_speed);
    to.gypsy_turn(windlass.gypsy_turn);
    to.brake_position(windlass.brake_position);
    to.brake_torque(windlass.brake_torque);
    to.brake_power(windlass.brake_power);
    to.brake_energy(windlass.brake_energy);
    to.brake_wear(windlass.brake_wear);
    to.lining_temperature(windlass.lining_temperature);
    to.drum_temperature(windlass.drum_temperature);
    to.motor_torque(windlass.motor_torque);
    to.motor_speed(windlass.motor_speed);
    to.motor_current(windlass.motor_current);
    to.motor_pressure(windlass.motor_pressure);
    to.motor_temperature(windlass.motor_temperature);
    to.speed_lever(windlass.speed_lever);
    to.power(windlass.power);
    to.tripped(windlass.tripped);
    to.emergency_stop(windlass.emergency_stop);
    to.stopper_closed(windlass.stopper_closed);
    to.clutch(static_cast<ClutchState>(windlass.clutch));
    to.clutch_offset(windlass.clutch_offset);
    to.clutch_sheared(windlass.clutch_sheared);
    to.gypsy_jumping(windlass.gypsy_jumping);
    to.stopper_sprung(windlass.stopper_sprung);
    to.motor_burst(windlass.motor_burst);
}

void convert(const exercise::ExerciseEvent& from, Event& to) {
    stamp(from, to);
    to.number(from.number);
    to.severity(static_cast<EventSeverity>(from.severity));
    copy(from.code, to.code());
    to.side(from.side);
    to.value(from.value);
    copy(from.text, to.text());
}

void convert(const AlertView& from, Alert& to) {
    stamp(from, to);
    copy(from.code, to.code());
    to.side(from.side);
    to.raised_time(from.raised_time);
    to.priority(static_cast<windlass::AlertPriority>(from.priority));
    to.condition(static_cast<windlass::AlertCondition>(from.condition));
    to.silenced_left(from.silenced_left);
    to.deck_panel(from.deck_panel);
    to.bridge_panel(from.bridge_panel);
    to.value(from.value);
    copy(from.text, to.text());
    copy(from.explanation, to.explanation());
}

void convert(const CheckpointView& from, Checkpoint& to) {
    to.tick(from.tick);
    to.time(from.time);
    to.state_hash(from.state_hash);
    to.definition_hash(from.definition_hash);
    to.run(from.run);
    to.orders_taken(from.orders_taken);
    to.format(from.format);
    to.data(from.data);
}

void convert(const exercise::BridgeOrderView& from, std::uint64_t run, BridgeOrder& to) {
    stamp(from, to);
    to.number(from.number);
    to.run(run);
    to.code(static_cast<BridgeOrderCode>(from.given.code));
    to.side(from.given.side);
    to.value(from.given.value);
    copy(from.given.text, to.text());
    copy(from.given.by, to.by());
    to.repeat_by(from.repeat_by);
    to.do_by(from.do_by);
    to.state(static_cast<BridgeOrderState>(from.state));
}

} // namespace windlass::server
