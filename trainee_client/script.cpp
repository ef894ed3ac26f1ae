#include "trainee_client/script.hpp"

#include "station/names.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace windlass::trainee {

using station::Picture;

namespace {

const station::TacklePicture& tackle(const Picture& picture, int side) {
    return picture.tackle.at(static_cast<std::size_t>(side));
}

template <class T, class Read>
std::optional<double> value(const station::Latest<T>& latest, Read read) {
    return latest ? std::optional<double>{read(*latest)} : std::nullopt;
}

/// A gauge of the forecastle; nothing where it is not fitted.
template <class Read>
std::optional<double> gauge(const Picture& picture, int side, bool (ForecastleView::*fitted)() const,
                            Read read) {
    const auto& view = tackle(picture, side).view;
    return view && (*view.*fitted)() ? std::optional<double>{read(*view)} : std::nullopt;
}

/// An instrument of the bridge; nothing while it does not work.
template <class Read>
std::optional<double> instrument(const Picture& picture, bool (BridgeView::*works)() const, Read read) {
    const auto& bridge = picture.bridge;
    return bridge && (*bridge.*works)() ? std::optional<double>{read(*bridge)} : std::nullopt;
}

constexpr std::array<Quantity, 29> kQuantities{{
    {"time", "s", Eyes::seat,
     [](const Picture& p, int) { return value(p.status, [](const auto& s) { return s.time(); }); }},
    {"counter", "m", Eyes::seat,
     [](const Picture& p, int side) {
         return gauge(p, side, &ForecastleView::counter_fitted,
                      [](const auto& v) { return v.cable_out_indicated(); });
     }},
    {"counter_shackles", "shackles", Eyes::seat,
     [](const Picture& p, int side) {
         return gauge(p, side, &ForecastleView::counter_fitted,
                      [](const auto& v) { return v.cable_out_indicated() / words::units::shackle; });
     }},
    {"counter_speed", "m/s", Eyes::seat,
     [](const Picture& p, int side) {
         return gauge(p, side, &ForecastleView::counter_fitted,
                      [](const auto& v) { return v.cable_speed_indicated(); });
     }},
    {"load_cell", "N", Eyes::seat,
     [](const Picture& p, int side) {
         return gauge(p, side, &ForecastleView::load_cell_fitted,
                      [](const auto& v) { return v.gypsy_load_indicated(); });
     }},
    {"cable_speed_seen", "m/s", Eyes::seat,
     [](const Picture& p, int side) {
         return value(tackle(p, side).view, [](const auto& v) { return v.cable_speed_seen(); });
     }},
    {"brake_position", "", Eyes::seat,
     [](const Picture& p, int side) {
         const auto position = [](const auto& sample) { return sample.brake_position(); };
         const auto& load = tackle(p, side).load; // comes more often than the view, with the same in it
         return load ? value(load, position) : value(tackle(p, side).view, position);
     }},
    {"speed_by_gps", "m/s", Eyes::seat,
     [](const Picture& p, int) {
         return instrument(p, &BridgeView::gps_works, [](const auto& b) { return b.speed_over_ground(); });
     }},
    {"speed_by_log", "m/s", Eyes::seat,
     [](const Picture& p, int) {
         return instrument(p, &BridgeView::log_works, [](const auto& b) { return b.speed_through_water(); });
     }},
    {"gps_x", "m", Eyes::seat,
     [](const Picture& p, int) {
         return instrument(p, &BridgeView::gps_works, [](const auto& b) { return b.position().x(); });
     }},
    {"gps_y", "m", Eyes::seat,
     [](const Picture& p, int) {
         return instrument(p, &BridgeView::gps_works, [](const auto& b) { return b.position().y(); });
     }},
    {"heading_deg", "deg", Eyes::seat,
     [](const Picture& p, int) {
         return instrument(p, &BridgeView::gyro_works,
                           [](const auto& b) { return b.heading() / words::units::degree; });
     }},
    {"angle_seen_deg", "deg", Eyes::seat,
     [](const Picture& p, int side) {
         return value(tackle(p, side).view,
                      [](const auto& v) { return v.top_angle() / words::units::degree; });
     }},
    {"motor_speed_heard", "", Eyes::seat,
     [](const Picture& p, int side) {
         return value(tackle(p, side).view, [](const auto& v) { return v.motor_speed_heard(); });
     }},
    {"power_lamp", "", Eyes::seat,
     [](const Picture& p, int side) {
         return value(tackle(p, side).view, [](const auto& v) { return v.power() ? 1.0 : 0.0; });
     }},
    {"tripped_lamp", "", Eyes::seat,
     [](const Picture& p, int side) {
         return value(tackle(p, side).view, [](const auto& v) { return v.tripped() ? 1.0 : 0.0; });
     }},
    {"lining_seen", "", Eyes::seat,
     [](const Picture& p, int side) {
         return value(tackle(p, side).view, [](const auto& v) { return double(v.lining()); });
     }},
    {"anchor_seen", "", Eyes::seat,
     [](const Picture& p, int side) {
         return value(tackle(p, side).view, [](const auto& v) { return double(v.anchor()); });
     }},
    {"vibration", "", Eyes::seat,
     [](const Picture& p, int side) {
         return value(tackle(p, side).view, [](const auto& v) { return double(v.vibration()); });
     }},
    {"cable_out", "m", Eyes::coach,
     [](const Picture& p, int side) {
         return value(tackle(p, side).chain, [](const auto& c) { return c.cable_out(); });
     }},
    {"shackles", "shackles", Eyes::coach,
     [](const Picture& p, int side) {
         return value(tackle(p, side).chain, [](const auto& c) { return c.cable_out_shackles(); });
     }},
    {"tension", "N", Eyes::coach,
     [](const Picture& p, int side) {
         return value(tackle(p, side).load, [](const auto& w) { return w.hawse_tension(); });
     }},
    {"brake_load", "N", Eyes::coach,
     [](const Picture& p, int side) {
         return value(tackle(p, side).load, [](const auto& w) { return w.brake_load(); });
     }},
    {"cable_speed", "m/s", Eyes::coach,
     [](const Picture& p, int side) {
         return value(tackle(p, side).load, [](const auto& w) { return w.cable_speed(); });
     }},
    {"lining_temperature", "K", Eyes::coach,
     [](const Picture& p, int side) {
         return value(tackle(p, side).load, [](const auto& w) { return w.lining_temperature(); });
     }},
    {"height_above_bottom", "m", Eyes::coach,
     [](const Picture& p, int side) {
         return value(tackle(p, side).anchor, [](const auto& a) { return a.height_above_bottom(); });
     }},
    {"cable_on_bottom", "m", Eyes::coach,
     [](const Picture& p, int side) {
         return value(tackle(p, side).chain, [](const auto& c) { return c.on_bottom(); });
     }},
    {"ship_speed", "m/s", Eyes::coach,
     [](const Picture& p, int) {
         return value(p.ship, [](const auto& s) { return s.speed_over_ground(); });
     }},
    {"surge", "m/s", Eyes::coach,
     [](const Picture& p, int) { return value(p.ship, [](const auto& s) { return s.surge(); }); }},
}};

/// One condition as it stands: whether it holds, and in words.
struct Finding {
    bool holds;
    std::string text;
};

std::string shown(std::optional<double> value) {
    return value ? fmt::format("{:.4g}", *value) : std::string{"not heard yet"};
}

std::string limits(const Bounds& bounds) {
    std::string text;
    if (bounds.at_least) text += fmt::format(" at least {:g}", *bounds.at_least);
    if (bounds.above) text += fmt::format(" above {:g}", *bounds.above);
    if (bounds.below) text += fmt::format(" below {:g}", *bounds.below);
    return text;
}

Finding look(const Bounds& bounds, const Picture& picture, int side) {
    const auto now = bounds.quantity->read(picture, side);
    const std::string unit = *bounds.quantity->unit ? fmt::format(" {}", bounds.quantity->unit) : "";
    return {now && bounds.hold(*now),
            fmt::format("{}{}{} (now {})", bounds.quantity->name, limits(bounds), unit, shown(now))};
}

Finding look_for(bool holds, std::string_view wanted, bool heard, std::string_view now) {
    return {heard && holds, fmt::format("{} (now {})", wanted, heard ? now : "not heard yet")};
}

bool touches_bottom(AnchorPhase phase) {
    return phase == ANCHOR_ON_BOTTOM || phase == ANCHOR_DIGGING_IN || phase == ANCHOR_HOLDING ||
           phase == ANCHOR_DRAGGING;
}

/// Whether one of the logs has an event of that code.
template <class... T>
Finding seen_in(const char* what, const std::string& code, const station::EventLog<T>&... logs) {
    const auto seen = [&](const auto& log) {
        return std::ranges::any_of(log.kept, [&](const auto& event) { return event.code() == code.c_str(); });
    };
    return {(seen(logs) || ...), fmt::format("{} {} (not seen)", what, code)};
}

/// Clutch and stopper, as the windlass shows them; WindlassLoad and ForecastleView name them alike.
template <class Sample>
void look_at_windlass(const Condition& when, const Sample& now, bool heard, std::vector<Finding>& all) {
    if (when.clutch_in)
        all.push_back(look_for(now.clutch() == (*when.clutch_in ? CLUTCH_IN : CLUTCH_OUT),
                               *when.clutch_in ? "clutch in" : "clutch out", heard,
                               station::name(now.clutch())));
    if (when.stopper_closed)
        all.push_back(look_for(now.stopper_closed() == *when.stopper_closed,
                               *when.stopper_closed ? "stopper on" : "stopper off", heard,
                               now.stopper_closed() ? "on" : "off"));
}

/// Whether the bridge has heard it since the step before.
Finding look_for_report(const Condition& when, const Picture& picture, int side,
                        std::uint64_t reports_before) {
    const int wanted = when.reported_side.value_or(side);
    const auto heard = [&](const Report& report) {
        const double figure = report.code() == REPORT_LEAD ? report.lead() : report.value();
        return report.code() == *when.reported && report.side() == wanted &&
               (!when.reported_value || when.reported_value->hold(figure));
    };
    const std::string figure = when.reported_value ? limits(*when.reported_value) : "";
    return {std::ranges::any_of(picture.reports.after(reports_before), heard),
            fmt::format("{}{} to be reported (not heard)", station::name(*when.reported), figure)};
}

std::vector<Finding> findings(const Condition& when, const Picture& picture, int side, double since_step,
                              std::uint64_t reports_before) {
    const station::TacklePicture& one = tackle(picture, side);
    std::vector<Finding> all;
    if (when.after)
        all.push_back({since_step >= *when.after,
                       fmt::format("{:g} s after the step before (now {:.1f} s)", *when.after, since_step)});
    for (const Bounds& bounds : when.bounds)
        all.push_back(look(bounds, picture, side));
    const auto& anchor = one.anchor;
    const auto phase = station::name(anchor->phase());
    if (when.anchor_on_bottom)
        all.push_back(look_for(touches_bottom(anchor->phase()) == *when.anchor_on_bottom,
                               *when.anchor_on_bottom ? "anchor on the bottom" : "anchor off the bottom",
                               bool(anchor), phase));
    if (when.anchor_phase)
        all.push_back(look_for(anchor->phase() == *when.anchor_phase,
                               fmt::format("anchor {}", station::name(*when.anchor_phase)), bool(anchor),
                               phase));
    if (one.load)
        look_at_windlass(when, *one.load, true, all);
    else
        look_at_windlass(when, *one.view, bool(one.view), all);
    if (when.event) all.push_back(seen_in("event", *when.event, picture.events));
    if (when.seat_event)
        all.push_back(
            seen_in("seat event", *when.seat_event, picture.seat_events[0], picture.seat_events[1]));
    if (when.order) {
        const BridgeOrder* waiting = picture.order_to_repeat();
        all.push_back(look_for(waiting && waiting->code() == *when.order,
                               fmt::format("order {}", station::name(*when.order)), true,
                               waiting ? station::name(waiting->code()) : "none waits"));
    }
    if (when.ordered) {
        const bool given = std::ranges::any_of(picture.orders, [&](const BridgeOrder& order) {
            return order.code() == *when.ordered && order.state() != ORDER_CANCELLED &&
                   (order.side() < 0 || order.side() == side) &&
                   (!when.ordered_value || order.value() == *when.ordered_value);
        });
        all.push_back(
            look_for(given,
                     fmt::format("{}{} to be ordered", station::name(*when.ordered),
                                 when.ordered_value ? fmt::format(" {:g}", *when.ordered_value) : ""),
                     true, "not ordered"));
    }
    if (when.reported) all.push_back(look_for_report(when, picture, side, reports_before));
    return all;
}

} // namespace

std::span<const Quantity> quantities() {
    return kQuantities;
}

bool Condition::holds(const Picture& picture, int side, double since_step,
                      std::uint64_t reports_before) const {
    return std::ranges::all_of(findings(*this, picture, side, since_step, reports_before), &Finding::holds);
}

std::string Condition::unmet(const Picture& picture, int side, double since_step,
                             std::uint64_t reports_before) const {
    std::string text;
    for (const Finding& finding : findings(*this, picture, side, since_step, reports_before))
        if (!finding.holds) text += (text.empty() ? "" : ", ") + finding.text;
    return text;
}

void Orders::apply(station::LeverSet& set) const {
    const auto move = [](auto& lever, const auto& order) {
        if (order) lever = *order;
    };
    move(set.windlass.brake, brake);
    move(set.windlass.speed_lever, speed_lever);
    move(set.windlass.clutch_in, clutch_in);
    move(set.windlass.stopper_closed, stopper_closed);
    move(set.windlass.emergency_stop, emergency_stop);
    move(set.helm.engine, engine);
    move(set.helm.rudder, rudder);
    move(set.helm.bow_thruster, bow_thruster);
    move(set.helm.stern_thruster, stern_thruster);
}

Report sample_of(const ReportOrder& order, int side, const Picture& picture) {
    Report sample;
    sample.code(order.code);
    sample.side(order.side.value_or(side));
    sample.value(order.value);
    sample.lead(order.lead);
    sample.stay(order.stay);
    sample.growing(order.growing);
    sample.weight(order.weight);
    sample.order_number(order.order_number);
    if (order.order) {
        sample.order_code(*order.order);
        const BridgeOrder* newest = picture.order(*order.order); // of what is proposed it is another's
        if (newest && order.order_number == 0 && order.code == REPORT_ORDER_REPEATED)
            sample.order_number(newest->number());
    }
    sample.text() = order.text;
    return sample;
}

bool Orders::any() const {
    return brake || speed_lever || engine || rudder || bow_thruster || stern_thruster || clutch_in ||
           stopper_closed || emergency_stop;
}

std::optional<Answer> answer_to(const Question& question, const QuestionAnswers& answers) {
    const std::string id = question.id().to_string();
    const auto found = answers.find(id);
    if (found == answers.end()) return std::nullopt;
    Answer answer;
    answer.question() = id;
    const auto* number = std::get_if<double>(&found->second);
    if (number != nullptr && question.choices().empty()) {
        answer.kind(ANSWER_NUMBER);
        answer.value(*number);
        return answer;
    }
    const auto said = [&](const QuestionChoice& choice) {
        return number == nullptr && choice.text() == std::get<std::string>(found->second);
    };
    const auto choice = std::ranges::find_if(question.choices(), said);
    if (choice == question.choices().end())
        throw std::runtime_error(
            fmt::format("the script's answer to \"{}\" is none that the question allows: {}", id,
                        question.choices().empty() ? "a number" : "the text of one of its choices"));
    answer.kind(ANSWER_CHOICE);
    answer.choice(static_cast<std::uint32_t>(choice - question.choices().begin()));
    return answer;
}

} // namespace windlass::trainee
