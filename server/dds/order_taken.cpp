#include "server/dds/order_taken.hpp"

#include "server/dds/check.hpp"
#include "server/dds/wire_fields.hpp"

#include <optional>
#include <stdexcept>

namespace windlass::dds {

namespace {

/// Where each order stands in an OrderTaken: calls visit(kind, type, at) for each, at(sample) being the
/// member. A chance is one of the sample itself.
template <class Visit>
void each_place(Visit&& visit) {
    using std::type_identity;
    visit(
        ORDER_TAKEN_WINDLASS, type_identity<exercise::WindlassOrder>(),
        [](auto& s) -> auto& { return s.windlass(); });
    visit(
        ORDER_TAKEN_HELM, type_identity<exercise::HelmOrder>(), [](auto& s) -> auto& { return s.helm(); });
    visit(
        ORDER_TAKEN_FAULT, type_identity<exercise::FaultOrder>(), [](auto& s) -> auto& { return s.fault(); });
    visit(
        ORDER_TAKEN_ENVIRONMENT, type_identity<exercise::EnvironmentOrder>(),
        [](auto& s) -> auto& { return s.environment(); });
    visit(
        ORDER_TAKEN_REPORT, type_identity<exercise::ReportMade>(),
        [](auto& s) -> auto& { return s.report(); });
    visit(
        ORDER_TAKEN_BRIDGE_ORDER, type_identity<exercise::BridgeOrderGiven>(),
        [](auto& s) -> auto& { return s.bridge_order(); });
    visit(
        ORDER_TAKEN_WATCH_CIRCLE, type_identity<exercise::WatchCircleOrder>(),
        [](auto& s) -> auto& { return s.watch_circle(); });
    visit(
        ORDER_TAKEN_LIGHTS_AND_SHAPES, type_identity<exercise::LightsAndShapes>(),
        [](auto& s) -> auto& { return s.lights_and_shapes(); });
    visit(
        ORDER_TAKEN_DECK_WORK, type_identity<exercise::DeckWorkOrder>(),
        [](auto& s) -> auto& { return s.deck_work(); });
    visit(
        ORDER_TAKEN_ANSWER, type_identity<exercise::AnswerGiven>(),
        [](auto& s) -> auto& { return s.answer(); });
    visit(
        ORDER_TAKEN_OWN_SHIP, type_identity<exercise::OwnShipSample>(),
        [](auto& s) -> auto& { return s.own_ship(); });
    visit(
        ORDER_TAKEN_ASSESSMENT, type_identity<exercise::AssessorsWord>(),
        [](auto& s) -> auto& { return s.assessment(); });
    visit(
        ORDER_TAKEN_CHANCE, type_identity<exercise::ChanceDrawn>(), [](auto& s) -> auto& { return s; });
}

/// A damaged recording may say anything of an enumerator.
template <class Order>
void must_be_known(const Order& order) {
    for_each_field<Order>([&](auto field) {
        if constexpr (std::is_enum_v<std::decay_t<decltype(field.of(order))>>) {
            const auto number = static_cast<std::uint32_t>(field.of(order));
            if (number > static_cast<std::uint32_t>(last_of(field.of(order))))
                throw std::runtime_error("an order with the unknown " + std::string(field.name) + " " +
                                         std::to_string(number));
        }
    });
}

exercise::Order order_in(const OrderTaken& sample) {
    std::optional<exercise::Order> found;
    each_place([&]<class Order>(OrderTakenKind kind, std::type_identity<Order>, auto at) {
        if (kind != sample.kind()) return;
        if constexpr (std::is_same_v<Order, exercise::ChanceDrawn>)
            found = exercise::ChanceDrawn{sample.chance()};
        else
            found = std::get<exercise::Order>(order(at(sample)));
        must_be_known(std::get<Order>(*found));
    });
    if (!found) throw std::runtime_error("an order of a kind that this version does not take");
    return *std::move(found);
}

} // namespace

void convert(const run::OrderView& from, OrderTaken& to) {
    to = OrderTaken();
    to_wire(from, to);
    each_place([&]<class Order>(OrderTakenKind kind, std::type_identity<Order>, auto at) {
        const auto* order = std::get_if<Order>(&from.command);
        if (order == nullptr) return;
        to.kind(kind);
        to_wire(*order, at(to));
        if constexpr (requires { order->by; }) to_wire(order->by, at(to).origin().source());
    });
}

run::OrderView order_view(const OrderTaken& sample) {
    return {.run = sample.run(),
            .tick = sample.tick(),
            .number = sample.number(),
            .source = sample.source().to_string(),
            .command = order_in(sample)};
}

} // namespace windlass::dds
