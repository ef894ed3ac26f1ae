#include "recorder/debrief/said.hpp"

#include "common/figure_text.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "station/format.hpp"
#include "station/names.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace windlass::debrief {

namespace {

/// What the server's judge has made of the report.
void tell_judged(const Attempt& attempt, const SaidReport& said, ReportSaid& row) {
    if (!attempt.assessment) return;
    for (const JudgedReport& judged : attempt.assessment->reports()) {
        if (judged.criterion().size() == 0)
            continue; // no criterion asks for it: the tackle tells what was so
        const bool of_it = judged.tick() == said.tick && judged.code() == said.report.code() &&
                           (said.report.side() < 0 || said.report.side() == judged.side());
        if (!of_it) continue;
        row.truth += (row.truth.empty() ? "" : "; ") + in_seat_units(judged.text().to_string());
        row.milli = std::min(row.milli.value_or(judged.milli()), judged.milli());
        if (judged.timed()) row.delay = judged.delay();
        if (judged.figure()) row.true_value = judged.truth();
    }
}

/// Of which side a report is; nothing: of neither, or of one that the report leaves open where two were
/// worked.
const Side* side_of(const Attempt& attempt, const Report& report) {
    const auto& [port, starboard] = attempt.sides;
    if (report.side() == SIDE_PORT) return &port;
    if (report.side() == SIDE_STARBOARD) return &starboard;
    return port.worked == starboard.worked ? nullptr : port.worked ? &port : &starboard;
}

/// How the tackle was, where that is the whole of what the report tells.
std::string tackle_words(ReportCode code, const Truth& truth) {
    switch (code) {
    case REPORT_LET_GO:
    case REPORT_ON_THE_BOTTOM:
    case REPORT_BROUGHT_UP:
    case REPORT_ANCHOR_AWEIGH:
    case REPORT_CLEAR_ANCHOR:
    case REPORT_FOUL_ANCHOR:
    case REPORT_ANCHOR_HOME:
    case REPORT_DRAGGING:
        return truth.anchor ? "anchor " + station::words(*truth.anchor) : "";
    case REPORT_SHORT_STAY:
    case REPORT_UP_AND_DOWN:
        return "lead " + station::lead(truth.lead_clock) + ", " + station::words(truth.stay);
    case REPORT_SECURED:
        return fmt::format("brake {} on, stopper {}", station::percent(truth.brake),
                           truth.stopper_closed ? "closed" : "open");
    case REPORT_NO_POWER:
        return truth.power ? "motor had power" : "motor had none";
    case REPORT_DOES_NOT_RUN:
        return "cable " + cable_speed_text(truth.cable_speed);
    case REPORT_BRAKE_DOES_NOT_HOLD:
        return fmt::format("brake bore {}, of {} that it could", station::tonnes(truth.brake_load),
                           station::tonnes(truth.brake_capacity));
    default:
        return "";
    }
}

/// Shackles from where the report counts them, as the judge tells them; of a mark in the water from the lip:
/// how high that is over the water is not kept.
template <class Add>
void add_shackles(words::MarkAt at, double cable_out, const Add& add) {
    const auto from = [&](double inboard, const char* where) {
        const double shackles = (cable_out + inboard) / words::units::shackle;
        add(shackles < 0 ? "the anchor was home" : shackles_figure(shackles) + ' ' + where + " were so");
    };
    switch (at) {
    case words::MarkAt::deck:
        return from(words::limits::mark_on_deck, "on deck");
    case words::MarkAt::pipe:
        return from(words::limits::mark_in_pipe, "in the pipe");
    case words::MarkAt::water:
        return add(cable_out < 0 ? "the anchor was home"
                                 : shackles_text(cable_out) + " from the lip were so");
    case words::MarkAt::none:
        return;
    }
}

/// How cable and tackle were, beside a report that tells of them and is not judged.
void tell_tackle(const Attempt& attempt, const SaidReport& said, ReportSaid& row) {
    const Report& report = said.report;
    const Side* side = side_of(attempt, report);
    const Truth* truth = side != nullptr ? side->truth_at(said.time) : nullptr;
    if (truth == nullptr) return;
    row.truth = tackle_words(report.code(), *truth);
    const auto add = [&](const std::string& text) { row.truth += (row.truth.empty() ? "" : ", ") + text; };
    if (report.code() < words::kReportCode.size())
        add_shackles(words::kReportCode[report.code()].mark_at, truth->cable_out, add);
    if (report.lead() != 0) add("lead " + station::lead(truth->lead_clock));
    if (report.stay() != STAY_NOT_GIVEN) add(station::words(truth->stay));
    if (report.growing() != GROWING_NOT_GIVEN || report.weight() != WEIGHT_NOT_GIVEN)
        add(station::tonnes(truth->tension) + " at the lip");
}

bool repeats(const SaidReport& said, int number) {
    return said.report.code() == REPORT_ORDER_REPEATED && said.report.order_number() == number;
}
/// With the order's code, side and figure.
bool repeats_rightly(const SaidReport& said, const BridgeOrder& order) {
    return repeats(said, order.number()) && said.report.order_code() == order.code() &&
           said.report.side() == order.side() && said.report.value() == order.value();
}
bool answers(const SaidReport& said, int number) {
    return said.report.code() != REPORT_ORDER_REPEATED && said.report.order_number() == number;
}

/// The same order, also where the bridge put "I say again" before it. One in own words is told by these.
bool is_same(const BridgeOrder& one, const BridgeOrder& other) {
    const std::string_view text = one.text().c_str(), other_text = other.text().c_str();
    return one.code() == other.code() && one.side() == other.side() && one.value() == other.value() &&
           (one.code() != BRIDGE_ORDER_TEXT || text.ends_with(other_text) || other_text.ends_with(text));
}

/// What the lesson knows of an order, which it calls by the number of the last time that it was given;
/// nullptr: nothing.
const OrderDone* known_of(const Attempt& attempt, const BridgeOrder& order) {
    const OrderDone* known = nullptr;
    if (!attempt.assessment) return known;
    for (const OrderDone& each : attempt.assessment->orders()) {
        if (each.number() < order.number() || (known != nullptr && each.number() > known->number())) continue;
        const auto given = std::ranges::find(attempt.orders, each.number(),
                                             [](const GivenOrder& one) { return one.order.number(); });
        if (given != attempt.orders.end() && is_same(given->order, order)) known = &each;
    }
    return known;
}

/// When the lesson says that an order was carried out: of several times that it was given the last before
/// that, or the first where it was so already.
void tell_done(const Attempt& attempt, const BridgeOrder& order, OrderSaid& row) {
    const OrderDone* known = known_of(attempt, order);
    if (known == nullptr) return;
    if (known->tick() == 0) { // and what was taken back nobody was to carry out any more
        row.judged = known->number() == row.number && order.state() != ORDER_CANCELLED;
        return;
    }
    const double done = attempt.time_of(known->tick());
    int carried_out = 0;
    for (const GivenOrder& each : attempt.orders)
        if (known_of(attempt, each.order) == known && (carried_out == 0 || each.order.time() <= done))
            carried_out = each.order.number();
    row.judged = row.number == carried_out;
    if (row.judged) row.done = done;
    if (row.number > carried_out) row.done_before = done;
}

bool is_to_pay_out(const BridgeOrder& order) {
    const bool out = order.code() == BRIDGE_ORDER_PAY_OUT || order.code() == BRIDGE_ORDER_VEER;
    return out && order.value() > 0 && (order.side() == SIDE_PORT || order.side() == SIDE_STARBOARD);
}

/// m, of the cable at the lip, where the ordered mark is about in the pipe.
double ordered_length(const BridgeOrder& order) {
    return order.value() * words::units::shackle;
}

/// Since when as much cable as was ordered stood out, for the last time before another length was ordered;
/// nothing: it never did.
std::optional<double> paid_out(const Attempt& attempt, const BridgeOrder& order) {
    constexpr double kFor = 15; // s: eased in steps, a cable stands for less in between
    const auto next = std::ranges::find_if(attempt.orders, [&](const GivenOrder& each) {
        return each.order.number() > order.number() && each.order.side() == order.side() &&
               is_to_pay_out(each.order) && !is_same(each.order, order);
    });
    const double until = next == attempt.orders.end() ? attempt.ended : next->order.time();
    std::optional<double> since, stood;
    for (const Truth& truth : attempt.sides[static_cast<std::size_t>(order.side())].truths) {
        if (truth.time < order.time()) continue;
        if (truth.time > until) break;
        const bool so = std::abs(truth.cable_out - ordered_length(order)) <= words::limits::cable_at_mark &&
                        std::abs(truth.cable_speed) <= words::limits::cable_stands;
        if (!so) since.reset();
        if (so && !since) since = truth.time;
        if (since && truth.time >= *since + kFor) stood = since;
    }
    return since ? since : stood;
}

/// A lesson that leaves the lengths to the bridge knows one order to pay out, and of it that the cable stood:
/// how much was out, and how each order after it went, the cable itself tells.
void tell_paid_out(const Attempt& attempt, const BridgeOrder& order, OrderSaid& row) {
    if (!attempt.assessment || !is_to_pay_out(order) || row.done_before) return;
    if (row.judged && !row.done) return;
    if (!row.judged && known_of(attempt, order) != nullptr) return; // said again: the last time tells it
    const Truth* truth =
        row.done ? attempt.sides[static_cast<std::size_t>(order.side())].truth_at(*row.done) : nullptr;
    if (truth != nullptr && std::abs(truth->cable_out - ordered_length(order)) <= words::units::shackle)
        return;
    row.judged = true;
    row.done = paid_out(attempt, order);
}

/// To the server what answers an order answers each time that the same was given: those that nobody had
/// repeated when it was said again are repeated too from then on.
void tell_said_again(const Attempt& attempt, const BridgeOrder& order, OrderSaid& row) {
    const bool by_itself = std::ranges::any_of(
        attempt.reports, [&](const SaidReport& said) { return repeats_rightly(said, order); });
    if (order.state() != ORDER_REPEATED || by_itself) return;
    for (const GivenOrder& other : attempt.orders) {
        if (other.order.number() == order.number() || !is_same(order, other.order)) continue;
        if (other.order.number() > order.number()) {
            row.state = row.repeated ? "repeated wrongly, said again" : "not repeated, said again";
            return;
        }
        for (const SaidReport& said : attempt.reports) // who repeated it named an earlier one
            if (!row.repeated && said.time >= order.time() && repeats_rightly(said, other.order))
                row.repeated = said.time;
    }
}

/// Nobody repeats a question.
bool is_question(BridgeOrderCode code) {
    return code < words::kBridgeOrderCode.size() && words::kBridgeOrderCode[code].repeat <= 0;
}

bool answers_question(const BridgeOrder& question, const Report& report) {
    const auto one_of = [&](std::initializer_list<ReportCode> codes) {
        return std::ranges::find(codes, report.code()) != codes.end();
    };
    if (report.side() >= 0 && question.side() >= 0 && report.side() != question.side()) return false;
    switch (question.code()) {
    case BRIDGE_ORDER_HOW_MUCH:
        return one_of({REPORT_SHACKLES_ON_DECK, REPORT_SHACKLES_IN_PIPE, REPORT_SHACKLES_IN_WATER});
    case BRIDGE_ORDER_HOW_LEADING:
        return one_of({REPORT_LEAD, REPORT_SHORT_STAY, REPORT_UP_AND_DOWN});
    case BRIDGE_ORDER_HOW_GROWING:
        return report.code() == REPORT_GROWING;
    case BRIDGE_ORDER_HOW_MUCH_WEIGHT:
        return report.code() == REPORT_WEIGHT;
    case BRIDGE_ORDER_BROUGHT_UP:
        return one_of({REPORT_BROUGHT_UP, REPORT_GROWING, REPORT_DRAGGING, REPORT_LEAD});
    default:
        return false;
    }
}

/// What came to a question that was asked before the moment from which the attempt goes on. What was said
/// then is of another attempt, and whatever was reported since may be about something else: the lesson knows.
void tell_answered_before(const Attempt& attempt, const BridgeOrder& question, double moment,
                          OrderSaid& row) {
    constexpr double kAtOnce = 0.05; // s: a tick or two, by which the lesson's word is behind the report's
    if (!row.answered) row.answered = row.done;
    for (const SaidReport& said : attempt.reports)
        if (row.answered && std::abs(said.time - *row.answered) < kAtOnce &&
            answers_question(question, said.report))
            row.answer = station::words(said.report);
    if (question.state() != ORDER_GIVEN) return;
    row.state = row.answered ? "answered"
                : row.judged ? "not answered"
                             : fmt::format("asked before {}, from where this goes on; whether it was "
                                           "answered is not told here",
                                           station::clock(moment));
}

/// What came to a question until it was asked again.
void tell_answered(const Attempt& attempt, const BridgeOrder& question, OrderSaid& row) {
    if (const Event* restored = attempt.restored();
        restored != nullptr && question.time() <= restored->time())
        return tell_answered_before(attempt, question, restored->time(), row);
    const auto again = std::ranges::find_if(attempt.orders, [&](const GivenOrder& each) {
        return each.order.number() > question.number() && is_same(each.order, question);
    });
    const bool asked_again = again != attempt.orders.end();
    for (const SaidReport& said : attempt.reports) {
        const bool in_time = said.time >= row.given && (!asked_again || said.time < again->order.time());
        if (row.answered || !in_time || !answers_question(question, said.report)) continue;
        row.answered = said.time;
        row.answer = station::words(said.report);
    }
    if (question.state() != ORDER_GIVEN) return; // taken back, or repeated all the same
    row.state = row.answered ? "answered" : asked_again ? "not answered, asked again" : "not answered";
}

} // namespace

std::vector<OrderSaid> orders_said(const Attempt& attempt) {
    std::vector<OrderSaid> rows;
    for (const auto& [order, changed] : attempt.orders) {
        OrderSaid row{.number = order.number(),
                      .given = order.time(),
                      .words = station::words(order),
                      .by = order.by().to_string(),
                      .question = is_question(order.code()),
                      .repeated = {},
                      .state = std::string(station::words(order.state())),
                      .answered = {},
                      .answer = {},
                      .repeat_by = {},
                      .do_by = {},
                      .done = {},
                      .done_before = {}};
        if (order.repeat_by() > order.time()) row.repeat_by = order.repeat_by();
        if (order.do_by() > order.time()) row.do_by = order.do_by();
        tell_done(attempt, order, row);
        tell_paid_out(attempt, order, row);
        for (const SaidReport& said : attempt.reports) {
            if (!row.repeated && repeats(said, order.number())) row.repeated = said.time;
            if (!row.answered && answers(said, order.number())) {
                row.answered = said.time;
                row.answer = station::words(said.report);
            }
        }
        if (row.question) tell_answered(attempt, order, row);
        tell_said_again(attempt, order, row);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<ReportSaid> reports_said(const Attempt& attempt) {
    std::vector<ReportSaid> rows;
    for (const SaidReport& said : attempt.reports) {
        const Report& report = said.report;
        if (report.code() == REPORT_ORDER_REPEATED) continue;
        ReportSaid row{.time = said.time,
                       .words = station::words(report),
                       .by = said.by,
                       .code = station::name(report.code()),
                       .value = report.value(),
                       .side = report.side(),
                       .truth = {},
                       .true_value = {},
                       .delay = {},
                       .milli = {}};
        tell_judged(attempt, said, row);
        if (!row.milli) tell_tackle(attempt, said, row);
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace windlass::debrief
