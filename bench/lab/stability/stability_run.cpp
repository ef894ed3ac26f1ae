// How a stability suite is run, and its cells as a file.

#include "bench/lab/stability/stability_suite.hpp"
#include "common/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace windlass::lab {
namespace {

const std::vector<std::string> kHeadings{"method", "value", "fate", "steps_per_s"};

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
        throw ConfigError(at + ": \"" + name + "\" is not allowed: bounded, energy grew, ...");
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

std::filesystem::path cells_file(const std::filesystem::path& folder, const std::string& map) {
    return folder / ("stability_" + map + ".csv");
}

void write_stability(const std::filesystem::path& file, const StabilitySuite& suite, const std::string& map,
                     std::vector<StabilityRow> rows, const Notes& notes) {
    std::erase_if(rows, [&](const StabilityRow& row) { return row.map != map; });
    const auto known = place(suite.maps, map);
    const auto order = [&](const StabilityRow& row) {
        const auto line = known < std::ssize(suite.maps)
                              ? std::find_if(suite.maps[known].lines.begin(), suite.maps[known].lines.end(),
                                             [&](const StabilityLine& l) { return l.value == row.value; }) -
                                    suite.maps[known].lines.begin()
                              : 0;
        return std::tuple(place(suite.methods, row.method), line, row.verdict.fate, row.rate);
    };
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const StabilityRow& a, const StabilityRow& b) { return order(a) < order(b); });
    TextRows lines;
    for (const StabilityRow& row : rows) {
        const std::string fate = kFateNames[std::size_t(row.verdict.fate)];
        if (!lines.empty() && lines.back()[0] == row.method && lines.back()[1] == row.value &&
            lines.back()[2] == fate)
            lines.back()[3] += ' ' + std::to_string(row.rate);
        else
            lines.push_back({row.method, row.value, fate, std::to_string(row.rate)});
    }
    write_text_rows(file, kHeadings, lines, notes);
}

std::vector<StabilityRow> read_stability(const std::filesystem::path& file, const std::string& map) {
    std::vector<StabilityRow> rows;
    std::size_t count = 0;
    for (const std::vector<std::string>& cells : read_text_rows(file, kHeadings)) {
        const std::string at = row_place(file, ++count);
        for (const double rate : numbers_in(cells[3], at)) {
            StabilityRow row{map, cells[0], cells[1], static_cast<int>(rate), {}};
            row.verdict.fate = fate_of(cells[2], at);
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

} // namespace windlass::lab
