// The rows of a suite as a file.

#include "bench/lab/accuracy/suite.hpp"
#include "common/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace windlass::lab {
namespace {

const std::vector<std::string> kHeadings{"links",          "method",        "end",
                                         "steps_per_s",    "cost_ms_per_s", "tension_error",
                                         "position_error", "link_error",    "peak_error"};

/// Place of a row among those of its case; what the suite does not have comes last.
auto place(const Suite& suite, const SuiteRow& row) {
    const auto method_at = std::find_if(suite.methods.begin(), suite.methods.end(),
                                        [&](const MethodEntry* m) { return m->name == row.method; });
    const bool check = row.method.starts_with(kReferenceCheck);
    return std::tuple(row.nodes, check ? -1 : method_at - suite.methods.begin(), row.rate);
}

} // namespace

std::filesystem::path rows_file(const std::filesystem::path& folder, const std::string& case_name) {
    return folder / ("work_precision_" + case_name + ".csv");
}

void write_rows(const std::filesystem::path& file, const Suite& suite, const std::string& case_name,
                std::vector<SuiteRow> rows, const Notes& notes) {
    std::erase_if(rows, [&](const SuiteRow& row) { return row.case_name != case_name; });
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const SuiteRow& a, const SuiteRow& b) { return place(suite, a) < place(suite, b); });
    TextRows lines;
    std::map<std::tuple<int, std::string, std::string>, std::size_t> curves;
    for (const SuiteRow& row : rows) {
        const auto [at, fresh] = curves.try_emplace({row.nodes, row.method, row.end}, lines.size());
        if (fresh) lines.push_back({std::to_string(row.nodes), row.method, row.end, "", "", "", "", "", ""});
        auto& line = lines[at->second];
        const auto add = [&line](std::size_t column, const std::string& figure) {
            std::string& cell = line[column];
            cell += (cell.empty() ? "" : " ") + figure;
        };
        add(3, std::to_string(row.rate));
        if (!row.end.empty()) continue;
        add(4, fmt::format("{:.4g}", row.cost));
        const Errors& e = row.errors;
        for (const auto& [column, error] :
             {std::pair(5, e.tension), std::pair(6, e.position), std::pair(7, e.link), std::pair(8, e.peak)})
            add(column, fmt::format("{:.4g}", error));
    }
    write_text_rows(file, kHeadings, lines, notes);
}

std::vector<SuiteRow> read_rows(const std::filesystem::path& file, const std::string& case_name) {
    std::vector<SuiteRow> rows;
    std::size_t count = 0;
    for (const std::vector<std::string>& cells : read_text_rows(file, kHeadings)) {
        const std::string place = row_place(file, ++count);
        const int links = static_cast<int>(number_in(cells[0], place));
        const bool whole = cells[2].empty();
        std::array<std::vector<double>, 6> columns;
        for (std::size_t k = 0; k < columns.size(); ++k) {
            columns[k] = numbers_in(cells[3 + k], place);
            if (columns[k].size() != (k == 0 || whole ? columns[0].size() : 0))
                throw ConfigError(fmt::format("{}: {} figures of {} are not allowed: as many as of "
                                              "{}",
                                              place, columns[k].size(), kHeadings[3 + k], kHeadings[3]));
        }
        for (std::size_t i = 0; i < columns[0].size(); ++i) {
            SuiteRow row{case_name, links, cells[1], static_cast<int>(columns[0][i]), 0, {}, cells[2]};
            if (whole) {
                row.cost = columns[1][i];
                row.errors = {.tension = columns[2][i],
                              .position = columns[3][i],
                              .link = columns[4][i],
                              .peak = columns[5][i]};
            }
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

} // namespace windlass::lab
