#pragma once
// Columns of numbers in CSV files: motions, shapes, measured series.

#include <filesystem>
#include <string>
#include <vector>

namespace windlass::lab {

/// Columns of equal length, each with its heading.
struct Table {
    std::vector<std::string> names;
    std::vector<std::vector<double>> columns;
    std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// Reads a comma-separated file with one line of headings; lines that begin with # are skipped. Throws
/// exercise::ConfigError (file, line, what is allowed) when it cannot be read, holds fewer columns or rows
/// than asked for, or anything but finite numbers.
Table read_table(const std::filesystem::path& file, std::size_t least_columns, std::size_t least_rows);

/// Writes a table. Throws std::runtime_error naming the file when it cannot be written.
void write_table(const std::filesystem::path& file, const Table& table);

/// Value at x by straight lines between the rows of a rising first column; clamped beyond its ends.
double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x);

} // namespace windlass::lab
