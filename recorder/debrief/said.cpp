#include "recorder/debrief/said.hpp"

#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::debrief {

namespace {

constexpr double kShackle = 27.5; // m

std::string_view state_words(BridgeOrderState state) {
    switch (state) {
    case ORDER_GIVEN:
        return "not yet repeated";
    case ORDER_REPEATED:
        return "repeated";
    case ORDER_MISREPEATED:
        return "repeated wrongly";
    case ORDER_NOT_REPEATED:
        return "not repeated in time";
    case ORDER_CANCELLED:
        return "cancelled";
    }
    return "unknown";
}

/// The event that makes a report true.
struct Cause {
    ReportCode report;
    std::string_view event;
};
constexpr std::array<Cause, 7> kCauses{{{REPORT_LET_GO, "anchor.let_go"},
                                        {REPORT_ON_THE_BOTTOM, "anchor.on_bottom"},
                                        {REPORT_BROUGHT_UP, "anchor.brought_up"},
                                        {REPORT_DRAGGING, "anchor.dragging"},
                                        {REPORT_ANCHOR_AWEIGH, "anchor.aweigh"},
                                        {REPORT_ANCHOR_HOME, "anchor.housed"},
                                        {REPORT_FOUL_ANCHOR, "anchor.fouled"}}};

/// The last event of that code and side before the time, else the first after it.
const Event* cause_of(const Attempt& attempt, const SaidReport& said, std::string_view code) {
    const Event* found = nullptr;
    for (const Event& event : attempt.events) {
        if (std::string_view(event.code().c_str()) != code) continue;
        if (said.report.side() >= 0 && event.side() != said.report.side()) continue;
        if (found == nullptr || event.time() <= said.time) found = &event;
    }
    return found;
}

void tell_event(const Attempt& attempt, const SaidReport& said, ReportSaid& row) {
    const auto cause = std::ranges::find(kCauses, said.report.code(), &Cause::report);
    if (cause == kCauses.end()) return;
    if (const Event* event = cause_of(attempt, said, cause->event)) {
        row.delay = said.time - event->time();
        row.truth = fmt::format("{} at {}", event->text().to_string(), station::clock(event->time()));
    } else {
        row.truth = "it never was so";
    }
}

bool counts_shackles(ReportCode code) {
    return code == REPORT_SHACKLES_ON_DECK || code == REPORT_SHACKLES_IN_WATER ||
           code == REPORT_SHACKLES_IN_PIPE;
}

void tell_state(const Attempt& attempt, const SaidReport& said, ReportSaid& row) {
    const Report& report = said.report;
    if (report.side() != SIDE_PORT && report.side() != SIDE_STARBOARD) return;
    const Truth* truth = attempt.sides[static_cast<std::size_t>(report.side())].truth_at(said.time);
    if (truth == nullptr) return;
    const auto add = [&](const std::string& text) { row.truth += (row.truth.empty() ? "" : ", ") + text; };
    if (counts_shackles(report.code())) {
        row.true_value = truth->cable_out / kShackle;
        add(station::shackles(*row.true_value) + " outboard of the lip");
    }
    if (report.lead() != 0) add("lead " + station::lead(truth->lead_clock));
    if (report.stay() != STAY_NOT_GIVEN) add(station::words(truth->stay));
    if (report.growing() != GROWING_NOT_GIVEN || report.weight() != WEIGHT_NOT_GIVEN)
        add(station::load(truth->tension) + " at the lip");
}

bool repeats(const SaidReport& said, int number) {
    return said.report.code() == REPORT_ORDER_REPEATED && said.report.order_number() == number;
}
bool answers(const SaidReport& said, int number) {
    return said.report.code() != REPORT_ORDER_REPEATED && said.report.order_number() == number;
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
                      .state = std::string(state_words(order.state())),
                      .answered = {},
                      .answer = {},
                      .repeat_by = {},
                      .do_by = {}};
        if (order.repeat_by() > order.time()) row.repeat_by = order.repeat_by();
        if (order.do_by() > order.time()) row.do_by = order.do_by();
        for (const SaidReport& said : attempt.reports) {
            if (!row.repeated && repeats(said, order.number())) row.repeated = said.time;
            if (!row.answered && answers(said, order.number())) {
                row.answered = said.time;
                row.answer = station::words(said.report);
            }
        }
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
                       .delay = {}};
        tell_event(attempt, said, row);
        tell_state(attempt, said, row);
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace windlass::debrief
