#include "recorder/debrief/said.hpp"

#include "station/format.hpp"
#include "station/names.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace windlass::debrief {

namespace {

/// What the server's judge has made of the report.
void tell_judged(const Attempt& attempt, const SaidReport& said, ReportSaid& row) {
    if (!attempt.assessment) return;
    for (const JudgedReport& judged : attempt.assessment->reports()) {
        const bool of_it = judged.tick() == said.tick && judged.code() == said.report.code() &&
                           (said.report.side() < 0 || said.report.side() == judged.side());
        if (!of_it) continue;
        row.truth += (row.truth.empty() ? "" : "; ") + judged.text().to_string();
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
        return "cable " + station::cable_speed(truth.cable_speed);
    case REPORT_BRAKE_DOES_NOT_HOLD:
        return fmt::format("brake bore {}, of {} that it could", station::load(truth.brake_load),
                           station::load(truth.brake_capacity));
    default:
        return "";
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
    const bool counts_shackles = report.code() < words::kReportCode.size() &&
                                 words::kReportCode[report.code()].mark_at != words::MarkAt::none;
    if (counts_shackles)
        add(fmt::format("{:.1f} m ({}) outboard of the lip", truth->cable_out,
                        station::in_shackles(truth->cable_out)));
    if (report.lead() != 0) add("lead " + station::lead(truth->lead_clock));
    if (report.stay() != STAY_NOT_GIVEN) add(station::words(truth->stay));
    if (report.growing() != GROWING_NOT_GIVEN || report.weight() != WEIGHT_NOT_GIVEN)
        add(station::load(truth->tension) + " at the lip");
}

/// When the lesson says that an order was carried out.
void tell_done(const Attempt& attempt, OrderSaid& row) {
    if (!attempt.assessment) return;
    for (const OrderDone& each : attempt.assessment->orders()) {
        if (each.number() != row.number) continue;
        row.judged = true;
        if (each.tick() > 0) row.done = attempt.time_of(each.tick());
    }
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

} // namespace

std::vector<OrderSaid> orders_said(const Attempt& attempt) {
    std::vector<OrderSaid> rows;
    for (const auto& [order, changed] : attempt.orders) {
        OrderSaid row{.number = order.number(),
                      .given = order.time(),
                      .words = station::words(order),
                      .by = order.by().to_string(),
                      .repeated = {},
                      .state = std::string(station::words(order.state())),
                      .answered = {},
                      .answer = {},
                      .repeat_by = {},
                      .do_by = {},
                      .done = {}};
        if (order.repeat_by() > order.time()) row.repeat_by = order.repeat_by();
        if (order.do_by() > order.time()) row.do_by = order.do_by();
        tell_done(attempt, row);
        for (const SaidReport& said : attempt.reports) {
            if (!row.repeated && repeats(said, order.number())) row.repeated = said.time;
            if (!row.answered && answers(said, order.number())) {
                row.answered = said.time;
                row.answer = station::words(said.report);
            }
        }
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
