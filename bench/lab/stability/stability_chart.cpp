// Stability maps as drawings.

#include "bench/lab/draw/svg.hpp"
#include "bench/lab/stability/stability_suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::lab {
namespace {

/// How a fate looks: told by its letter as well as by its colour.
struct Look {
    const char *fill, *letter, *ink, *words;
};
constexpr std::array kLooks{
    Look{"#d9ebe0", "", "#222", "bounded"},
    Look{"#f2b84b", "E", "#222", "energy grew by more than 10 % of that at play"},
    Look{"#d55e00", "S", "#fff", "a link stretched beyond reason"},
    Look{"#1c1c1c", "N", "#fff", "not a number"},
    Look{"#7b3fa0", "U", "#fff", "a step not solved"},
    Look{"#c3ccd4", "t", "#222", "would take too long"},
    Look{"#ffffff", "–", "#777", "cannot do the case"},
};
static_assert(kLooks.size() == kFateNames.size());

constexpr double kCell = 26, kHigh = 17, kHead = 54, kTitle = 20, kGap = 16;
constexpr std::size_t kColumns = 4;

/// The legend, in lines that fit into some width.
void draw_legend(Svg& svg, double y, double width) {
    double x = 14;
    for (const Look& look : kLooks) {
        const double takes = 20 + 6.1 * double(std::string_view(look.words).size()) + 14;
        if (x + takes > width) x = 14, y += 20;
        svg.box({x, y - 11}, 15, 14, "#888");
        svg.box({x + 0.6, y - 10.4}, 13.8, 12.8, look.fill);
        svg.text({x + 7.5, y}, look.letter,
                 {.size = 10, .anchor = "middle", .colour = look.ink, .bold = true});
        svg.text({x + 20, y}, look.words, {.size = 11});
        x += takes;
    }
}

} // namespace

void draw_stability(const StabilitySuite& suite, const StabilityMap& map,
                    const std::vector<StabilityRow>& rows, const std::filesystem::path& file) {
    std::size_t longest = 0;
    for (const StabilityLine& line : map.lines)
        longest = std::max(longest, line.value.size());
    const double left = 30 + 6 * double(longest), wide = kCell * double(suite.rates.size()),
                 high = kHigh * double(map.lines.size()), pitch_x = wide + kGap,
                 pitch_y = high + kTitle + kGap;
    const std::size_t down = (suite.methods.size() + kColumns - 1) / kColumns;
    const double bottom = kHead + pitch_y * double(down) + 34;
    const double width = left + pitch_x * double(std::min(kColumns, suite.methods.size())) + 6;
    Svg svg(width, bottom + 50);
    svg.text({14, 22}, map.title, {.size = 14, .bold = true});
    svg.text({14, 40}, "one cell, one run: step of the exercise across; a method may divide it, unless raw",
             {.size = 11});

    for (std::size_t k = 0; k < suite.methods.size(); ++k) {
        const StabilityMethod& method = suite.methods[k];
        const double x = left + pitch_x * double(k % kColumns),
                     y = kHead + pitch_y * double(k / kColumns) + kTitle; // upper left corner of its cells
        svg.text({x, y - 5}, method.name, {.size = 12, .bold = true});
        svg.box({x - 0.7, y - 0.7}, wide + 1.4, high + 1.4, "#888");
        svg.box({x, y}, wide, high, "#fff"); // not run yet
        // The cells of one fate in one path.
        std::array<std::vector<Point>, kLooks.size()> cells;
        for (std::size_t line = 0; line < map.lines.size(); ++line)
            for (std::size_t column = 0; column < suite.rates.size(); ++column) {
                const auto row = std::find_if(rows.begin(), rows.end(), [&](const StabilityRow& r) {
                    return r.map == map.name && r.method == method.name && r.value == map.lines[line].value &&
                           r.rate == suite.rates[column];
                });
                if (row != rows.end())
                    cells[std::size_t(row->verdict.fate)].push_back(
                        {x + kCell * double(column), y + high - kHigh * double(line + 1)});
            }
        for (std::size_t fate = 0; fate < kLooks.size(); ++fate) {
            const Look& look = kLooks[fate];
            std::vector<Point> corners;
            std::vector<std::pair<Point, std::string>> letters;
            for (const Point& cell : cells[fate]) {
                corners.push_back({cell.x + 0.4, cell.y + 0.4});
                letters.emplace_back(Point{cell.x + 0.5 * kCell, cell.y + 12.5}, look.letter);
            }
            svg.boxes(corners, kCell - 0.8, kHigh - 0.8, look.fill);
            svg.texts(letters, {.size = 10, .anchor = "middle", .colour = look.ink, .bold = true});
        }
        if (k % kColumns == 0) {
            for (std::size_t line = 0; line < map.lines.size(); ++line)
                svg.text({x - 5, y + high - kHigh * (double(line) + 0.5) + 3.5}, map.lines[line].value,
                         {.size = 10, .anchor = "end"});
            svg.text({12, y + 0.5 * high}, map.axis, {.size = 10, .anchor = "middle", .upright = true});
        }
        if (k + kColumns >= suite.methods.size()) {
            std::vector<std::pair<Point, std::string>> steps;
            for (std::size_t column = 0; column < suite.rates.size(); ++column)
                steps.emplace_back(Point{x + kCell * (double(column) + 0.5), y + high + 12},
                                   std::to_string(suite.rates[column]));
            svg.texts(steps, {.size = 9, .anchor = "middle"});
            svg.text({x + 0.5 * wide, y + high + 26}, "steps in a second", {.size = 10, .anchor = "middle"});
        }
    }
    draw_legend(svg, bottom + 18, width);
    svg.save(file);
}

} // namespace windlass::lab
