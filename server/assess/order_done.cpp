#include "server/assess/order_done.hpp"

#include "server/assess/quantities.hpp"
#include "server/exercise/picture/snapshot.hpp"
#include "server/exercise/watch/event_detector.hpp"
#include "server/physics/base/units.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::assess {

namespace {

using exercise::BridgeOrderCode;
using exercise::kHardOn;
using exercise::ReportCode;

constexpr double kEased = 0.85;   // of the hand-wheel: three quarters of a turn off, from where cable may run
constexpr double kStopped = 0.05; // m/s, of the cable
constexpr double kStands = words::limits::cable_stands; // m/s, of a cable that is paid out
constexpr double kAtMark = words::limits::cable_at_mark / words::units::shackle; // shackles
constexpr double kAtMetres = 1;                                                  // m beside the ordered ones
constexpr double kSoon = 5; // s before levers are where a report has them, in which nobody tells it apart

Bounds above(const char* quantity, double value) {
    return {.quantity = quantity_of(quantity), .at_least = -kNoLimit, .above = value, .below = kNoLimit};
}
Bounds below(const char* quantity, double value) {
    return {.quantity = quantity_of(quantity), .at_least = -kNoLimit, .above = -kNoLimit, .below = value};
}
Bounds between(const char* quantity, double low, double high) {
    return {.quantity = quantity_of(quantity), .at_least = -kNoLimit, .above = low, .below = high};
}
Bounds is(const char* quantity) {
    return above(quantity, 0.5);
}
Bounds is_not(const char* quantity) {
    return below(quantity, 0.5);
}
Bounds stopped() {
    return between("cable_speed", -kStopped, kStopped);
}
/// Against a closed bar it comes in by the bar's play, and no farther.
std::vector<Bounds> heaves() {
    return {below("cable_speed", -0.02), is_not("stopper_on")};
}

} // namespace

int watch(Lesson& lesson, const WatchedEvent& event) {
    const auto found = std::find_if(lesson.events.begin(), lesson.events.end(), [&](const WatchedEvent& one) {
        return one.code == event.code && one.side == event.side;
    });
    if (found != lesson.events.end()) return static_cast<int>(found - lesson.events.begin());
    lesson.events.push_back(event);
    return static_cast<int>(lesson.events.size()) - 1;
}

int watch(Lesson& lesson, const WatchedReport& report) {
    const auto found =
        std::find_if(lesson.reports.begin(), lesson.reports.end(), [&](const WatchedReport& one) {
            return one.code == report.code && one.side == report.side;
        });
    if (found != lesson.reports.end()) return static_cast<int>(found - lesson.reports.begin());
    lesson.reports.push_back(report);
    return static_cast<int>(lesson.reports.size()) - 1;
}

Condition usual_done(Lesson& lesson, const exercise::BridgeOrderGiven& order, int side) {
    Condition done{.side = side};
    const auto answered = [&] {
        done.signs.push_back({SignKind::order_answered, static_cast<int>(lesson.orders.size())});
    };
    const auto came = [&](const char* event) {
        done.signs.push_back({SignKind::event, watch(lesson, {event, side})});
    };
    switch (order.code) {
    case BridgeOrderCode::stand_by:
        done.bounds = {above("brake_position", kHardOn), is("clutch_out"), is_not("stopper_on")};
        break;
    case BridgeOrderCode::clear_away:
        done.bounds = {above("brake_position", kHardOn), is_not("stopper_on"), stopped()};
        break;
    case BridgeOrderCode::walk_out:
        done.bounds = {between("cable_out", order.value - kAtMetres, order.value + kAtMetres), stopped(),
                       above("brake_position", kHardOn)};
        break;
    case BridgeOrderCode::let_go:
        // Cable that the motor walks out is not let go.
        done.bounds = {below("brake_position", kEased), is_not("clutch_in"), above("cable_speed", 0.2)};
        break;
    case BridgeOrderCode::pay_out:
    case BridgeOrderCode::veer:
        done.bounds = {between("cable_speed", -kStands, kStands)};
        if (order.value > 0) // else to what the bridge chooses
            done.bounds.push_back(between("shackles", order.value - kAtMark, order.value + kAtMark));
        break;
    case BridgeOrderCode::check:
        done.bounds = {below("cable_speed", 1)};
        break;
    case BridgeOrderCode::hold_on:
        done.bounds = {stopped(), above("brake_position", kHardOn)};
        if (order.value > 0)
            done.bounds.push_back(between("shackles", order.value - kAtMark, order.value + kAtMark));
        break;
    case BridgeOrderCode::walk_back:
        if (is_to_a_figure(order)) // what is only begun is not carried out
            done.bounds = {between("cable_speed", -kStands, kStands),
                           between("shackles", order.value - kAtMark, order.value + kAtMark)};
        else
            done.bounds = {is("clutch_in"), above("cable_speed", 0.02)};
        break;
    case BridgeOrderCode::gear_in:
        done.bounds = {is("clutch_in")};
        break;
    case BridgeOrderCode::gear_out:
        done.bounds = {is("clutch_out")};
        break;
    case BridgeOrderCode::heave:
    case BridgeOrderCode::heave_to:
        if (is_to_a_figure(order))
            done.bounds = {between("cable_speed", -kStands, kStands),
                           below("shackles", order.value + kAtMark)};
        else
            done.bounds = heaves();
        break;
    case BridgeOrderCode::stop_heaving:
        done.bounds = {below("speed_lever", 0.01), stopped()};
        break;
    case BridgeOrderCode::secure:
        done.bounds = {above("brake_position", kHardOn), is("stopper_on"), is("clutch_out")};
        break;
    case BridgeOrderCode::buoy_cable:
        came("cable.broken");
        break;
    case BridgeOrderCode::slip:
        came("cable.slipped");
        break;
    case BridgeOrderCode::clear_anchor:
        came("anchor.cleared");
        break;
    case BridgeOrderCode::how_much:
        answered();
        break;
    case BridgeOrderCode::how_leading:
        answered();
        break;
    case BridgeOrderCode::how_growing:
        answered();
        break;
    case BridgeOrderCode::how_much_weight:
        answered();
        break;
    case BridgeOrderCode::brought_up:
        answered();
        break;
    default:
        break; // nothing that the windlass shows
    }
    return done;
}

bool is_question(BridgeOrderCode code) {
    return words::row_of(code).repeat <= 0;
}

bool is_to_a_figure(const exercise::BridgeOrderGiven& order) {
    switch (order.code) {
    case BridgeOrderCode::walk_out:
    case BridgeOrderCode::pay_out:
    case BridgeOrderCode::veer:
    case BridgeOrderCode::walk_back:
    case BridgeOrderCode::hold_on:
    case BridgeOrderCode::heave_to:
        return order.value > 0;
    default:
        return false;
    }
}

bool is_to_stand(BridgeOrderCode code, double figure) {
    switch (code) {
    case BridgeOrderCode::walk_out:
    case BridgeOrderCode::pay_out:
    case BridgeOrderCode::veer:
    case BridgeOrderCode::hold_on:
        return figure > 0;
    default:
        return false;
    }
}

bool stands_at_figure(BridgeOrderCode code, double figure, const exercise::TackleView& tackle) {
    const double more = physics::shackles_from_metres(tackle.chain.cable_out) - figure; // than was ordered
    const double speed = std::abs(tackle.windlass.cable_speed);
    const bool braked = speed < kStopped && tackle.windlass.brake_position > kHardOn;
    switch (code) {
    case BridgeOrderCode::walk_out:
        return std::abs(tackle.chain.cable_out - figure) < kAtMetres && braked;
    case BridgeOrderCode::hold_on:
        return std::abs(more) < kAtMark && braked;
    case BridgeOrderCode::heave_to:
        return more < kAtMark && speed < kStands;
    default: // out to it
        return std::abs(more) < kAtMark && speed < kStands;
    }
}

bool lay_usual_truth(Lesson& lesson, Criterion& criterion) {
    const words::Report& row = words::row_of(criterion.report);
    if (row.half > 0) {
        Condition when{.side = criterion.side};
        if (!row.event.empty()) {
            when.signs.push_back({SignKind::event, watch(lesson, {std::string(row.event), criterion.side})});
        } else {
            if (criterion.report == ReportCode::short_stay)
                when.bounds.push_back(above("top_angle_deg", words::limits::stay_short));
            if (criterion.report == ReportCode::up_and_down)
                when.bounds.push_back(above("top_angle_deg", words::limits::stay_up_and_down));
            const std::vector<Bounds> heaving = heaves();
            when.bounds.insert(when.bounds.end(), heaving.begin(), heaving.end());
        }
        criterion.truth = ReportTruth::moment;
        criterion.truth_moment = static_cast<int>(lesson.moments.size());
        lesson.moments.push_back({"", when});
        criterion.early = row.early, criterion.full = row.full, criterion.half = row.half;
        return true;
    }
    if (row.half_off > 0) {
        criterion.truth = ReportTruth::figure;
        criterion.full_off = row.full_off, criterion.half_off = row.half_off;
        return true;
    }
    switch (criterion.report) {
    case ReportCode::growing:
        criterion.truth = ReportTruth::growth;
        return true;
    case ReportCode::standing_by:
    case ReportCode::anchor_ready:
        criterion.truth = ReportTruth::state;
        criterion.early = kSoon;
        criterion.that = {.side = criterion.side,
                          .bounds = {above("brake_position", kHardOn), is_not("stopper_on")}};
        return true;
    case ReportCode::secured:
        criterion.truth = ReportTruth::state;
        criterion.early = kSoon;
        criterion.that = {.side = criterion.side,
                          .bounds = {above("brake_position", kHardOn), is("stopper_on"), is("clutch_out")}};
        return true;
    case ReportCode::clear_anchor:
    case ReportCode::foul_anchor: {
        const bool foul = criterion.report == ReportCode::foul_anchor;
        criterion.truth = ReportTruth::state;
        criterion.that = {.side = criterion.side,
                          .bounds = {foul ? above("fouled", 0.05) : below("fouled", 0.05),
                                     below("anchor_depth", words::limits::looked_through)}};
        return true;
    }
    default:
        return false;
    }
}

} // namespace windlass::assess
