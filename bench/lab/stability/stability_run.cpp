// How a stability suite is run, and its cells as a file.

#include "bench/lab/case/table.hpp"
#include "bench/lab/stability/stability_suite.hpp"
#include "common/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace windlass::lab {
namespace {

const std::vector<std::string> kHeadings{"map",  "method",         "value",          "steps_per_s",   "fate",
                                         "at_s", "largest_strain", "energy_at_play", "cost_ms_per_s", "why"};

bool chosen(const std::vector<std::string>& choice, const std::string& one) {
    return choice.empty() || std::find(choice.begin(), choice.end(), one) != choice.end();
}

/// Place of a name in a list of what has names; behind all when it is not there.
template <typename List>
auto place(const List& list, const std::string& name) {
    return std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.name == name; }) -
           list.begin();
}

Fate fate_of(const std::string& name, const std::string& at) {
    const auto found = std::find(kFateNames.begin(), kFateNames.end(), name);
    if (found == kFateNames.end())
        throw exercise::ConfigError(at + ": \"" + name + "\" is not allowed: bounded, energy grew, ...");
    return Fate(found - kFateNames.begin());
}

} // namespace

void run_stability(const StabilitySuite& suite, const StabilitySelection& selection,
                   std::vector<StabilityRow>& rows,
                   const std::function<void(double share, const std::string& what)>& progress,
                   const std::function<void()>& keep) {
    double total = 0, done = 0;
    for (const StabilityMap& map : suite.maps)
        for (const StabilityMethod& method : suite.methods)
            if (chosen(selection.maps, map.name) && chosen(selection.methods, method.name))
                total += double(map.lines.size() * suite.rates.size());
    for (const StabilityMap& map : suite.maps)
        for (const StabilityMethod& method : suite.methods) {
            if (!chosen(selection.maps, map.name) || !chosen(selection.methods, method.name)) continue;
            for (const StabilityLine& line : map.lines)
                for (const int rate : suite.rates) {
                    progress(done++ / total,
                             fmt::format("{}: {}, {} at {}/s", map.name, method.name, line.value, rate));
                    const auto there = std::find_if(rows.begin(), rows.end(), [&](const StabilityRow& row) {
                        return std::tie(row.map, row.method, row.value, row.rate) ==
                               std::tie(map.name, method.name, line.value, rate);
                    });
                    if (there != rows.end() && selection.missing) continue;
                    Case given = line.given;
                    given.settings = method.settings;
                    FaultLimits limits;
                    limits.max_seconds = suite.max_seconds;
                    StabilityRow row{map.name, method.name, line.value, rate,
                                     judge(given, *method.entry, line.links, rate, limits)};
                    if (there != rows.end())
                        *there = std::move(row);
                    else
                        rows.push_back(std::move(row));
                }
            keep();
        }
}

void write_stability(const std::filesystem::path& file, const StabilitySuite& suite,
                     std::vector<StabilityRow> rows) {
    const auto order = [&](const StabilityRow& row) {
        const auto map = place(suite.maps, row.map);
        const auto line = map < std::ssize(suite.maps)
                              ? std::find_if(suite.maps[map].lines.begin(), suite.maps[map].lines.end(),
                                             [&](const StabilityLine& l) { return l.value == row.value; }) -
                                    suite.maps[map].lines.begin()
                              : 0;
        return std::tuple(map, place(suite.methods, row.method), line, row.rate);
    };
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const StabilityRow& a, const StabilityRow& b) { return order(a) < order(b); });
    TextRows lines;
    for (const StabilityRow& row : rows) {
        const Verdict& v = row.verdict;
        lines.push_back({row.map, row.method, row.value, std::to_string(row.rate),
                         kFateNames[std::size_t(v.fate)], fmt::format("{:.4g}", v.when),
                         fmt::format("{:.3e}", v.strain), fmt::format("{:.3e}", v.energy),
                         fmt::format("{:.3g}", v.cost), v.why});
    }
    write_text_rows(file, kHeadings, lines);
}

std::vector<StabilityRow> read_stability(const std::filesystem::path& file) {
    std::vector<StabilityRow> rows;
    std::size_t line = 1;
    for (const std::vector<std::string>& cells : read_text_rows(file, kHeadings)) {
        const std::string at = file.string() + ": line " + std::to_string(++line);
        const auto value = [&](std::size_t k) { return number_in(cells[k], at); };
        rows.push_back({cells[0],
                        cells[1],
                        cells[2],
                        int(value(3)),
                        {fate_of(cells[4], at), value(5), value(6), value(7), value(8), cells[9]}});
    }
    return rows;
}

} // namespace windlass::lab
