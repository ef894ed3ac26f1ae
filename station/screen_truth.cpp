#include "station/format.hpp"
#include "station/names.hpp"
#include "station/screen_page.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace windlass::station {

namespace {

constexpr double kRpm = 30 / std::numbers::pi; // revolutions a minute in one rad/s
constexpr double kSmoking = 523.15;            // K, from which a lining smokes: it begins to fade (practice)
constexpr double kWorthTelling = 0.1;          // turns in the cable

double share_of(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

void weather(Page& page, const Picture& picture) {
    std::string text;
    if (picture.truth) text = fmt::format("depth {:.1f} m", picture.truth->depth());
    if (picture.environment) {
        const Weather& now = picture.environment->now();
        text +=
            fmt::format("   wind {} from {}   current {} towards {}", knots(now.wind_speed()),
                        bearing(now.wind_from()), knots(now.current_speed()), bearing(now.current_towards()));
    }
    page.put(1, 1, text);
}

void anchor_and_cable(Page& page, const TacklePicture& tackle, int side) {
    page.put(2, 1, std::string{side_name(side)} + " anchor", Style::label);
    if (tackle.anchor) {
        const AnchorState& anchor = *tackle.anchor;
        const bool bad = anchor.phase() == ANCHOR_DRAGGING || anchor.phase() == ANCHOR_LOST;
        page.put(2, 18, words(anchor.phase()), bad ? Style::alarm : Style::good);
        page.put(2, kRight,
                 fmt::format("{} m over bottom  dragged {} m", number(anchor.height_above_bottom(), 1),
                             number(anchor.dragged(), 1)));
        page.put(4, kRight,
                 fmt::format("holding {} of {}", tonnes(anchor.holding_used()),
                             tonnes(anchor.holding_capacity())));
        page.put(9, 1, "anchor", Style::label);
        page.put(9, kLoads, in_the_ground(anchor),
                 anchor.bent() > 0 || anchor.fouled() > 0 ? Style::caution : Style::plain);
    }
    page.put(3, 1, "cable out", Style::label);
    page.put(4, 1, "leads", Style::label);
    page.put(5, 1, "marks", Style::label);
    if (tackle.chain) {
        const ChainState& chain = *tackle.chain;
        page.put(3, 18, fmt::format("{:.1f} m   {}", chain.cable_out(), in_shackles(chain.cable_out())));
        if (leads(tackle)) page.put(4, 18, lead_and_stay(chain));
        page.put(3, kRight + 15, fmt::format("on the bottom {}", cable(chain.on_bottom())));
        if (std::abs(chain.turns()) >= kWorthTelling)
            page.put(4, kRight, fmt::format("{:.1f} turns in it", chain.turns()), Style::caution);
        const bool last = last_lengths_in_sight(chain.marks());
        const bool stretched = chain.stretched() > 0;
        page.put(5, kLoads,
                 (stretched ? fmt::format("STRETCHED {} m, ", number(chain.stretched(), 2)) : "") +
                     marks_in_sight(chain.marks()) + (last ? ", LAST LENGTHS" : ""),
                 last || stretched ? Style::caution : Style::plain);
    }
    if (!tackle.load) return;
    page.put(3, kRight, cable_speed(tackle.load->cable_speed()), Style::good);
    page.put(4, kRight + 23, fmt::format("counter {} m", number(tackle.load->cable_out_indicated(), 1)));
}

void loads(Page& page, const WindlassLoad& load) {
    const double used = load_used(load);
    page.put(6, 1, "cable load", Style::label);
    page.put(6, kLoads,
             fmt::format("{}  {} of breaking load {}   | brake rating {}",
                         station::load(load.hawse_tension()), percent(used), tonnes(load.breaking_load()),
                         tonnes(load.brake_rating())));
    page.put(7, 1, bar(used, page.width() - 2, share_of(load.brake_rating(), load.breaking_load())),
             by_share(used, 0.3, 0.45)); // 0.45 of the breaking load is what a brake must hold (UR A3)
    page.put(8, 1, "brake load", Style::label);
    page.put(8, kLoads,
             fmt::format("{}, can hold {} now  stopper {}  motor {}", station::load(load.brake_load()),
                         tonnes(load.brake_capacity()), tonnes(load.stopper_load()),
                         tonnes(load.motor_load())),
             by_share(share_of(load.brake_load(), load.brake_capacity()), 0.8, 0.999));
}

void machine(Page& page, const Picture& picture, const WindlassLoad& load) {
    int row = kLeverRows;
    page.put(row, kRight, "WINDLASS", Style::label);
    page.figure(++row, "lining",
                celsius(load.lining_temperature()) + "   drum " + celsius(load.drum_temperature()),
                by_share(load.lining_temperature() / kSmoking, 0.9, 1));
    page.figure(++row, "brake", megajoules(load.brake_energy()) + "   wear " + percent(load.brake_wear()));
    const std::string drive = load.motor_pressure() > 0
                                  ? fmt::format("{:.0f} bar", load.motor_pressure() / 1e5)
                                  : fmt::format("{:.0f} A", load.motor_current());
    page.figure(++row, "motor",
                fmt::format("{}   {} rpm   {}", drive, number(load.motor_speed() * kRpm, 0),
                            celsius(load.motor_temperature())));
    drive_lamps(page, ++row, load);
    if (!picture.truth) return;
    std::vector<std::string> faults;
    for (const auto& fault : picture.truth->faults())
        if (fault.phase() != FAULT_PHASE_CLEARED)
            faults.push_back(fmt::format("{} {}", name(fault.code()), name(fault.phase())));
    // Their number first: a narrow screen has no room for them all.
    const std::string number_of = faults.size() > 1 ? fmt::format("{}: ", faults.size()) : "";
    page.figure(++row, "faults",
                faults.empty() ? "none" : number_of + fmt::format("{}", fmt::join(faults, ", ")),
                faults.empty() ? Style::plain : Style::caution);
}

} // namespace

void truth_figures(Page& page, const Picture& picture, int side) {
    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(side));
    weather(page, picture);
    anchor_and_cable(page, tackle, side);
    if (tackle.load) {
        loads(page, *tackle.load);
        windlass_levers(page, tackle.levers_in_force(), *tackle.load);
        machine(page, picture, *tackle.load);
    } else {
        page.put(6, 1, fmt::format("nothing heard of a {} windlass", side_name(side)), Style::caution);
    }
    if (!picture.ship) return;
    const ShipState& ship = *picture.ship;
    helm_levers(page, picture.helm_in_force(), ship);
    page.figure(16, "ship", fmt::format("{}, {}", knots(ship.speed_over_ground()), way(ship.surge())));
    page.figure(17, "heading",
                bearing(ship.heading()) + "   stern thruster " + percent(ship.stern_thruster()));
}

} // namespace windlass::station
