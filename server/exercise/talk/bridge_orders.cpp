#include "server/exercise/talk/bridge_orders.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::exercise {

namespace {

std::string called(const BridgeOrderView& order, const char* what) {
    const BridgeOrderGiven& given = order.given;
    std::string line = "order " + std::to_string(order.number) + ' ' + what;
    const std::string words = words::order_with(order_words(given.code, given.side, given.value), given.text);
    return words.empty() ? line : line + ": " + words;
}

bool waits(const BridgeOrderView& order) {
    return order.state != BridgeOrderState::repeated && order.state != BridgeOrderState::cancelled;
}

bool same_figure(double one, double other) {
    constexpr double kApart = 1e-6; // shackles or m, that two ways of writing a figure may differ by
    return std::abs(one - other) < kApart;
}

/// The same order, also where the bridge put "I say again" before it. One in own words is told by these.
bool is_same(const BridgeOrderGiven& one, const BridgeOrderGiven& other) {
    return one.code == other.code && one.side == other.side && same_figure(one.value, other.value) &&
           one.cancels == other.cancels &&
           (one.code != BridgeOrderCode::text || one.text.ends_with(other.text) ||
            other.text.ends_with(one.text));
}

} // namespace

std::string order_words(BridgeOrderCode code, int side, double value) {
    return words::order_text(static_cast<std::size_t>(code), side, value);
}

void BridgeOrders::change(BridgeOrderView& order, BridgeOrderState state, const When& when) const {
    order.state = state;
    order.tick = when.tick;
}

BridgeOrderView* BridgeOrders::find(int number) {
    const auto found = std::find_if(orders_.begin(), orders_.end(),
                                    [=](const BridgeOrderView& order) { return order.number == number; });
    return found == orders_.end() ? nullptr : &*found;
}

void BridgeOrders::give(const BridgeOrderGiven& given, const When& when, const EventLog& log) {
    if (orders_.size() == kKept) orders_.erase(orders_.begin());
    const words::Order& usual = words::row_of(given.code);
    const double repeat = given.repeat_within > 0 ? given.repeat_within : usual.repeat;
    const double execute = given.do_within > 0 ? given.do_within : usual.execute;
    orders_.push_back({.number = ++last_number_,
                       .tick = when.tick,
                       .time = when.time,
                       .repeat_by = repeat > 0 ? when.time + repeat : 0,
                       .do_by = execute > 0 ? when.time + execute : 0,
                       .given = given,
                       .state = BridgeOrderState::given});
    log("order.given", given.side, last_number_, called(orders_.back(), "given"));
    if (given.code != BridgeOrderCode::cancel) return;
    BridgeOrderView* taken_back = find(given.cancels);
    if (taken_back == nullptr || taken_back->number == last_number_ ||
        taken_back->state == BridgeOrderState::cancelled)
        return;
    change(*taken_back, BridgeOrderState::cancelled, when);
    log("order.cancelled", taken_back->given.side, taken_back->number, called(*taken_back, "cancelled"));
}

void BridgeOrders::hear(const ReportMade& report, const When& when, const EventLog& log) {
    if (report.code != ReportCode::order_repeated) return;
    const BridgeOrderView* named = find(report.order_number);
    if (named == nullptr || !waits(*named)) return;
    const BridgeOrderGiven given = named->given;
    const bool right = report.order_code == given.code && report.side == given.side &&
                       same_figure(report.value, given.value);
    if (right)
        log("order.repeated", given.side, named->number, called(*named, "repeated"));
    else
        log("order.misrepeated", given.side, named->number, called(*named, "repeated wrongly"));
    for (BridgeOrderView& order : orders_) // said once, it answers each time that the same was given
        if (waits(order) && is_same(order.given, given))
            change(order, right ? BridgeOrderState::repeated : BridgeOrderState::misrepeated, when);
}

void BridgeOrders::watch(const When& when, const EventLog& log) {
    for (BridgeOrderView& order : orders_) {
        const bool waited_for = order.state == BridgeOrderState::given && order.repeat_by > 0;
        if (!waited_for || when.time <= order.repeat_by) continue;
        change(order, BridgeOrderState::not_repeated, when);
        log("order.not_repeated", order.given.side, order.number, called(order, "not repeated in time"));
    }
}

template <class Visitor, physics::StateOf<BridgeOrders> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.last_number_);
    v.length({"count"}, self.orders_, BridgeOrders::kKept);
    v.within({"last_number"}, self.last_number_, 0, 1'000'000'000);
    for (auto& order : self.orders_) {
        auto& [number, tick, time, repeat_by, do_by, given, state] = order;
        auto& [code, side, value, text, by, repeat_within, do_within, cancels] = given;
        WINDLASS_STATE(v, number, tick, time, repeat_by, do_by, state, code, side, value, text, by,
                       repeat_within, do_within, cancels);
        v.within({"number"}, number, 1, self.last_number_);
        v.within({"side"}, side, -1, 1);
    }
}
WINDLASS_STATE_LISTED(BridgeOrders);

} // namespace windlass::exercise
