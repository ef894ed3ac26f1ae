#include "server/dds/order_taken.hpp"

#include "common/text.hpp"
#include "server/dds/check.hpp"

#include <stdexcept>

namespace windlass::server {

namespace {

/// Sets the kind and what belongs to it.
struct Put {
    OrderTaken& to;

    void operator()(const exercise::WindlassOrder& order) const {
        to.kind(ORDER_WINDLASS);
        WindlassCommand& levers = to.windlass();
        levers.side(static_cast<std::int32_t>(order.side));
        levers.brake(order.brake);
        levers.speed_lever(order.speed_lever);
        levers.clutch_in(order.clutch_in);
        levers.stopper_closed(order.stopper_closed);
        levers.emergency_stop(order.emergency_stop);
    }
    void operator()(const exercise::HelmOrder& order) const {
        to.kind(ORDER_HELM);
        HelmCommand& helm = to.helm();
        helm.engine(order.engine);
        helm.rudder(order.rudder);
        helm.bow_thruster(order.bow_thruster);
        helm.stern_thruster(order.stern_thruster);
    }
    void operator()(const exercise::FaultOrder& order) const {
        to.kind(ORDER_FAULT);
        FaultCommand& fault = to.fault();
        fault.code(static_cast<FaultCode>(order.code));
        fault.side(static_cast<std::int32_t>(order.side));
        fault.severity(order.severity);
        fault.trigger(static_cast<FaultTrigger>(order.trigger));
        fault.trigger_value(order.trigger_value);
        fault.clear(order.clear);
    }
    void operator()(const exercise::EnvironmentOrder& order) const {
        to.kind(ORDER_ENVIRONMENT);
        ExerciseCommand& environment = to.environment();
        environment.wind_speed(order.wind_speed);
        environment.wind_from(order.wind_from);
        environment.current_speed(order.current_speed);
        environment.current_towards(order.current_towards);
    }
    void operator()(const exercise::ReportMade& order) const {
        to.kind(ORDER_REPORT);
        Report& report = to.report();
        report.code(static_cast<ReportCode>(order.code));
        report.side(order.side);
        report.value(order.value);
        report.text() = std::string(clipped(order.text, 256));
    }
};

/// An enumerator or side, which a damaged recording may say anything of.
template <class T>
void must_be_within(const char* what, T value, T last) {
    if (static_cast<std::uint32_t>(value) > static_cast<std::uint32_t>(last))
        throw std::runtime_error(std::string("an order with the unknown ") + what + " " +
                                 std::to_string(static_cast<std::uint32_t>(value)));
}

exercise::Order command_in(const OrderTaken& sample) {
    must_be_within("kind", sample.kind(), ORDER_REPORT);
    switch (sample.kind()) {
    case ORDER_WINDLASS:
        must_be_within("side", sample.windlass().side(), SIDE_STARBOARD);
        return std::get<exercise::Order>(order(sample.windlass()));
    case ORDER_HELM:
        return std::get<exercise::Order>(order(sample.helm()));
    case ORDER_FAULT:
        must_be_within("side", sample.fault().side(), SIDE_STARBOARD);
        must_be_within("fault", sample.fault().code(), FAULT_CABLE_TWISTED);
        must_be_within("trigger", sample.fault().trigger(), TRIGGER_AT_LOAD);
        return std::get<exercise::Order>(order(sample.fault()));
    case ORDER_ENVIRONMENT: {
        ExerciseCommand environment = sample.environment();
        environment.action(EXERCISE_ENVIRONMENT);
        return std::get<exercise::Order>(order(environment));
    }
    case ORDER_REPORT:
        break;
    }
    must_be_within("report", sample.report().code(), REPORT_ORDER_REPEATED);
    return std::get<exercise::Order>(order(sample.report()));
}

} // namespace

void convert(const OrderView& from, OrderTaken& to) {
    to = OrderTaken();
    to.run(from.run);
    to.tick(from.tick);
    to.number(from.number);
    to.source() = std::string(clipped(from.source, 32));
    std::visit(Put{to}, from.command);
}

OrderView order_view(const OrderTaken& sample) {
    return {.run = sample.run(),
            .tick = sample.tick(),
            .number = sample.number(),
            .source = sample.source().to_string(),
            .command = command_in(sample)};
}

} // namespace windlass::server
