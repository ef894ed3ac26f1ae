#include "station/format.hpp"
#include "station/names.hpp"
#include "station/screen_page.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace windlass::station {

namespace {

double share(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

/// "45 deg to starboard", "from ahead".
std::string off_the_bow(double angle) {
    const double degrees = angle / words::units::degree;
    const double turned = degrees > 180 ? degrees - 360 : degrees;
    if (turned == 0) return "from ahead";
    return fmt::format("{:.0f} deg to {}", std::abs(turned), turned > 0 ? "starboard" : "port");
}

/// What the bridge's instruments show; on a forecastle without them, what flag and face tell.
void surroundings(Page& page, const Picture& picture, const TacklePicture& tackle) {
    std::string text;
    if (picture.bridge) {
        const BridgeView& bridge = *picture.bridge;
        text = bridge.echo_sounder_works() ? fmt::format("under keel {:.1f} m", bridge.depth_below_keel())
                                           : "no echo sounder";
        text += bridge.anemometer_works() ? fmt::format("   wind {} {}", knots(bridge.wind_speed_apparent()),
                                                        off_the_bow(bridge.wind_from_apparent()))
                                          : "   no anemometer";
        text += fmt::format("   sight {:.1f} nm", bridge.visibility() / words::units::nautical_mile);
        text += "   " + clock(bridge.time_of_day());
    } else if (tackle.view) {
        text = fmt::format("wind force {} {}", tackle.view->wind_felt(),
                           off_the_bow(tackle.view->wind_from_bow()));
    }
    page.put(1, 1, text);
}

void anchor_and_cable(Page& page, const ForecastleView& view) {
    page.put(2, 18, words(view.anchor()), view.anchor() == ANCHOR_SEEN_FOUL ? Style::caution : Style::good);
    if (view.mud() > 0) page.put(2, kRight, fmt::format("mud on it: {}", percent(view.mud())));
    page.put(3, 1, "chain counter", Style::label);
    page.put(3, 18,
             view.counter_fitted() ? fmt::format("{:.1f} m   {}", view.cable_out_indicated(),
                                                 in_shackles(view.cable_out_indicated()))
                                   : "none fitted");
    page.put(3, kRight, cable_speed(cable_speed_told(view)), Style::good);
    page.put(4, 1, "leads", Style::label);
    if (view.leads()) page.put(4, 18, lead_and_stay(view));
    if (view.gypsy_jumping()) page.put(4, kRight, "LINKS JUMP ON THE GYPSY", Style::alarm);
    page.put(5, 1, "marks", Style::label);
    const bool last = last_lengths_in_sight(view.marks());
    page.put(5, kLoads, marks_in_sight(view.marks()) + (last ? ", LAST LENGTHS" : ""),
             last ? Style::caution : Style::plain);
}

void load_and_lining(Page& page, const ForecastleView& view) {
    page.put(6, 1, "load cell", Style::label);
    if (view.load_cell_fitted()) {
        const double used = load_used(view);
        page.put(6, kLoads,
                 fmt::format("{}  {} of breaking load {}   | brake rating {}",
                             load(view.gypsy_load_indicated()), percent(used), tonnes(view.breaking_load()),
                             tonnes(view.brake_rating())));
        page.put(7, 1, bar(used, page.width() - 2, share(view.brake_rating(), view.breaking_load())),
                 by_share(used, 0.3, 0.45)); // 0.45 of the breaking load is what a brake must hold (UR A3)
    } else {
        page.put(6, kLoads,
                 fmt::format("none fitted   breaking load {}   brake rating {}", tonnes(view.breaking_load()),
                             tonnes(view.brake_rating())));
    }
    page.put(8, 1, "lining", Style::label);
    const std::string thermometer =
        view.lining_temperature_shown() ? "   " + celsius(view.lining_temperature()) : "";
    page.put(8, kLoads, words(view.lining()) + thermometer,
             view.lining() >= LINING_SMOKES   ? Style::alarm
             : view.lining() == LINING_SMELLS ? Style::caution
                                              : Style::plain);
}

void machine(Page& page, const ForecastleView& view) {
    int row = kLeverRows;
    page.put(row, kRight, "WINDLASS", Style::label);
    const std::string drive = view.motor_pressure() > 0
                                  ? fmt::format("{:.0f} bar", view.motor_pressure() / 1e5)
                                  : fmt::format("{:.0f} A", view.motor_current());
    page.figure(++row, "motor", fmt::format("{}   runs at {}", drive, percent(view.motor_speed_heard())));
    drive_lamps(page, ++row, view);
    constexpr std::array kNoises{"", "rubs", "squeals", "SCREAMS"};
    constexpr std::array kVibrations{"", "trembles", "shakes", "JERKS"};
    const auto step = [](const auto& names, std::int32_t value) -> const char* {
        return value >= 0 && static_cast<std::size_t>(value) < names.size()
                   ? names[static_cast<std::size_t>(value)]
                   : "";
    };
    if (const std::string noise = step(kNoises, view.brake_noise()); !noise.empty())
        page.figure(++row, "brake", noise, view.brake_noise() >= 3 ? Style::alarm : Style::caution);
    if (const std::string shakes = step(kVibrations, view.vibration()); !shakes.empty())
        page.figure(++row, "deck", shakes, Style::caution);
    if (view.stopper_sprung()) page.figure(++row, "stopper", "ITS BAR HAS SPRUNG OPEN", Style::alarm);
    if (view.motor_burst()) page.figure(++row, "motor", "BURST", Style::alarm);
}

void ship(Page& page, const BridgeView& bridge) {
    // Room for 28 columns; the log says astern by its sign.
    page.figure(16, "ship",
                (bridge.gps_works() ? "GPS " + knots(bridge.speed_over_ground()) : "no GPS") + ", " +
                    (bridge.log_works() ? "log " + knots(bridge.speed_through_water()) : "no log"));
    page.figure(17, "heading",
                (bridge.gyro_works() ? bearing(bridge.heading()) : std::string{"no gyro"}) +
                    "   stern thruster " + percent(bridge.stern_thruster()));
}

} // namespace

void seat_figures(Page& page, const Picture& picture, int side) {
    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(side));
    surroundings(page, picture, tackle);
    page.put(2, 1, std::string{side_name(side)} + " anchor", Style::label);
    if (tackle.view) {
        anchor_and_cable(page, *tackle.view);
        load_and_lining(page, *tackle.view);
        windlass_levers(page, tackle.levers_in_force(), *tackle.view);
        machine(page, *tackle.view);
    } else {
        page.put(6, 1, fmt::format("nothing seen of a {} windlass", side_name(side)), Style::caution);
    }
    if (picture.bridge) {
        helm_levers(page, picture.helm_in_force(), *picture.bridge);
        ship(page, *picture.bridge);
    } else if (tackle.view) {
        page.figure(17, "heading", bearing(tackle.view->ship_heading()));
    }
}

} // namespace windlass::station
