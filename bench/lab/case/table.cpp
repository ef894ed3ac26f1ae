#include "bench/lab/case/table.hpp"

#include "common/json_file.hpp"

#include <fmt/os.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace windlass::lab {
namespace {

std::vector<std::string> cells(std::string line) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) return {};
    std::vector<std::string> parts{""};
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    for (std::string& part : parts) {
        const std::size_t from = part.find_first_not_of(" \t"), to = part.find_last_not_of(" \t");
        part = from == std::string::npos ? "" : part.substr(from, to - from + 1);
    }
    return parts;
}

double number(const std::string& cell, const std::string& place) {
    double value = 0;
    const char* end = cell.data() + cell.size();
    const auto [at, error] = std::from_chars(cell.data(), end, value);
    if (error != std::errc() || at != end || !std::isfinite(value))
        throw ConfigError(place + ": \"" + cell + "\" is not allowed: a finite number");
    return value;
}

} // namespace

Table read_table(const std::filesystem::path& file, std::size_t min_columns, std::size_t min_rows) {
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
        throw ConfigError(file.string() + ": cannot be read: " + std::strerror(in ? EISDIR : errno));
    Table table;
    std::size_t count = 0;
    for (std::string line; std::getline(in, line);) {
        const std::string place = file.string() + ": line " + std::to_string(++count);
        const std::vector<std::string> parts = cells(line);
        if (parts.empty() || parts.front().starts_with('#')) continue;
        if (table.names.empty()) {
            if (parts.size() < min_columns)
                throw ConfigError(place + ": " + std::to_string(parts.size()) +
                                  " columns are not allowed: at least " + std::to_string(min_columns));
            table.names = parts;
            table.columns.resize(parts.size());
            continue;
        }
        if (parts.size() != table.names.size())
            throw ConfigError(place + ": " + std::to_string(parts.size()) + " columns are not allowed: " +
                              std::to_string(table.names.size()) + ", as in the line of headings");
        for (std::size_t k = 0; k < parts.size(); ++k)
            table.columns[k].push_back(number(parts[k], place));
    }
    if (table.rows() < min_rows)
        throw ConfigError(file.string() + ": " + std::to_string(table.rows()) +
                          " rows of numbers are not allowed: at least " + std::to_string(min_rows));
    return table;
}

TextRows read_text_rows(const std::filesystem::path& file, const std::vector<std::string>& names) {
    if (!std::filesystem::exists(file)) return {};
    std::ifstream in(file);
    TextRows rows;
    std::size_t count = 0;
    bool headed = false;
    for (std::string line; std::getline(in, line);) {
        const std::string place = file.string() + ": line " + std::to_string(++count);
        if (!headed && line.starts_with('#')) continue;
        std::vector<std::string> parts = cells(line);
        if (!headed && parts != names)
            throw ConfigError(
                place + ": these headings are not allowed: " + fmt::format("{}", fmt::join(names, ",")));
        if (parts.size() != names.size())
            throw ConfigError(place + ": " + std::to_string(parts.size()) + " columns are not allowed: " +
                              std::to_string(names.size()) + ", as in the line of headings");
        if (headed) rows.push_back(std::move(parts));
        headed = true;
    }
    if (in.bad()) throw ConfigError(file.string() + ": cannot be read: " + std::strerror(errno));
    return rows;
}

Notes read_notes(const std::filesystem::path& file) {
    std::ifstream in(file);
    Notes notes;
    for (std::string line; std::getline(in, line) && line.starts_with('#');) {
        const std::size_t from = line.find_first_not_of("# ");
        notes.push_back(from == std::string::npos ? "" : line.substr(from));
    }
    return notes;
}

void write_text_rows(const std::filesystem::path& file, const std::vector<std::string>& names,
                     const TextRows& rows, const Notes& notes) {
    // Beside it first: whoever breaks off the work keeps what there was.
    const std::filesystem::path fresh = file.string() + ".part";
    std::ofstream out(fresh);
    for (const std::string& note : notes)
        out << "# " << note << '\n';
    out << fmt::format("{}\n", fmt::join(names, ","));
    for (const std::vector<std::string>& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            std::string cell = row[k];
            std::ranges::replace(cell, '\n', ' ');
            std::ranges::replace(cell, '"', '\'');
            if (cell.find(',') != std::string::npos) cell = '"' + cell + '"';
            out << (k > 0 ? "," : "") << cell;
        }
        out << '\n';
    }
    out.close();
    std::error_code failed;
    if (out) std::filesystem::rename(fresh, file, failed);
    if (!out || failed)
        throw std::runtime_error(
            file.string() + ": cannot be written: " + (failed ? failed.message() : std::strerror(errno)));
}

std::string row_place(const std::filesystem::path& file, std::size_t row) {
    return file.string() + ": row " + std::to_string(row);
}

std::vector<double> numbers_in(const std::string& cell, const std::string& place) {
    std::vector<double> values;
    std::istringstream in(cell);
    for (std::string part; in >> part;)
        values.push_back(number(part, place));
    return values;
}

double number_in(const std::string& cell, const std::string& place) {
    return cell.empty() ? 0 : number(cell, place);
}

void write_table(const std::filesystem::path& file, const Table& table) {
    std::ofstream out(file);
    for (std::size_t k = 0; k < table.names.size(); ++k)
        out << (k > 0 ? "," : "") << table.names[k];
    out << '\n';
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (std::size_t k = 0; k < table.columns.size(); ++k)
            out << (k > 0 ? "," : "") << fmt::format("{:.9g}", table.columns[k][row]);
        out << '\n';
    }
    out.close();
    if (!out) throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(errno));
}

double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
    const std::size_t i =
        std::clamp<std::size_t>(std::upper_bound(xs.begin(), xs.end(), x) - xs.begin(), 1, xs.size() - 1);
    const double share = std::clamp((x - xs[i - 1]) / (xs[i] - xs[i - 1]), 0.0, 1.0);
    return ys[i - 1] + share * (ys[i] - ys[i - 1]);
}

} // namespace windlass::lab
