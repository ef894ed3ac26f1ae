// The orders in samples that are not refused.

#include "server/dds/check.hpp"

namespace windlass::server {

OrderContent order(const WindlassCommand& sample) {
    return exercise::Order{exercise::WindlassOrder{.side = static_cast<exercise::Side>(sample.side()),
                                                   .brake = sample.brake(),
                                                   .speed_lever = sample.speed_lever(),
                                                   .clutch_in = sample.clutch_in(),
                                                   .stopper_closed = sample.stopper_closed(),
                                                   .emergency_stop = sample.emergency_stop()}};
}

OrderContent order(const HelmCommand& sample) {
    return exercise::Order{exercise::HelmOrder{.engine = sample.engine(),
                                               .rudder = sample.rudder(),
                                               .bow_thruster = sample.bow_thruster(),
                                               .stern_thruster = sample.stern_thruster()}};
}

OrderContent order(const ExerciseCommand& sample) {
    RunOrder run;
    switch (sample.action()) {
    case EXERCISE_LOAD:
        run.action = RunAction::load;
        run.exercise = sample.exercise().to_string();
        break;
    case EXERCISE_PAUSE:
        run.action = RunAction::pause;
        break;
    case EXERCISE_RESET:
        run.action = RunAction::reset;
        break;
    case EXERCISE_TIME_SCALE:
        run.action = RunAction::time_scale;
        run.time_scale = sample.time_scale();
        break;
    case EXERCISE_STOP:
        run.action = RunAction::stop;
        break;
    case EXERCISE_SNAPSHOT:
        run.action = RunAction::snapshot;
        break;
    case EXERCISE_RESTORE:
        run.action = RunAction::restore;
        run.restore_time = sample.restore_time();
        break;
    case EXERCISE_BOOKMARK:
        run.action = RunAction::bookmark;
        run.text = sample.text().to_string();
        break;
    case EXERCISE_START:
        break;
    }
    return run;
}

OrderContent order(const FaultCommand& sample) {
    exercise::FaultOrder fault{.code = static_cast<exercise::FaultCode>(sample.code()),
                               .side = static_cast<exercise::Side>(sample.side()),
                               .severity = 0,
                               .clear = sample.clear()};
    if (sample.clear()) return exercise::Order{fault}; // severity and trigger mean nothing then
    fault.severity = sample.severity();
    fault.ramp = sample.ramp();
    fault.trigger = static_cast<exercise::FaultTrigger>(sample.trigger());
    fault.target = sample.target();
    switch (sample.trigger()) { // of the others nothing is kept: they mean nothing
    case TRIGGER_NOW:
        break;
    case TRIGGER_AT_EVENT:
        fault.trigger_event = sample.trigger_event().to_string();
        break;
    case TRIGGER_AT_ORDER:
        fault.trigger_order = static_cast<exercise::BridgeOrderCode>(sample.trigger_order());
        break;
    case TRIGGER_AT_CHANCE:
        fault.trigger_until = sample.trigger_until();
        fault.trigger_value = sample.trigger_value();
        break;
    case TRIGGER_AT_TIME:
    case TRIGGER_AT_CABLE_OUT:
    case TRIGGER_AT_LOAD:
    case TRIGGER_AT_CABLE_OUT_AT_MOST:
    case TRIGGER_AT_LOAD_AT_MOST:
        fault.trigger_value = sample.trigger_value();
        break;
    }
    return exercise::Order{fault};
}

OrderContent order(const EnvironmentCommand& sample) {
    const Weather& from = sample.weather();
    exercise::EnvironmentOrder order{.weather = {.wind_speed = from.wind_speed(),
                                                 .wind_from = from.wind_from(),
                                                 .gust_factor = from.gust_factor(),
                                                 .gust_period = from.gust_period(),
                                                 .veering = from.veering(),
                                                 .wave_height = from.wave_height(),
                                                 .wave_period = from.wave_period(),
                                                 .wave_from = from.wave_from(),
                                                 .swell_height = from.swell_height(),
                                                 .swell_period = from.swell_period(),
                                                 .swell_from = from.swell_from(),
                                                 .wave_seed = from.wave_seed(),
                                                 .current_speed = from.current_speed(),
                                                 .current_towards = from.current_towards(),
                                                 .current_profile = {},
                                                 .tide_height = from.tide_height(),
                                                 .visibility = from.visibility(),
                                                 .time_of_day = from.time_of_day()},
                                     .ramp = sample.ramp()};
    for (const CurrentLayer& layer : from.current_profile())
        order.weather.current_profile.push_back({layer.depth(), layer.share(), layer.turn()});
    return exercise::Order{order};
}

OrderContent order(const Report& sample) {
    return exercise::Order{
        exercise::ReportMade{.code = static_cast<exercise::ReportCode>(sample.code()),
                             .side = sample.side(),
                             .value = sample.value(),
                             .lead = sample.lead(),
                             .stay = static_cast<exercise::StayGiven>(sample.stay()),
                             .growing = static_cast<exercise::Growing>(sample.growing()),
                             .weight = static_cast<exercise::CableWeight>(sample.weight()),
                             .order_number = sample.order_number(),
                             .order_code = static_cast<exercise::BridgeOrderCode>(sample.order_code()),
                             .text = sample.text().to_string()}};
}

OrderContent order(const BridgeOrderCommand& sample) {
    return exercise::Order{
        exercise::BridgeOrderGiven{.code = static_cast<exercise::BridgeOrderCode>(sample.code()),
                                   .side = sample.side(),
                                   .value = sample.value(),
                                   .text = sample.text().to_string(),
                                   .by = sample.origin().source().to_string(),
                                   .repeat_within = sample.repeat_within(),
                                   .do_within = sample.do_within(),
                                   .cancels = sample.cancels()}};
}

OrderContent order(const WatchCircle& sample) {
    if (!sample.kept()) return exercise::Order{exercise::WatchCircleOrder{}};
    return exercise::Order{exercise::WatchCircleOrder{true, sample.x(), sample.y(), sample.radius()}};
}

OrderContent order(const LightsAndShapesCommand& sample) {
    return exercise::Order{exercise::LightsAndShapes{sample.anchor_ball(), sample.anchor_lights()}};
}

OrderContent order(const OwnShipInput& sample) {
    const auto vector = [](const windlass::Vec3& v) { return physics::Vec3(v.x(), v.y(), v.z()); };
    const auto& turned = sample.attitude();
    return exercise::Order{exercise::OwnShipSample{
        .position = vector(sample.position()),
        .attitude = Eigen::Quaterniond(turned.w(), turned.x(), turned.y(), turned.z()),
        .velocity = vector(sample.velocity()),
        .spin = vector(sample.angular_velocity()),
        .time = sample.time()}};
}

OrderContent order(const AssessmentCommand& sample) {
    return exercise::Order{
        exercise::AssessorsWord{.criterion = sample.criterion().to_string(),
                                .verdict = static_cast<exercise::AssessorVerdict>(sample.verdict()),
                                .milli = static_cast<int>(sample.milli()),
                                .note = sample.note().to_string(),
                                .by = sample.origin().source().to_string()}};
}

OrderContent order(const AlertCommand& sample) {
    return AlertOrder{.code = sample.code().to_string(),
                      .side = sample.side(),
                      .acknowledge = sample.action() == ALERT_ACKNOWLEDGE};
}

OrderContent order(const RestoreCommand& sample) {
    return StateOrder{.from = sample.from().to_string(), .checkpoint = sample.checkpoint()};
}

} // namespace windlass::server
