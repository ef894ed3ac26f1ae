#include "station/screen_layout.hpp"

#include "station/format.hpp"
#include "station/line_view.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace windlass::station {

namespace {

constexpr int kLeverRows = 10;                 // row of the headings; the levers follow below
constexpr int kRight = 42;                     // column where the windlass's own figures start
constexpr int kLoads = 12;                     // column of the loads, which need room
constexpr double kRpm = 30 / std::numbers::pi; // revolutions a minute in one rad/s
constexpr int kLogRow = 19;
constexpr double kWorthTelling = 0.1; // turns in the cable

Style by_share(double fraction, double caution, double alarm) {
    if (fraction >= alarm) return Style::alarm;
    return fraction >= caution ? Style::caution : Style::plain;
}

/// Collects pieces and keeps them inside the window.
class Page {
public:
    Page(int width, int height, bool stale) : width_{width}, height_{height}, stale_{stale} {}

    void put(int row, int column, std::string text, Style style = Style::plain) {
        if (row >= height_ || column >= width_) return;
        text.resize(std::min(text.size(), static_cast<std::size_t>(width_ - column)));
        const bool figure = style != Style::title && style != Style::label;
        pieces_.push_back({row, column, std::move(text), stale_ && figure ? Style::stale : style});
    }

    /// A line over the whole width, with one text at each end.
    void band(int row, const std::string& left, const std::string& right, Style style) {
        const auto width = static_cast<std::size_t>(width_);
        std::string text = left.substr(0, width);
        text.resize(width, ' ');
        const auto tail = std::min(right.size(), width);
        text.replace(width - tail, tail, right, 0, tail);
        pieces_.push_back({row, 0, std::move(text), style});
    }

    /// Label, set point and present value of one lever; coloured while it is still on its way.
    void lever(int row, const std::string& label, const std::string& set, const std::string& now) {
        put(row, 1, label, Style::label);
        put(row, 17, set);
        put(row, 27, now, set != "-" && set != now ? Style::caution : Style::plain);
    }

    void figure(int row, const std::string& label, const std::string& value, Style style = Style::plain) {
        put(row, kRight, label, Style::label);
        put(row, kRight + 10, value, style);
    }

    int width() const { return width_; }
    std::vector<Piece> take() { return std::move(pieces_); }

private:
    int width_, height_;
    bool stale_;
    std::vector<Piece> pieces_;
};

std::string scale_text(double scale) {
    return scale > 0 ? fmt::format("x{:.3g}", scale) : std::string{"x max"};
}

void title(Page& page, const Picture& picture, const ScreenRequest& request, double silent) {
    const ExerciseStatus& status = *picture.status;
    const std::string right = fmt::format(" {}  {} {} ", clock(picture.time(request.side)),
                                          name(status.state()), scale_text(status.time_scale()));
    page.band(0, fmt::format(" {}  {}", request.heading, status.title().c_str()), right, Style::title);
    if (silent > kStaleAfter) {
        page.band(1, fmt::format(" NO DATA FOR {:.0f} s: the figures below are old", silent), "",
                  Style::alarm);
    } else {
        page.put(1, 1,
                 fmt::format("depth {:.1f} m   wind {} from {}   current {} towards {}", status.depth(),
                             knots(status.wind_speed()), bearing(status.wind_from()),
                             knots(status.current_speed()), bearing(status.current_towards())));
    }
}

void anchor_and_cable(Page& page, const TacklePicture& tackle, int side, Onlooker who) {
    const bool truth = who == Onlooker::instructor; // nobody on deck sees the bottom
    page.put(2, 1, std::string{side_name(side)} + " anchor", Style::label);
    if (tackle.anchor) {
        const AnchorState& anchor = *tackle.anchor;
        const bool bad = anchor.phase() == ANCHOR_DRAGGING || anchor.phase() == ANCHOR_LOST;
        page.put(2, 18, anchor_seen(anchor, who), truth && bad ? Style::alarm : Style::good);
    }
    if (tackle.anchor && truth) {
        const AnchorState& anchor = *tackle.anchor;
        page.put(2, kRight,
                 fmt::format("{} m over bottom  dragged {} m", number(anchor.height_above_bottom(), 1),
                             number(anchor.dragged(), 1)));
        page.put(4, kRight,
                 fmt::format("holding {} of {}", tonnes(anchor.holding_used()),
                             tonnes(anchor.holding_capacity())));
        page.put(9, 1, "anchor", Style::label);
        const bool bad = anchor.bent() > 0 || anchor.fouled() > 0;
        page.put(9, kLoads, in_the_ground(anchor), bad ? Style::caution : Style::plain);
    }
    page.put(3, 1, truth ? "cable out" : "chain counter", Style::label);
    if (const auto out = cable_out(tackle, who))
        page.put(3, 18, fmt::format("{:.1f} m   {}", *out, in_shackles(*out)));
    page.put(4, 1, "leads", Style::label);
    page.put(5, 1, "marks", Style::label);
    if (tackle.chain) {
        const ChainState& chain = *tackle.chain;
        if (leads(tackle)) page.put(4, 18, lead_and_stay(chain));
        if (truth) page.put(3, kRight + 15, fmt::format("on the bottom {}", cable(chain.on_bottom())));
        if (truth && std::abs(chain.turns()) >= kWorthTelling)
            page.put(4, kRight, fmt::format("{:.1f} turns in it", chain.turns()), Style::caution);
        const bool last = last_lengths_in_sight(chain);
        const bool stretched = truth && chain.stretched() > 0; // a survey would tell
        page.put(5, kLoads,
                 (stretched ? fmt::format("STRETCHED {} m, ", number(chain.stretched(), 2)) : "") +
                     marks_in_sight(chain) + (last ? ", LAST LENGTHS" : ""),
                 last || stretched ? Style::caution : Style::plain);
    }
    if (!tackle.load) return;
    page.put(3, kRight, cable_speed(tackle.load->cable_speed()), Style::good);
    if (truth)
        page.put(4, kRight + 23, fmt::format("counter {} m", number(tackle.load->cable_out_indicated(), 1)));
}

void loads(Page& page, const WindlassLoad& load, Onlooker who) {
    const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0; };
    const double used = load_used(load, who);
    page.put(6, 1, who == Onlooker::instructor ? "cable load" : "load cell", Style::label);
    page.put(6, kLoads,
             fmt::format("{}  {} of breaking load {}   | brake rating {}",
                         station::load(cable_load(load, who)), percent(used), tonnes(load.breaking_load()),
                         tonnes(load.brake_rating())));
    page.put(7, 1, bar(used, page.width() - 2, share(load.brake_rating(), load.breaking_load())),
             by_share(used, 0.3, 0.45)); // 0.45 of the breaking load is what a brake must hold (UR A3)
    if (who != Onlooker::instructor) {
        page.put(8, 1, "lining", Style::label);
        page.put(8, kLoads, lining_seen(load), by_share(load.lining_temperature() / kSmoking, 0.9, 1));
        return;
    }
    page.put(8, 1, "brake load", Style::label);
    page.put(8, kLoads,
             fmt::format("{}, can hold {} now  stopper {}  motor {}", station::load(load.brake_load()),
                         tonnes(load.brake_capacity()), tonnes(load.stopper_load()),
                         tonnes(load.motor_load())),
             by_share(share(load.brake_load(), load.brake_capacity()), 0.8, 0.999));
}

std::string yes(bool value, const char* if_true, const char* if_false) {
    return value ? if_true : if_false;
}

void windlass_levers(Page& page, const TacklePicture& tackle) {
    const WindlassLoad& load = *tackle.load;
    const bool commanded = bool(tackle.levers);
    const auto set = [commanded](const std::string& text) { return commanded ? text : std::string{"-"}; };
    const WindlassCommand& levers = *tackle.levers;
    int row = kLeverRows;
    page.put(row, 1, "LEVER           SET       NOW", Style::label);
    page.lever(++row, "brake", set(percent(levers.brake())), percent(load.brake_position()));
    page.lever(++row, "speed lever", set(lever(levers.speed_lever())), lever(load.speed_lever()));
    const std::string clutch =
        load.clutch() == CLUTCH_ENGAGING ? "engaging" : std::string{name(load.clutch())};
    page.lever(++row, "clutch", set(yes(levers.clutch_in(), "in", "out")), clutch);
    page.lever(++row, "stopper", set(yes(levers.stopper_closed(), "on", "off")),
               yes(load.stopper_closed(), "on", "off"));
    page.lever(++row, "emergency stop", set(yes(levers.emergency_stop(), "ON", "off")),
               yes(load.emergency_stop(), "ON", "off"));
}

void helm(Page& page, const Picture& picture) {
    const ShipState& ship = *picture.ship;
    const bool commanded = bool(picture.helm);
    const auto set = [commanded](const std::string& text) { return commanded ? text : std::string{"-"}; };
    const HelmCommand& orders = *picture.helm;
    page.lever(16, "engine", set(percent(orders.engine())), percent(ship.engine()));
    page.lever(17, "rudder", set(station::rudder(orders.rudder())), station::rudder(ship.rudder()));
    page.lever(18, "bow thruster", set(percent(orders.bow_thruster())), percent(ship.bow_thruster()));
    page.figure(16, "ship", fmt::format("{}, {}", knots(ship.speed_over_ground()), way(ship.surge())));
    page.figure(17, "heading",
                bearing(ship.heading()) + "   stern thruster " + percent(ship.stern_thruster()));
}

/// What no ship has a gauge for.
void brake_truth(Page& page, int row, const WindlassLoad& load) {
    page.figure(row, "lining",
                celsius(load.lining_temperature()) + "   drum " + celsius(load.drum_temperature()),
                by_share(load.lining_temperature() / kSmoking, 0.9, 1));
    page.figure(row + 1, "brake", megajoules(load.brake_energy()) + "   wear " + percent(load.brake_wear()));
}

void machine(Page& page, const Picture& picture, const WindlassLoad& load, Onlooker who) {
    const bool truth = who == Onlooker::instructor;
    int row = kLeverRows;
    page.put(row, kRight, "WINDLASS", Style::label);
    if (truth) brake_truth(page, row + 1, load);
    row += 2;
    const std::string drive = load.motor_pressure() > 0
                                  ? fmt::format("{:.0f} bar", load.motor_pressure() / 1e5)
                                  : fmt::format("{:.0f} A", load.motor_current());
    page.figure(++row, "motor",
                fmt::format("{}   {} rpm", drive, number(load.motor_speed() * kRpm, 0)) +
                    (truth ? "   " + celsius(load.motor_temperature()) : ""));
    const bool bad = !load.power() || load.tripped() || load.emergency_stop();
    page.figure(++row, "drive",
                !load.power()           ? "NO POWER"
                : load.emergency_stop() ? "EMERGENCY STOP"
                : load.tripped()        ? "TRIPPED: speed lever to zero resets it"
                                        : "ready",
                bad ? Style::alarm : Style::good);
    if (!truth) return; // what the instructor has in store is not told
    std::vector<std::string> faults;
    for (const auto& fault : picture.status->faults())
        if (fault.phase() != FAULT_PHASE_CLEARED)
            faults.push_back(fmt::format("{} {}", name(fault.code()), name(fault.phase())));
    // Their number first: a narrow screen has no room for them all.
    const std::string number_of = faults.size() > 1 ? fmt::format("{}: ", faults.size()) : "";
    page.figure(++row, "faults",
                faults.empty() ? "none" : number_of + fmt::format("{}", fmt::join(faults, ", ")),
                faults.empty() ? Style::plain : Style::caution);
}

void log(Page& page, const Picture& picture, const ScreenRequest& request, const TacklePicture& tackle) {
    const std::string holder = tackle.levers ? tackle.levers->origin().source().to_string() : "nobody";
    page.put(kLogRow - 1, kRight,
             picture.replayed() ? "a replay: levers move nothing" : "levers in the hand of " + holder,
             Style::label);

    struct Line {
        std::string text;
        Style style;
    };
    std::vector<Line> lines;
    for (const Alert& alert : picture.alerts)
        lines.push_back({fmt::format("{} {}: {}", clock(alert.raised_time()), name(alert.priority()),
                                     alert.text().c_str()),
                         alert.priority() >= ALERT_ALARM ? Style::alarm : Style::caution});
    const auto rows = static_cast<std::size_t>(std::max(request.height - kLogRow - 1, 1));
    std::vector<Line> newest;
    for (auto text = request.log.rbegin(); text != request.log.rend() && newest.size() < 2; ++text)
        newest.push_back({*text, Style::label});
    for (auto event = picture.events.rbegin(); event != picture.events.rend() && newest.size() < rows;
         ++event) {
        if (!noticed(*event, picture, request.who)) continue;
        newest.push_back({line(*event), event->severity() >= EVENT_WARNING   ? Style::alarm
                                        : event->severity() == EVENT_CAUTION ? Style::caution
                                                                             : Style::plain});
    }
    // Alerts stand first and stay; what is left of the window is for the newest events.
    lines.resize(std::min(lines.size(), rows > 1 ? rows - 1 : 1));
    const auto room = rows - lines.size();
    if (newest.size() > room) newest.resize(room);
    lines.insert(lines.end(), newest.rbegin(), newest.rend());
    for (std::size_t i = 0; i < lines.size(); ++i)
        page.put(kLogRow + static_cast<int>(i), 1, lines[i].text, lines[i].style);
}

} // namespace

std::vector<Piece> layout(const Picture& picture, const ScreenRequest& request, Clock::time_point now) {
    const double silent = picture.silence(now).value_or(0);
    Page page{request.width, request.height, silent > kStaleAfter};
    if (request.width < kMinWidth || request.height < kMinHeight) {
        page.put(0, 0,
                 fmt::format("window {}x{}: at least {}x{} is needed", request.width, request.height,
                             kMinWidth, kMinHeight));
        return page.take();
    }
    page.band(request.height - 1, request.keys, "", Style::title);
    if (!picture.status) {
        page.band(0, fmt::format(" {}", request.heading), "no server heard yet ", Style::title);
        return page.take();
    }
    const auto& tackle = picture.tackle.at(static_cast<std::size_t>(request.side));
    title(page, picture, request, silent);
    anchor_and_cable(page, tackle, request.side, request.who);
    if (tackle.load) {
        loads(page, *tackle.load, request.who);
        windlass_levers(page, tackle);
        machine(page, picture, *tackle.load, request.who);
    } else {
        page.put(6, 1, fmt::format("nothing heard of a {} windlass", side_name(request.side)),
                 Style::caution);
    }
    if (picture.ship) helm(page, picture);
    log(page, picture, request, tackle);
    return page.take();
}

} // namespace windlass::station
