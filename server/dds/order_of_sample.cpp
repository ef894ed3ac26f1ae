// The orders in samples that are not refused.

#include "server/dds/check.hpp"
#include "server/dds/wire_fields.hpp"

namespace windlass::dds {

namespace {

template <class Order, class Sample>
Order order_in(const Sample& sample) {
    Order order{};
    from_wire(sample, order);
    if constexpr (requires { order.by; }) from_wire(sample.origin().source(), order.by);
    return order;
}

run::AnswerOrder answer_of(bool forecastle, const Answer& sample) {
    const run::OrderContent content = order(sample);
    return {forecastle, std::get<exercise::AnswerGiven>(std::get<exercise::Order>(content))};
}

} // namespace

run::OrderContent order(const WindlassCommand& sample) {
    return order_in<exercise::WindlassOrder>(sample);
}

run::OrderContent order(const HelmCommand& sample) {
    return order_in<exercise::HelmOrder>(sample);
}

run::OrderContent order(const ExerciseCommand& sample) {
    run::RunOrder run;
    switch (sample.action()) {
    case EXERCISE_LOAD:
        run.action = run::RunAction::load;
        run.exercise = sample.exercise().to_string();
        run.practice = sample.practice();
        break;
    case EXERCISE_PAUSE:
        run.action = run::RunAction::pause;
        break;
    case EXERCISE_RESET:
        run.action = run::RunAction::reset;
        break;
    case EXERCISE_TIME_SCALE:
        run.action = run::RunAction::time_scale;
        run.time_scale = sample.time_scale();
        break;
    case EXERCISE_STOP:
        run.action = run::RunAction::stop;
        break;
    case EXERCISE_SNAPSHOT:
        run.action = run::RunAction::snapshot;
        break;
    case EXERCISE_RESTORE:
        run.action = run::RunAction::restore;
        run.restore_time = sample.restore_time();
        break;
    case EXERCISE_BOOKMARK:
        run.action = run::RunAction::bookmark;
        run.text = sample.text().to_string();
        break;
    case EXERCISE_PREDICT:
        run.action = run::RunAction::predict;
        run.predict = sample.predict();
        break;
    case EXERCISE_START:
        break;
    }
    return run;
}

run::OrderContent order(const FaultCommand& sample) {
    auto fault = order_in<exercise::FaultOrder>(sample);
    if (fault.clear) // severity and trigger mean nothing then
        return exercise::FaultOrder{.code = fault.code, .side = fault.side, .severity = 0, .clear = true};
    // What the trigger does not use means nothing, and nothing of it is kept.
    using exercise::FaultTrigger;
    const FaultTrigger trigger = fault.trigger;
    if (trigger != FaultTrigger::at_event) fault.trigger_event.clear();
    if (trigger != FaultTrigger::at_order) fault.trigger_order = {};
    if (trigger != FaultTrigger::at_chance) fault.trigger_until = 0;
    if (trigger == FaultTrigger::now || trigger == FaultTrigger::at_event ||
        trigger == FaultTrigger::at_order)
        fault.trigger_value = 0;
    return fault;
}

run::OrderContent order(const EnvironmentCommand& sample) {
    return order_in<exercise::EnvironmentOrder>(sample);
}

run::OrderContent order(const Report& sample) {
    return order_in<exercise::ReportMade>(sample);
}

run::OrderContent order(const BridgeOrderCommand& sample) {
    return order_in<exercise::BridgeOrderGiven>(sample);
}

run::OrderContent order(const WatchCircle& sample) {
    return sample.kept() ? order_in<exercise::WatchCircleOrder>(sample) : exercise::WatchCircleOrder{};
}

run::OrderContent order(const LightsAndShapesCommand& sample) {
    return order_in<exercise::LightsAndShapes>(sample);
}

run::OrderContent order(const DeckWorkCommand& sample) {
    return order_in<exercise::DeckWorkOrder>(sample);
}

run::OrderContent order(const Answer& sample) {
    auto answer = order_in<exercise::AnswerGiven>(sample);
    // What does not belong to its kind may hold anything, and is no part of the order.
    if (answer.kind != exercise::AnswerKind::number) answer.value = 0;
    if (answer.kind != exercise::AnswerKind::choice) answer.choice = 0;
    return exercise::Order{std::move(answer)};
}

run::OrderContent order(const ForecastleAnswer& sample) {
    return answer_of(true, sample);
}

run::OrderContent order(const BridgeAnswer& sample) {
    return answer_of(false, sample);
}

run::OrderContent order(const OwnShipInput& sample) {
    return order_in<exercise::OwnShipSample>(sample);
}

run::OrderContent order(const AssessmentCommand& sample) {
    return order_in<exercise::AssessorsWord>(sample);
}

run::OrderContent order(const AlertCommand& sample) {
    return run::AlertOrder{.code = sample.code().to_string(),
                           .side = sample.side(),
                           .acknowledge = sample.action() == ALERT_ACKNOWLEDGE};
}

run::OrderContent order(const RestoreCommand& sample) {
    return run::StateOrder{.from = sample.from().to_string(), .checkpoint = sample.checkpoint()};
}

} // namespace windlass::dds
