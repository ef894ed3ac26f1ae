#include "station/line_view.hpp"

#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace windlass::station {

namespace {

std::string run_text(const ExerciseStatus& status, double time) {
    const std::string scale =
        status.time_scale() > 0 ? fmt::format("x{:.3g}", status.time_scale()) : std::string{"x max"};
    return fmt::format("{} {} {}", clock(time), name(status.state()), scale);
}

/// WindlassLoad and ForecastleView name these alike. brake: how hot its lining is.
template <class Sample>
std::string levers_text(const Sample& sample, const std::string& brake) {
    std::string text = fmt::format("  brake {} {}", percent(sample.brake_position()), brake);
    text += fmt::format("  clutch {}", name(sample.clutch()));
    if (sample.stopper_closed()) text += "  stopper on";
    text += !sample.power()           ? "  NO POWER"
            : sample.emergency_stop() ? "  EMERGENCY STOP"
            : sample.tripped()        ? "  DRIVE TRIPPED"
                                      : "";
    return text;
}

std::string out_text(double metres) {
    return fmt::format(" {} {}", cable(metres), in_shackles(metres));
}

std::string seat_text(const Picture& picture, const TacklePicture& tackle) {
    std::string text;
    if (tackle.view) {
        const ForecastleView& view = *tackle.view;
        if (view.counter_fitted()) text += out_text(view.cable_out_indicated());
        text += "  " + cable_speed(cable_speed_told(view));
        if (view.load_cell_fitted())
            text += fmt::format("  load {} {}", load(view.gypsy_load_indicated()), percent(load_used(view)));
        text += levers_text(view, view.lining_temperature_shown() ? celsius(view.lining_temperature())
                                                                  : std::string{words(view.lining())});
        text += fmt::format("  {}", words(view.anchor()));
        if (view.leads()) text += ", " + lead_and_stay(view);
    }
    if (picture.bridge)
        text += fmt::format("  ship {} heading {}",
                            picture.bridge->gps_works() ? knots(picture.bridge->speed_over_ground())
                                                        : std::string{"(no GPS)"},
                            picture.bridge->gyro_works() ? bearing(picture.bridge->heading())
                                                         : std::string{"(no gyro)"});
    return text;
}

std::string truth_text(const Picture& picture, const TacklePicture& tackle) {
    std::string text;
    if (tackle.chain) text += out_text(tackle.chain->cable_out());
    if (tackle.load) {
        const WindlassLoad& one = *tackle.load;
        text += fmt::format("  {}  load {} {}", cable_speed(one.cable_speed()), load(one.hawse_tension()),
                            percent(load_used(one)));
        text += levers_text(one, celsius(one.lining_temperature()));
    }
    if (tackle.anchor) text += fmt::format("  {}", words(tackle.anchor->phase()));
    if (tackle.chain && leads(tackle)) text += ", " + lead_and_stay(*tackle.chain);
    if (picture.ship)
        text += fmt::format("  ship {} heading {}", knots(picture.ship->speed_over_ground()),
                            bearing(picture.ship->heading()));
    return text;
}

std::string in_capitals(std::string_view name) {
    std::string text{name};
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text;
}

/// "port: ", where a text that is of one windlass does not say of which.
std::string whose(std::int32_t of, std::string_view text) {
    const std::string side{side_name(of)};
    const bool of_one = of == SIDE_PORT || of == SIDE_STARBOARD;
    return of_one && text.find(side) == std::string_view::npos ? side + ": " : "";
}

template <class T>
std::string told_of(const T& event) {
    const std::string grade =
        event.severity() == EVENT_INFO ? "" : in_capitals(name(event.severity())) + ": ";
    return grade + whose(event.side(), event.text().c_str()) + event.text().c_str();
}

std::string_view state_words(AlertCondition condition) {
    switch (condition) {
    case ALERT_ACTIVE_UNACKNOWLEDGED:
        return "to be acknowledged";
    case ALERT_ACTIVE_SILENCED:
        return "silenced";
    case ALERT_ACTIVE_ACKNOWLEDGED:
        return "acknowledged";
    case ALERT_RECTIFIED_UNACKNOWLEDGED:
        return "over, to be acknowledged";
    case ALERT_NORMAL:
        return "over";
    }
    return "unknown";
}

} // namespace

std::string line(const Picture& picture, int side, Clock::time_point now, Onlooker who) {
    if (!picture.status) return "no server heard yet";
    std::string text = run_text(*picture.status, picture.time(side));
    if (const double silent = picture.silence(now).value_or(0.0); silent > kStaleAfter)
        text += fmt::format("  NO DATA FOR {:.0f} s", silent);
    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(side));
    text += fmt::format("  {}", side_name(side));
    return text + (who == Onlooker::seat ? seat_text(picture, tackle) : truth_text(picture, tackle));
}

std::string told(const Event& event) {
    return told_of(event);
}
std::string told(const SeatEvent& event) {
    return told_of(event);
}

std::string line(const Event& event) {
    return fmt::format("{} * {}", clock(event.time()), told(event));
}
std::string line(const SeatEvent& event) {
    return fmt::format("{} * {}", clock(event.time()), told(event));
}

std::string line(const BridgeOrder& order) {
    std::string state{name(order.state())};
    std::ranges::replace(state, '_', ' ');
    return fmt::format("{} # order {}: {} ({})", clock(order.time()), order.number(), words(order), state);
}

std::string line(const Alert& alert) {
    return fmt::format("{} {}: {}{} ({}, {})", clock(alert.raised_time()),
                       in_capitals(name(alert.priority())), whose(alert.side(), alert.text().c_str()),
                       alert.text().c_str(), alert.code().c_str(), state_words(alert.condition()));
}

} // namespace windlass::station
