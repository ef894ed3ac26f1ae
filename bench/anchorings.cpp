#include "bench/anchorings.hpp"

#include "server/config/config.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace windlass::bench {

namespace {

constexpr std::array kOutfits{
    Outfit{"general_cargo_118m", "electric_46mm", "stud_link_46mm_k3", "stockless_3540"},
    Outfit{"bulk_carrier_225m", "electric_78mm", "stud_link_78mm_k3", "stockless_9900"},
    Outfit{"panamax_ballast", "electric_78mm", "stud_link_78mm_k3", "stockless_9900"},
    Outfit{"panamax_laden", "electric_78mm", "stud_link_78mm_k3", "ac14_7425"},
    Outfit{"container_ship_300m", "electric_95mm", "stud_link_95mm_k3", "stockless_14700"},
    Outfit{"capesize_ballast", "electric_100mm", "stud_link_100mm_k3", "stockless_16900"},
};
constexpr std::array kSoils{"sand", "mud", "clay", "gravel"};

constexpr double kShallowest = 18, kDeepest = 60, kDeepestLetGo = 45; // m

} // namespace

DrawnAnchoring drawn_anchoring(std::uint64_t seed, std::uint64_t number) {
    std::mt19937_64 draw(1'000'003 * seed + number);
    draw.discard(20); // neighbouring seeds begin alike
    const auto uniform = [&](double min, double max) {
        return min + (max - min) * static_cast<double>(draw() >> 11) * 0x1p-53;
    };
    const auto one_of = [&](const auto& all) {
        return all[static_cast<std::size_t>(uniform(0, static_cast<double>(all.size())))];
    };
    DrawnAnchoring c;
    c.outfit = one_of(kOutfits);
    c.soil = one_of(kSoils);
    c.depth = uniform(kShallowest, kDeepest);
    c.sternway = uniform(0.2, 0.8);
    c.wind = uniform(4, 10);
    const double scope = uniform(4, 7);
    c.shackles = std::clamp(static_cast<int>(std::lround(scope * c.depth / physics::kShackleLength)), 4, 9);
    const double swell = uniform(-3, 2);
    c.swell = swell > 0 ? 0.5 + swell : 0;
    c.wind_off = uniform(-25, 25);
    c.walked_back = c.depth > kDeepestLetGo;
    return c;
}

std::string title(const DrawnAnchoring& c) {
    std::string title = fmt::format("{}, {:.1f} m {}, {} shackles, {:.2f} m/s astern", c.outfit.ship, c.depth,
                                    c.soil, c.shackles, c.sternway);
    if (c.walked_back) title += ", walked back";
    if (c.swell > 0) title += fmt::format(", swell {:.1f} m", c.swell);
    return title;
}

exercise::ExerciseDef definition(const DrawnAnchoring& c) {
    const std::string text = fmt::format(
        R"({{"from": "let_go_port_25m", "name": "drawn", "title": "{}",
             "environment": {{"depth": {}, "soil": "{}", "wind_speed": {}, "wind_from_deg": {},
                             "swell_height": {}, "swell_period": 10}},
             "ship": {{"from": "{}"}}, "ship_start": {{"surge": {}}},
             "tackle": [{{"side": "port", "windlass": {{"from": "{}"}}, "chain": {{"from": "{}"}},
                          "anchor": {{"from": "{}"}}, "cable_out": 5, "brake": 1, "clutch_in": {},
                          "stopper_closed": false}}]}})",
        title(c), c.depth, c.soil, c.wind, c.wind_off, c.swell, c.outfit.ship, -c.sternway, c.outfit.windlass,
        c.outfit.chain, c.outfit.anchor, c.walked_back);
    return config::parse_exercise(text, "drawn", WINDLASS_CONFIG_DIR);
}

} // namespace windlass::bench
