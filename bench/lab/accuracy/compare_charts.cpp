#include "bench/lab/accuracy/compare_charts.hpp"

#include "bench/lab/draw/chart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace windlass::lab {
namespace {

constexpr double kPanelWidth = 475, kPanelHeight = 300, kHead = 38;
constexpr double kMinError = 1e-9, kLargestError = 10;

/// The same colour for a method in every chart, whichever of them a suite runs.
std::string colour_of_method(const std::string& name) {
    const auto& all = methods();
    return colour_of(
        int(std::find_if(all.begin(), all.end(), [&](const MethodEntry& m) { return m.name == name; }) -
            all.begin()));
}

struct Kind {
    const char* label;
    double Errors::*part;
};
constexpr std::array kKinds{Kind{"error of the top tension", &Errors::tension},
                            Kind{"error of position / line length", &Errors::position},
                            Kind{"error of link length / link", &Errors::link},
                            Kind{"error of the largest tension", &Errors::peak}};

bool is_check(const SuiteRow& row) {
    return row.method.starts_with(kReferenceCheck);
}

/// How far the converged runs of two methods differ: below this line an error says nothing.
Curve doubt(const std::vector<SuiteRow>& rows, const std::string& case_name, int nodes,
            double Errors::*part) {
    double dearest = 0, cheapest = 1e300, difference = 0;
    for (const SuiteRow& row : rows) {
        if (row.case_name != case_name || row.nodes != nodes || !row.end.empty()) continue;
        if (is_check(row)) {
            difference = std::max(difference, std::abs(row.errors.*part));
        } else {
            dearest = std::max(dearest, row.cost);
            cheapest = std::min(cheapest, row.cost);
        }
    }
    std::vector<Point> line{{cheapest, difference}, {dearest, difference}};
    if (dearest == 0 || difference == 0) line.clear();
    return {
        .name = "converged runs", .points = std::move(line), .colour = "#777777", .dash = "4 3", .width = 1};
}

Curve curve_of(const std::string& method, double width) {
    return {.name = method,
            .points = {},
            .colour = colour_of_method(method),
            .marked = true,
            .dash = "",
            .width = width};
}

} // namespace

void draw_work_precision(const Suite& suite, const SuiteCase& one, const std::vector<SuiteRow>& rows,
                         const std::filesystem::path& file) {
    Svg svg(kPanelWidth * double(one.drawn.size()), kHead + kPanelHeight * double(kKinds.size()));
    svg.text({14, 22},
             one.given.title +
                 ": error against cost, each point a step size; dashed: how far converged runs differ",
             {.size = 16, .bold = true});
    for (std::size_t column = 0; column < one.drawn.size(); ++column)
        for (std::size_t line = 0; line < kKinds.size(); ++line) {
            Panel panel{.title = fmt::format("{} links", one.drawn[column]),
                        .x = {"processor ms for a simulated second", true},
                        .y = {kKinds[line].label, true},
                        .curves = {}};
            panel.curves.push_back(doubt(rows, one.name, one.drawn[column], kKinds[line].part));
            for (const MethodEntry* method : suite.methods) {
                Curve curve = curve_of(method->name, method->name == "production" ? 2.4 : 1.2);
                for (const SuiteRow& row : rows)
                    if (const double error = std::abs(row.errors.*kKinds[line].part);
                        row.case_name == one.name && row.method == method->name &&
                        row.nodes == one.drawn[column] && row.end.empty() && error < kLargestError)
                        curve.points.push_back({row.cost, std::max(kMinError, error)});
                panel.curves.push_back(std::move(curve));
            }
            draw(svg, panel, {kPanelWidth * double(column), kHead + kPanelHeight * double(line)}, kPanelWidth,
                 kPanelHeight);
        }
    svg.save(file);
}

std::string cases_of(const Suite& suite, const std::string& bar) {
    std::vector<std::string> names;
    for (const SuiteCase& one : suite.cases)
        if (one.bar == bar) names.push_back(one.name);
    return fmt::format("{}", fmt::join(names, " and "));
}

std::vector<CheapestRun> cheapest_runs(const Suite& suite, const std::vector<SuiteRow>& rows,
                                       const std::string& bar, double limit) {
    std::set<std::string> names;
    for (const SuiteCase& one : suite.cases)
        if (one.bar == bar) names.insert(one.name);
    // By method and links, then by rate: in how many cases it passes, and what the dearest of them costs.
    std::map<std::pair<std::string, int>, std::map<int, std::pair<std::size_t, double>>> passed;
    for (const SuiteRow& row : rows) {
        if (!row.end.empty() || !names.contains(row.case_name) || is_check(row)) continue;
        if (!(row.errors.tension < limit) || !(std::abs(row.errors.peak) < 0.03)) continue;
        auto& [count, cost] = passed[{row.method, row.nodes}][row.rate];
        ++count;
        cost = std::max(cost, row.cost);
    }
    std::vector<CheapestRun> cheapest;
    for (const auto& [key, rates] : passed) {
        CheapestRun best{key.first, key.second, 0, 1e300};
        for (const auto& [rate, result] : rates)
            if (result.first == names.size() && result.second < best.cost)
                best.rate = rate, best.cost = result.second;
        if (best.rate > 0) cheapest.push_back(best);
    }
    return cheapest;
}

void draw_cost(const Suite& suite, const std::vector<SuiteRow>& rows, const std::filesystem::path& file) {
    constexpr double kWide = 515, kHigh = 400;
    const std::vector<std::string> bars = suite.bars();
    Svg svg(kWide * double(std::size(kLimits)), kHead + kHigh * double(bars.size()));
    svg.text({14, 22}, "Least cost at which a method stays within an error of the top tension",
             {.size = 16, .bold = true});
    for (std::size_t line = 0; line < bars.size(); ++line)
        for (std::size_t column = 0; column < std::size(kLimits); ++column) {
            Panel panel{.title = fmt::format("{}: {:g} % in {}", bars[line], 100 * kLimits[column],
                                             cases_of(suite, bars[line])),
                        .x = {"links", true},
                        .y = {"processor ms for a simulated second", true},
                        .curves = {}};
            const std::vector<CheapestRun> cheapest = cheapest_runs(suite, rows, bars[line], kLimits[column]);
            for (const MethodEntry* method : suite.methods) {
                Curve curve = curve_of(method->name, method->name == "production" ? 2.4 : 1.2);
                for (const CheapestRun& run : cheapest)
                    if (run.method == method->name) curve.points.push_back({double(run.nodes), run.cost});
                panel.curves.push_back(std::move(curve));
            }
            draw(svg, panel, {kWide * double(column), kHead + kHigh * double(line)}, kWide, kHigh);
        }
    svg.save(file);
}

} // namespace windlass::lab
