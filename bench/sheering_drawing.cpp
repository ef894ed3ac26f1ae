#include "bench/sheering_drawing.hpp"

#include "bench/lab/draw/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::bench {

namespace {

constexpr double kNames = 150, kPanel = 190, kGap = 26, kLine = 26, kTop = 66, kBottom = 40; // px

/// One quantity along x.
struct Quantity {
    std::string title;
    double end;     ///< of the axis, which begins at 0
    double step;    ///< of its numbers
    double low = 0; ///< what practice has
    double high = 0;
    double (*of)(const rigs::Sheering&);
};

// Practice: docs/ships.md, "At anchor", with the sources.
const std::array kQuantities{
    Quantity{"yaw to either side, deg", 80, 20, 20, 50, [](const auto& s) { return s.yaw; }},
    Quantity{"an eight, min", 40, 10, 5, 15, [](const auto& s) { return s.period / 60; }},
    Quantity{"peak load over its mean", 4, 1, 0, 0, [](const auto& s) { return s.peak / s.mean; }},
    Quantity{"peak over the wind from ahead", 12, 3, 2, 5, [](const auto& s) { return s.peak / s.ahead; }}};

struct Kind {
    double wind;
    bool underfoot;
    bool operator==(const Kind&) const = default;
};

std::vector<Kind> kinds_of(const std::vector<SheeringRow>& rows) {
    std::vector<Kind> kinds;
    for (const SheeringRow& row : rows)
        if (const Kind kind{row.wind, row.underfoot}; std::ranges::find(kinds, kind) == kinds.end())
            kinds.push_back(kind);
    return kinds;
}

std::vector<std::string> ships_of(const std::vector<SheeringRow>& rows) {
    std::vector<std::string> ships;
    for (const SheeringRow& row : rows)
        if (ships.empty() || ships.back() != row.ship.ship) ships.push_back(row.ship.ship);
    return ships;
}

void draw_frame(lab::Svg& svg, const Quantity& quantity, double left, double bottom) {
    const auto at = [&](double value) { return left + kPanel * value / quantity.end; };
    if (quantity.high > 0)
        svg.box({at(quantity.low), kTop}, at(quantity.high) - at(quantity.low), bottom - kTop, "#e8eef3");
    std::vector<std::vector<lab::Point>> grid;
    std::vector<std::pair<lab::Point, std::string>> numbers;
    for (double value = 0; value <= quantity.end; value += quantity.step) {
        grid.push_back({{at(value), kTop}, {at(value), bottom}});
        numbers.emplace_back(lab::Point{at(value), bottom + 15}, fmt::format("{:g}", value));
    }
    svg.curves(grid, {"#ddd", 0.7, ""});
    svg.texts(numbers, {.size = 12, .anchor = "middle"});
    svg.text({left, kTop - 8}, quantity.title, {.size = 12, .bold = true});
}

} // namespace

lab::Svg drawing_of(const std::vector<SheeringRow>& rows) {
    const auto kinds = kinds_of(rows);
    const auto ships = ships_of(rows);
    const double bottom = kTop + kLine * static_cast<double>(ships.size());
    lab::Svg svg(kNames + kQuantities.size() * (kPanel + kGap), bottom + kBottom);
    double legend = kNames;
    for (std::size_t k = 0; k < kinds.size(); ++k, legend += 200) {
        svg.dots({{legend, 16}}, 4, lab::colour_of(static_cast<int>(k)));
        svg.text({legend + 9, 20}, fmt::format("{:g} m/s{}", kinds[k].wind,
                                               kinds[k].underfoot ? ", second anchor underfoot" : ""));
    }
    svg.box({legend, 10}, 14, 12, "#e8eef3");
    svg.text({legend + 20, 20}, "practice, as recalled");
    for (std::size_t k = 0; k < ships.size(); ++k)
        svg.text({kNames - 12, kTop + kLine * (static_cast<double>(k) + 0.5) + 4}, ships[k],
                 {.size = 12, .anchor = "end"});
    double left = kNames;
    for (const Quantity& quantity : kQuantities) {
        draw_frame(svg, quantity, left, bottom);
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            std::vector<lab::Point> dots;
            for (const SheeringRow& row : rows) {
                if (Kind{row.wind, row.underfoot} != kinds[k]) continue;
                const auto line = std::ranges::find(ships, row.ship.ship) - ships.begin();
                const double value = quantity.of(row.found);
                const double y = kTop + kLine * (static_cast<double>(line) + 0.5) +
                                 6 * (static_cast<double>(k) - 0.5 * static_cast<double>(kinds.size() - 1));
                if (!(value > 0)) continue; // less than one eight
                dots.push_back({left + kPanel * std::min(value, quantity.end) / quantity.end, y});
                if (value > quantity.end) // beyond the axis: in figures
                    svg.text({left + kPanel - 8, y + 4}, fmt::format("{:.0f}", value),
                             {.size = 11, .anchor = "end", .colour = lab::colour_of(static_cast<int>(k))});
            }
            svg.dots(dots, 3.5, lab::colour_of(static_cast<int>(k)));
        }
        left += kPanel + kGap;
    }
    return svg;
}

} // namespace windlass::bench
