#include "recorder/debrief/moments.hpp"

#include "recorder/debrief/curves.hpp"
#include "recorder/debrief/judgement.hpp"
#include "recorder/debrief/said.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "station/format.hpp"
#include "station/line_view.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace windlass::debrief {

namespace {

constexpr std::size_t kMaxMoments = 30;
constexpr double kRuns = 6; // m/min; below, a cable does not run, it is eased

constexpr double kAgain = 60; // s, within which the same event is no new moment

/// What the anchor does, what somebody marked, and what the server warned of.
bool is_moment(const Event& event) {
    const words::Event* row = words::find_event(event.code().c_str());
    return row != nullptr ? row->moment : event.severity() >= EVENT_WARNING;
}

/// What a hand did after a fault; empty: nothing.
std::string reaction(const Attempt& attempt, const Event& fault) {
    const auto moved = std::ranges::find_if(attempt.lever_moves, [&](const LeverMove& move) {
        return move.time > fault.time() && (fault.side() < 0 || move.side == fault.side());
    });
    return moved == attempt.lever_moves.end()
               ? "; no lever of it was moved after that"
               : fmt::format("; first lever moved {:.1f} s later", moved->time - fault.time());
}

void add_events(const Attempt& attempt, std::vector<Moment>& moments) {
    std::map<std::pair<std::string, int>, double> last; // of its code and side
    for (const Event& event : attempt.events) {
        if (!is_moment(event)) continue;
        const auto [known, first] = last.try_emplace({event.code().to_string(), event.side()}, event.time());
        const bool again = !first && event.time() < known->second + kAgain && event.code() != "fault.active";
        known->second = event.time();
        if (again) continue;
        std::string what = in_seat_units(station::told(event));
        if (event.code() == "fault.active") what += reaction(attempt, event);
        moments.push_back({event.time(), std::move(what), event.side()});
    }
}

void add_extremes(const Attempt& attempt, std::vector<Moment>& moments) {
    const double until = attempt.counted_until();
    for (int index = 0; index < 2; ++index) {
        const Side& side = attempt.sides[static_cast<std::size_t>(index)];
        if (!side.worked) continue;
        const std::string_view of = index == SIDE_PORT ? "port" : "starboard";
        if (const auto largest = side.curves[kTension].largest_until(until))
            moments.push_back({largest->time,
                               fmt::format("{}: largest tension at the lip, {}", of,
                                           station::tonnes(largest->value * words::units::tonne)),
                               index});
        if (const auto fastest = side.curves[kCableSpeed].largest_until(until);
            fastest && fastest->value > kRuns)
            moments.push_back({fastest->time,
                               fmt::format("{}: cable runs out fastest, {}", of,
                                           cable_speed_text(fastest->value * words::units::metre_a_minute)),
                               index});
    }
}

/// What the judge has found wrong: criteria, orders, reports.
void add_failures(const Attempt& attempt, std::vector<Moment>& moments) {
    for (const Mark& mark : judgement_of(attempt).marks)
        if (mark.criterion->counts() && !mark.criterion->met() && mark.criterion->state() != CRITERION_OPEN &&
            mark.criterion->state() != CRITERION_NOT_IN_PLAY) // which was missed at no moment
            moments.push_back({mark.time, fmt::format("not met: {}", title_of(*mark.criterion)), -1});
    for (const OrderSaid& order : orders_said(attempt))
        if (order.judged && !order.done)
            moments.push_back(
                {order.given,
                 fmt::format("{}: {}", order.question ? "not answered" : "order not carried out",
                             order.words),
                 -1});
    for (const ReportSaid& report : reports_said(attempt))
        if (report.milli && *report.milli == 0)
            moments.push_back(
                {report.time, fmt::format("wrong report: {}; {}", report.words, report.truth), report.side});
}

} // namespace

std::vector<Moment> moments_of(const Attempt& attempt) {
    std::vector<Moment> moments;
    // The most telling first: what is beyond the number that a page bears is left out.
    add_failures(attempt, moments);
    add_extremes(attempt, moments);
    add_events(attempt, moments);
    moments.resize(std::min(moments.size(), kMaxMoments));
    std::ranges::stable_sort(moments, {}, &Moment::time);
    return moments;
}

} // namespace windlass::debrief
