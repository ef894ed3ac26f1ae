#include "server/dds/order_taken.hpp"

#include "common/text.hpp"
#include "server/dds/check.hpp"
#include "server/dds/convert.hpp"
#include "server/dds/last_codes.hpp"

#include <stdexcept>

namespace windlass::server {

namespace {

/// Sets the kind and what belongs to it.
struct Put {
    OrderTaken& to;

    void operator()(const exercise::WindlassOrder& order) const {
        to.kind(ORDER_TAKEN_WINDLASS);
        WindlassCommand& levers = to.windlass();
        levers.side(static_cast<std::int32_t>(order.side));
        levers.brake(order.brake);
        levers.speed_lever(order.speed_lever);
        levers.clutch_in(order.clutch_in);
        levers.stopper_closed(order.stopper_closed);
        levers.emergency_stop(order.emergency_stop);
    }
    void operator()(const exercise::HelmOrder& order) const {
        to.kind(ORDER_TAKEN_HELM);
        HelmCommand& helm = to.helm();
        helm.engine(order.engine);
        helm.rudder(order.rudder);
        helm.bow_thruster(order.bow_thruster);
        helm.stern_thruster(order.stern_thruster);
    }
    void operator()(const exercise::FaultOrder& order) const {
        to.kind(ORDER_TAKEN_FAULT);
        FaultCommand& fault = to.fault();
        fault.code(static_cast<FaultCode>(order.code));
        fault.side(static_cast<std::int32_t>(order.side));
        fault.severity(order.severity);
        fault.ramp(order.ramp);
        fault.trigger(static_cast<FaultTrigger>(order.trigger));
        fault.trigger_value(order.trigger_value);
        fault.trigger_until(order.trigger_until);
        fault.trigger_event() = std::string(clipped(order.trigger_event, 48));
        fault.trigger_order(static_cast<std::int32_t>(order.trigger_order));
        fault.target(order.target);
        fault.clear(order.clear);
    }
    void operator()(const exercise::EnvironmentOrder& order) const {
        to.kind(ORDER_TAKEN_ENVIRONMENT);
        convert(order.weather, to.environment().weather());
        to.environment().ramp(order.ramp);
    }
    void operator()(const exercise::ReportMade& order) const {
        to.kind(ORDER_TAKEN_REPORT);
        Report& report = to.report();
        report.code(static_cast<ReportCode>(order.code));
        report.side(order.side);
        report.value(order.value);
        report.lead(order.lead);
        report.stay(static_cast<StayGiven>(order.stay));
        report.growing(static_cast<Growing>(order.growing));
        report.weight(static_cast<CableWeight>(order.weight));
        report.order_number(order.order_number);
        report.order_code(static_cast<BridgeOrderCode>(order.order_code));
        report.text() = std::string(clipped(order.text, 256));
    }
    void operator()(const exercise::BridgeOrderGiven& order) const {
        to.kind(ORDER_TAKEN_BRIDGE_ORDER);
        BridgeOrderCommand& given = to.bridge_order();
        given.origin().source() = std::string(clipped(order.by, 32));
        given.code(static_cast<BridgeOrderCode>(order.code));
        given.side(order.side);
        given.value(order.value);
        given.text() = std::string(clipped(order.text, 256));
        given.repeat_within(order.repeat_within);
        given.do_within(order.do_within);
        given.cancels(order.cancels);
    }
    void operator()(const exercise::WatchCircleOrder& order) const {
        to.kind(ORDER_TAKEN_WATCH_CIRCLE);
        WatchCircle& circle = to.watch_circle();
        circle.kept(order.kept);
        circle.x(order.x);
        circle.y(order.y);
        circle.radius(order.radius);
    }
    void operator()(const exercise::LightsAndShapes& order) const {
        to.kind(ORDER_TAKEN_LIGHTS_AND_SHAPES);
        to.lights_and_shapes().anchor_ball(order.anchor_ball);
        to.lights_and_shapes().anchor_lights(order.anchor_lights);
    }
    void operator()(const exercise::OwnShipSample& order) const {
        to.kind(ORDER_TAKEN_OWN_SHIP);
        OwnShipInput& ship = to.own_ship();
        const auto copy = [](const physics::Vec3& from, Vec3& to) {
            to.x(from.x());
            to.y(from.y());
            to.z(from.z());
        };
        copy(order.position, ship.position());
        copy(order.velocity, ship.velocity());
        copy(order.spin, ship.angular_velocity());
        ship.attitude().w(order.attitude.w());
        ship.attitude().x(order.attitude.x());
        ship.attitude().y(order.attitude.y());
        ship.attitude().z(order.attitude.z());
        ship.time(order.time);
    }
    void operator()(const exercise::ChanceDrawn& order) const {
        to.kind(ORDER_TAKEN_CHANCE);
        to.chance(order.share);
    }
    void operator()(const exercise::AssessorsWord& order) const {
        to.kind(ORDER_TAKEN_ASSESSMENT);
        AssessmentCommand& word = to.assessment();
        word.origin().source() = std::string(clipped(order.by, 32));
        word.criterion() = std::string(clipped(order.criterion, 48));
        word.verdict(static_cast<AssessorVerdict>(order.verdict));
        word.milli(static_cast<std::uint32_t>(order.milli));
        word.note() = std::string(clipped(order.note, 256));
    }
};

/// An enumerator or side, which a damaged recording may say anything of.
template <class T>
void must_be_within(const char* what, T value, T last) {
    if (static_cast<std::uint32_t>(value) > static_cast<std::uint32_t>(last))
        throw std::runtime_error(std::string("an order with the unknown ") + what + " " +
                                 std::to_string(static_cast<std::uint32_t>(value)));
}

exercise::Order order_in(const OrderTaken& sample) {
    must_be_within("kind", sample.kind(), ORDER_TAKEN_LIGHTS_AND_SHAPES);
    switch (sample.kind()) {
    case ORDER_TAKEN_WINDLASS:
        must_be_within("side", sample.windlass().side(), SIDE_STARBOARD);
        return std::get<exercise::Order>(order(sample.windlass()));
    case ORDER_TAKEN_HELM:
        return std::get<exercise::Order>(order(sample.helm()));
    case ORDER_TAKEN_FAULT:
        must_be_within("side", sample.fault().side(), SIDE_STARBOARD);
        must_be_within("fault", sample.fault().code(), kLastFault);
        must_be_within("trigger", sample.fault().trigger(), TRIGGER_AT_CHANCE);
        must_be_within("trigger order", sample.fault().trigger_order(),
                       static_cast<std::int32_t>(kLastBridgeOrder));
        return std::get<exercise::Order>(order(sample.fault()));
    case ORDER_TAKEN_ENVIRONMENT:
        return std::get<exercise::Order>(order(sample.environment()));
    case ORDER_TAKEN_REPORT:
        must_be_within("report", sample.report().code(), kLastReport);
        must_be_within("stay", sample.report().stay(), STAY_GIVEN_LONG);
        must_be_within("growing", sample.report().growing(), GROWING_TIGHT);
        must_be_within("weight", sample.report().weight(), WEIGHT_TOO_MUCH);
        must_be_within("order code", sample.report().order_code(), kLastBridgeOrder);
        return std::get<exercise::Order>(order(sample.report()));
    case ORDER_TAKEN_BRIDGE_ORDER:
        must_be_within("order", sample.bridge_order().code(), kLastBridgeOrder);
        return std::get<exercise::Order>(order(sample.bridge_order()));
    case ORDER_TAKEN_WATCH_CIRCLE:
        return std::get<exercise::Order>(order(sample.watch_circle()));
    case ORDER_TAKEN_LIGHTS_AND_SHAPES:
        return std::get<exercise::Order>(order(sample.lights_and_shapes()));
    case ORDER_TAKEN_CHANCE:
        return exercise::ChanceDrawn{sample.chance()};
    case ORDER_TAKEN_OWN_SHIP:
        return std::get<exercise::Order>(order(sample.own_ship()));
    case ORDER_TAKEN_ASSESSMENT:
        must_be_within("verdict", sample.assessment().verdict(), VERDICT_ENDED);
        return std::get<exercise::Order>(order(sample.assessment()));
    case ORDER_TAKEN_ALERT:
        break;
    }
    throw std::runtime_error("an order of a kind that this version does not take");
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
            .command = order_in(sample)};
}

} // namespace windlass::server
