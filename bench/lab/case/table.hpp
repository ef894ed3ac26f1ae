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
Table read_table(const std::filesystem::path& file, std::size_t min_columns, std::size_t min_rows);

/// Writes a table. Throws std::runtime_error naming the file when it cannot be written.
void write_table(const std::filesystem::path& file, const Table& table);

/// Rows of text under known headings: results kept in a file so that some of them can be made anew.
using TextRows = std::vector<std::vector<std::string>>;

/// Reads such a file; none when there is no file. Throws exercise::ConfigError (file, line, what is allowed)
/// when its headings are others, or a row has more or fewer cells.
TextRows read_text_rows(const std::filesystem::path& file, const std::vector<std::string>& names);

/// Writes it, whole or not at all; commas within a cell become semicolons. Throws std::runtime_error naming
/// the file when it cannot be written.
void write_text_rows(const std::filesystem::path& file, const std::vector<std::string>& names,
                     const TextRows& rows);

/// The number in a cell; 0 when it is empty. Throws exercise::ConfigError naming the place.
double number_in(const std::string& cell, const std::string& place);

/// Value at x by straight lines between the rows of a rising first column; clamped beyond its ends.
double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x);

} // namespace windlass::lab
