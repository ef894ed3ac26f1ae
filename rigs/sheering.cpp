#include "rigs/sheering.hpp"

#include "rigs/drill.hpp"
#include "server/config/config.hpp"
#include "server/physics/ship/wind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace windlass::rigs {

namespace {

exercise::ExerciseDef definition(const AnchoredShip& ship, bool underfoot) {
    const std::string parts =
        fmt::format(R"("windlass": {{"from": "{}"}}, "chain": {{"from": "{}"}}, "anchor": {{"from": "{}"}})",
                    ship.windlass, ship.chain, ship.anchor);
    const std::string second =
        underfoot ? fmt::format(R"(, {{"side": "starboard", "cable_out": 5, {}}})", parts) : "";
    return config::parse_exercise(
        fmt::format(R"({{"environment": {{"depth": {}, "wind_speed": 8, "current_speed": 0}},
            "ship": {{"from": "{}"}}, "ship_start": {{"surge": -0.4, "heading_deg": 5}},
            "tackle": [{{"side": "port", "cable_out": 5, {}}}{}]}})",
                    ship.depth, ship.ship, parts, second),
        ship.ship, WINDLASS_CONFIG_DIR);
}

/// Cable as she falls back from where the anchor fell, no more.
void let_go(Drill& drill, const AnchoredShip& ship) {
    drill.grip(0);
    if (!drill.run_until_event("anchor.on_bottom", 120))
        throw std::runtime_error(ship.ship + ": the anchor does not come to the bottom");
    const physics::Vec3 landed = drill.anchor().position;
    for (int k = 0; k < 2400 && drill.chain().cable_out < ship.cable; ++k) {
        const physics::Vec3 lip = drill.now().tackle[0].hawse;
        const double back = std::hypot(lip.x() - landed.x(), lip.y() - landed.y());
        drill.grip(drill.chain().cable_out < lip.z() + ship.depth + 5 + back ? 0 : 0.3);
        drill.run(0.5);
    }
    drill.brake(1);
}

/// Lets time go by without a look at every tick, which would cost as much as the ticks.
void pass(Drill& drill, double seconds) {
    const int rate = drill.exercise().def().tick_rate_hz;
    for (long k = std::lround(seconds * rate); k > 1; --k)
        drill.exercise().step(1.0 / rate);
    drill.tick();
}

void let_go_underfoot(Drill& drill, const AnchoredShip& ship) {
    const physics::WindlassDef& windlass = drill.exercise().def().tackle[1].windlass;
    const auto grip = [&](double share) {
        drill.give(exercise::WindlassOrder{.side = exercise::Side::starboard,
                                           .brake = physics::position_of_grip(windlass, share)});
    };
    const double out = 1.5 * ship.depth + drill.now().tackle[1].hawse.z();
    grip(0);
    const bool there = drill.run_until(
        [&] {
            const bool running = drill.now().tackle[1].windlass.cable_speed > 3; // m/s: checked, as by hand
            grip(running ? 0.5 : 0);
            return drill.now().tackle[1].chain.cable_out > out;
        },
        300);
    grip(1);
    if (!there) throw std::runtime_error(ship.ship + ": the second cable does not run out");
}

} // namespace

std::span<const AnchoredShip> anchored_ships() {
    static const std::array kShips{
        AnchoredShip{"general_cargo_118m", "electric_46mm", "stud_link_46mm_k3", "stockless_3540"},
        AnchoredShip{"panamax_laden", "electric_78mm", "stud_link_78mm_k3", "stockless_9900"},
        AnchoredShip{"panamax_ballast", "electric_78mm", "stud_link_78mm_k3", "stockless_9900"},
        AnchoredShip{"capesize_laden", "electric_100mm", "stud_link_100mm_k3", "stockless_16900", 40, 270},
        AnchoredShip{"capesize_ballast", "electric_100mm", "stud_link_100mm_k3", "stockless_16900", 40, 270},
        AnchoredShip{"vlcc_laden", "electric_117mm", "stud_link_117mm_k3", "stockless_23000", 40, 270},
        AnchoredShip{"vlcc_ballast", "electric_117mm", "stud_link_117mm_k3", "stockless_23000", 40, 270},
        AnchoredShip{"car_carrier_200m", "electric_78mm", "stud_link_78mm_k3", "stockless_10500"},
        AnchoredShip{"container_ship_300m", "electric_95mm", "stud_link_95mm_k3", "stockless_14700"}};
    return kShips;
}

const AnchoredShip& anchored_ship(const std::string& name) {
    const auto found = std::ranges::find(anchored_ships(), name, &AnchoredShip::ship);
    if (found == anchored_ships().end()) throw std::out_of_range("no such ship at anchor: " + name);
    return *found;
}

exercise::Weather steady_wind(double speed) {
    exercise::Weather weather;
    weather.wind_speed = speed;
    weather.current_speed = 0;
    return weather;
}

Sheering sheer(const AnchoredShip& ship, const exercise::Weather& weather, bool underfoot, int minutes,
               double freshens) {
    Drill drill(definition(ship, underfoot));
    let_go(drill, ship);
    if (underfoot) {
        pass(drill, 600); // she comes to lie
        let_go_underfoot(drill, ship);
    }
    drill.give(exercise::EnvironmentOrder{.weather = weather, .ramp = freshens});
    pass(drill, 1800);
    Sheering s;
    s.ahead = std::abs(physics::wind_force(drill.exercise().def().ship, weather.wind_speed, 0).x);
    double to_port = 0, to_starboard = 0; // deg
    const double dragged = drill.anchor().dragged;
    double first = 0, last = 0;
    const int looks = 60 * minutes; // a second apart
    int crossings = -1, side = 0;
    for (int look = 0; look < looks; ++look) {
        pass(drill, 1);
        double load = 0;
        for (const exercise::TackleView& tackle : drill.now().tackle)
            load += tackle.windlass.hawse_tension;
        s.mean += load / looks;
        s.peak = std::max(s.peak, load);
        const double off =
            std::remainder(drill.now().ship.heading, 2 * std::numbers::pi) * 180 / std::numbers::pi;
        to_port = std::min(to_port, off), to_starboard = std::max(to_starboard, off);
        constexpr double kFar = 3; // deg, that count as a side
        const int now = off > kFar ? 1 : off < -kFar ? -1 : side;
        if (now == side) continue;
        if (side != 0) {
            if (++crossings == 0) first = look;
            last = look;
        }
        side = now;
    }
    s.yaw = std::max(-to_port, to_starboard);
    s.sweep = to_starboard - to_port;
    s.period = crossings > 0 ? 2 * (last - first) / crossings : 0;
    s.dragged = drill.anchor().dragged - dragged;
    return s;
}

} // namespace windlass::rigs
