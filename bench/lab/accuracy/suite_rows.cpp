// The rows of a suite as a file.

#include "bench/lab/accuracy/suite.hpp"
#include "bench/lab/case/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace windlass::lab {
namespace {

const std::vector<std::string> kHeadings{
    "case",          "nodes",          "method",     "steps_per_s", "cost_ms_per_s",
    "tension_error", "position_error", "link_error", "peak_error",  "end"};

/// Place of a row in the suite; what the suite does not have comes last.
auto place(const Suite& suite, const SuiteRow& row) {
    const auto case_at = std::find_if(suite.cases.begin(), suite.cases.end(),
                                      [&](const SuiteCase& one) { return one.name == row.case_name; });
    const auto method_at = std::find_if(suite.methods.begin(), suite.methods.end(),
                                        [&](const MethodEntry* m) { return m->name == row.method; });
    const bool check = row.method.starts_with(kReferenceCheck);
    return std::tuple(case_at - suite.cases.begin(), row.nodes,
                      check ? -1 : method_at - suite.methods.begin(), row.rate);
}

} // namespace

void write_rows(const std::filesystem::path& file, const Suite& suite, std::vector<SuiteRow> rows) {
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const SuiteRow& a, const SuiteRow& b) { return place(suite, a) < place(suite, b); });
    TextRows lines;
    for (const SuiteRow& row : rows) {
        const bool whole = row.end.empty();
        const auto figure = [&](double value) {
            return whole ? fmt::format("{:.3e}", value) : std::string();
        };
        lines.push_back({row.case_name, std::to_string(row.nodes), row.method, std::to_string(row.rate),
                         whole ? fmt::format("{:.4g}", row.cost) : "", figure(row.errors.tension),
                         figure(row.errors.position), figure(row.errors.link), figure(row.errors.peak),
                         row.end});
    }
    write_text_rows(file, kHeadings, lines);
}

std::vector<SuiteRow> read_rows(const std::filesystem::path& file) {
    std::vector<SuiteRow> rows;
    std::size_t line = 1;
    for (const std::vector<std::string>& cells : read_text_rows(file, kHeadings)) {
        const std::string place = file.string() + ": line " + std::to_string(++line);
        const auto value = [&](std::size_t k) { return number_in(cells[k], place); };
        rows.push_back({cells[0],
                        int(value(1)),
                        cells[2],
                        int(value(3)),
                        value(4),
                        {.tension = value(5), .position = value(6), .link = value(7), .peak = value(8)},
                        cells[9]});
    }
    return rows;
}

} // namespace windlass::lab
