#include "station/summary.hpp"

#include "station/format.hpp"
#include "station/names.hpp"
#include "station/seen.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace windlass::station {

namespace {

/// "10 % of the breaking load 4505 kN (459 t)"; nothing where that load is not known.
std::string share(double part, double whole, std::string_view of) {
    return whole > 0 ? fmt::format(", {} of the {} {}", percent(part / whole), of, load(whole)) : "";
}

std::string heading(int side, double time) {
    return fmt::format("Summary, {} windlass, exercise time {}\n", side_name(side), clock(time));
}

struct Rows {
    std::string& text;
    void operator()(std::string_view label, std::string_view value) const {
        text += fmt::format("  {:<22} {}\n", label, value);
    }
};

} // namespace

Summary summarise(const Picture& picture, int side) {
    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(side));
    Summary summary{.side = side,
                    .largest_load = tackle.extremes.hawse_tension,
                    .largest_load_time = tackle.extremes.hawse_tension_time,
                    .largest_brake_load = tackle.extremes.brake_load,
                    .largest_pay_out_speed = tackle.extremes.pay_out_speed,
                    .peak_lining_temperature = tackle.extremes.lining_temperature};
    summary.time = picture.time(side);
    if (tackle.anchor) summary.anchor = tackle.anchor->phase();
    if (tackle.chain) {
        summary.cable_out = tackle.chain->cable_out();
        summary.cable_out_shackles = tackle.chain->cable_out_shackles();
        summary.stretched = tackle.chain->stretched();
        summary.stretch = tackle.chain->stretch();
    }
    if (tackle.load) {
        summary.breaking_load = tackle.load->breaking_load();
        summary.brake_rating = tackle.load->brake_rating();
        summary.brake_energy = tackle.load->brake_energy();
    }
    return summary;
}

SeatSummary summarise_seat(const Picture& picture, int side) {
    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(side));
    return {.side = side, .time = picture.time(side), .view = *tackle.view, .seen = tackle.seen};
}

std::string to_text(const Summary& summary) {
    std::string text = heading(summary.side, summary.time);
    const Rows row{text};
    row("anchor", words(summary.anchor));
    row("cable out", fmt::format("{:.1f} m, {}", summary.cable_out, shackles(summary.cable_out_shackles)));
    row("largest load, hawse",
        fmt::format("{} at {}{}", load(summary.largest_load), clock(summary.largest_load_time),
                    share(summary.largest_load, summary.breaking_load, "breaking load")));
    if (summary.stretched > 0)
        row("stretched for good", fmt::format("{:.2f} m, a link by {:.1f} % at most: to be surveyed",
                                              summary.stretched, 100 * summary.stretch));
    row("largest brake load", load(summary.largest_brake_load) +
                                  share(summary.largest_brake_load, summary.brake_rating, "brake rating"));
    row("largest pay-out speed", fmt::format("{:.2f} m/s", summary.largest_pay_out_speed));
    row("brake heat", fmt::format("{}, lining at most {}", megajoules(summary.brake_energy),
                                  celsius(summary.peak_lining_temperature)));
    return text;
}

std::string to_text(const SeatSummary& summary) {
    const ForecastleView& view = summary.view;
    std::string text = heading(summary.side, summary.time);
    const Rows row{text};
    row("anchor", words(view.anchor()));
    if (view.counter_fitted())
        row("cable by the counter",
            fmt::format("{:.1f} m, {}", view.cable_out_indicated(), in_shackles(view.cable_out_indicated())));
    if (view.load_cell_fitted())
        row("largest load, cell",
            fmt::format("{} at {}{}", load(summary.seen.load), clock(summary.seen.load_time),
                        share(summary.seen.load, view.breaking_load(), "breaking load")));
    row("largest pay-out speed", fmt::format("{:.2f} m/s", summary.seen.pay_out_speed));
    row("lining at its hottest", words(summary.seen.lining));
    return text;
}

nlohmann::json to_json(const SeatSummary& summary) {
    return {{"side", side_name(summary.side)},
            {"time", summary.time},
            {"anchor", name(summary.view.anchor())},
            {"cable_out_indicated", summary.view.cable_out_indicated()},
            {"largest_load_indicated", summary.seen.load},
            {"largest_load_time", summary.seen.load_time},
            {"breaking_load", summary.view.breaking_load()},
            {"brake_rating", summary.view.brake_rating()},
            {"largest_pay_out_speed_seen", summary.seen.pay_out_speed},
            {"lining", name(summary.seen.lining)}};
}

nlohmann::json to_json(const Summary& summary) {
    return {{"side", side_name(summary.side)},
            {"time", summary.time},
            {"anchor_phase", name(summary.anchor)},
            {"cable_out", summary.cable_out},
            {"cable_out_shackles", summary.cable_out_shackles},
            {"largest_load", summary.largest_load},
            {"largest_load_time", summary.largest_load_time},
            {"breaking_load", summary.breaking_load},
            {"largest_brake_load", summary.largest_brake_load},
            {"brake_rating", summary.brake_rating},
            {"largest_pay_out_speed", summary.largest_pay_out_speed},
            {"brake_energy", summary.brake_energy},
            {"peak_lining_temperature", summary.peak_lining_temperature},
            {"stretched", summary.stretched},
            {"stretch", summary.stretch}};
}

} // namespace windlass::station
