#include "server/exercise/talk/bridge_orders.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace windlass::exercise {

namespace {

struct OrderRow {
    BridgeOrderCode code;
    const char* words;
    const char* unit; ///< of its value; empty: it has none
    double repeat, execute;
};

/// Deadlines are those of a crew that knows its work; tuned against how long the model's windlass takes.
constexpr std::array kRows{
    OrderRow{BridgeOrderCode::text, "", "", 10, 0},
    OrderRow{BridgeOrderCode::stand_by, "stand by", "", 10, 60},
    OrderRow{BridgeOrderCode::clear_away, "clear away", "", 10, 240},
    OrderRow{BridgeOrderCode::walk_out, "walk out", "m", 10, 240},
    OrderRow{BridgeOrderCode::let_go, "let go", "", 5, 5},
    OrderRow{BridgeOrderCode::pay_out, "pay out", "shackles", 10, 90},
    OrderRow{BridgeOrderCode::veer, "veer", "shackles", 10, 60},
    OrderRow{BridgeOrderCode::check, "check", "", 5, 10},
    OrderRow{BridgeOrderCode::hold_on, "hold on", "shackles", 5, 10},
    OrderRow{BridgeOrderCode::walk_back, "walk back", "shackles", 10, 30},
    OrderRow{BridgeOrderCode::gear_in, "put in gear", "", 10, 120},
    OrderRow{BridgeOrderCode::gear_out, "gear out", "", 10, 30},
    OrderRow{BridgeOrderCode::heave, "heave", "", 10, 30},
    OrderRow{BridgeOrderCode::heave_to, "heave", "shackles", 10, 30},
    OrderRow{BridgeOrderCode::stop_heaving, "stop heaving", "", 5, 5},
    OrderRow{BridgeOrderCode::secure, "secure", "", 10, 90},
    OrderRow{BridgeOrderCode::how_much, "how much cable is out?", "", 0, 15},
    OrderRow{BridgeOrderCode::how_leading, "how is the cable leading?", "", 0, 15},
    OrderRow{BridgeOrderCode::how_growing, "how is the cable growing?", "", 0, 15},
    OrderRow{BridgeOrderCode::how_much_weight, "how much weight is on the cable?", "", 0, 15},
    OrderRow{BridgeOrderCode::brought_up, "is she brought up?", "", 0, 15},
    OrderRow{BridgeOrderCode::stand_clear, "stand clear", "", 5, 0},
    OrderRow{BridgeOrderCode::cancel, "belay the order", "", 5, 0},
};
static_assert([] {
    for (std::size_t k = 0; k < kRows.size(); ++k)
        if (kRows[k].code != static_cast<BridgeOrderCode>(k)) return false;
    return kRows.size() == static_cast<std::size_t>(BridgeOrderCode::cancel) + 1;
}());

const OrderRow& row_of(BridgeOrderCode code) {
    assert(code <= last_of(code) && "orders are checked before");
    return kRows.at(static_cast<std::size_t>(code));
}

std::string called(const BridgeOrderView& order, const char* what) {
    const BridgeOrderGiven& given = order.given;
    std::string line = "order " + std::to_string(order.number) + ' ' + what;
    const std::string words = order_words(given.code, given.side, given.value);
    if (!words.empty()) line += ": " + words;
    if (!given.text.empty()) line += (words.empty() ? ": " : ", ") + given.text;
    return line;
}

} // namespace

OrderDeadlines usual_deadlines(BridgeOrderCode code) {
    const OrderRow& row = row_of(code);
    return {row.repeat, row.execute};
}

std::string order_words(BridgeOrderCode code, int side, double value) {
    const OrderRow& row = row_of(code);
    std::string line = row.words;
    if (line.empty()) return line;
    if (side >= 0) line += side == 0 ? ", port" : ", starboard";
    if (*row.unit != '\0' && value != 0) {
        const bool metres = row.unit[0] == 'm';
        std::array<char, 48> figure{};
        std::snprintf(figure.data(), figure.size(), ", %g %s", value,
                      metres       ? row.unit
                      : value == 1 ? "shackle in the pipe"
                                   : "shackles in the pipe");
        line += figure.data();
    }
    return line;
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

void BridgeOrders::give(const BridgeOrderGiven& given, const When& when, const FaultBook::Log& log) {
    if (orders_.size() == kKept) orders_.erase(orders_.begin());
    const OrderDeadlines usual = usual_deadlines(given.code);
    const double repeat = given.repeat_within > 0 ? given.repeat_within : usual.repeat;
    const double execute = given.do_within > 0 ? given.do_within : usual.execute;
    orders_.push_back({.number = ++last_number_,
                       .tick = when.tick,
                       .time = when.time,
                       .repeat_by = repeat > 0 ? when.time + repeat : 0,
                       .do_by = execute > 0 ? when.time + execute : 0,
                       .given = given,
                       .state = BridgeOrderState::given});
    log(Severity::info, "order.given", given.side, last_number_, called(orders_.back(), "given"));
    if (given.code != BridgeOrderCode::cancel) return;
    BridgeOrderView* taken_back = find(given.cancels);
    if (taken_back == nullptr || taken_back->number == last_number_ ||
        taken_back->state == BridgeOrderState::cancelled)
        return;
    change(*taken_back, BridgeOrderState::cancelled, when);
    log(Severity::info, "order.cancelled", taken_back->given.side, taken_back->number,
        called(*taken_back, "cancelled"));
}

void BridgeOrders::hear(const ReportMade& report, const When& when, const FaultBook::Log& log) {
    constexpr double kSameFigure = 1e-6; // shackles or m, that two ways of writing a figure may differ by
    if (report.code != ReportCode::order_repeated) return;
    BridgeOrderView* order = find(report.order_number);
    if (order == nullptr || order->state == BridgeOrderState::repeated ||
        order->state == BridgeOrderState::cancelled)
        return;
    const BridgeOrderGiven& given = order->given;
    const bool same = report.order_code == given.code && report.side == given.side &&
                      std::abs(report.value - given.value) < kSameFigure;
    if (same) {
        change(*order, BridgeOrderState::repeated, when);
        log(Severity::info, "order.repeated", given.side, order->number, called(*order, "repeated"));
    } else {
        change(*order, BridgeOrderState::misrepeated, when);
        log(Severity::caution, "order.misrepeated", given.side, order->number,
            called(*order, "repeated wrongly"));
    }
}

void BridgeOrders::watch(const When& when, const FaultBook::Log& log) {
    for (BridgeOrderView& order : orders_) {
        const bool waited_for = order.state == BridgeOrderState::given && order.repeat_by > 0;
        if (!waited_for || when.time <= order.repeat_by) continue;
        change(order, BridgeOrderState::not_repeated, when);
        log(Severity::caution, "order.not_repeated", order.given.side, order.number,
            called(order, "not repeated in time"));
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
