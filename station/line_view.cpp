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

std::string load_text(const WindlassLoad& load, Onlooker who) {
    std::string text = fmt::format("  {}  load {} {}", cable_speed(load.cable_speed()),
                                   station::load(cable_load(load, who)), percent(load_used(load, who)));
    text += fmt::format("  brake {} {}", percent(load.brake_position()),
                        who == Onlooker::instructor ? celsius(load.lining_temperature()) : lining_seen(load));
    text += fmt::format("  clutch {}", name(load.clutch()));
    if (load.stopper_closed()) text += "  stopper on";
    text += !load.power()           ? "  NO POWER"
            : load.emergency_stop() ? "  EMERGENCY STOP"
            : load.tripped()        ? "  DRIVE TRIPPED"
                                    : "";
    return text;
}

/// "port: ", where an event is of one windlass and its text does not say of which.
std::string whose(const Event& event) {
    const std::string side{side_name(event.side())};
    const bool of_one = event.side() == SIDE_PORT || event.side() == SIDE_STARBOARD;
    const bool tells = std::string_view{event.text().c_str()}.find(side) != std::string_view::npos;
    return of_one && !tells ? side + ": " : "";
}

} // namespace

std::string line(const Picture& picture, int side, Clock::time_point now, Onlooker who) {
    if (!picture.status) return "no server heard yet";
    std::string text = run_text(*picture.status, picture.time(side));
    if (const double silent = picture.silence(now).value_or(0); silent > kStaleAfter)
        text += fmt::format("  NO DATA FOR {:.0f} s", silent);

    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(side));
    text += fmt::format("  {}", side_name(side));
    if (const auto out = cable_out(tackle, who))
        text += fmt::format(" {} {}", cable(*out), in_shackles(*out));
    if (tackle.load) text += load_text(*tackle.load, who);
    if (tackle.anchor) text += fmt::format("  {}", anchor_seen(*tackle.anchor, who));
    if (tackle.chain && leads(tackle)) text += ", " + lead_and_stay(*tackle.chain);
    if (picture.ship)
        text += fmt::format("  ship {} heading {}", knots(picture.ship->speed_over_ground()),
                            bearing(picture.ship->heading()));
    return text;
}

std::string told(const Event& event) {
    std::string grade;
    if (event.severity() != EVENT_INFO) {
        grade = std::string{name(event.severity())} + ": ";
        std::ranges::transform(grade, grade.begin(), [](unsigned char c) { return std::toupper(c); });
    }
    return grade + whose(event) + event.text().c_str();
}

std::string line(const Event& event) {
    return fmt::format("{} * {}", clock(event.time()), told(event));
}

} // namespace windlass::station
