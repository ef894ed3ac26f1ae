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

/// Lines that begin with # before the headings: how the rows were made.
using Notes = std::vector<std::string>;

/// Reads such a file; none when there is no file. Throws exercise::ConfigError (file, line, what is allowed)
/// when its headings are others, or a row has more or fewer cells.
TextRows read_text_rows(const std::filesystem::path& file, const std::vector<std::string>& names);

/// Its notes, without their #; none when there is no file.
Notes read_notes(const std::filesystem::path& file);

/// Writes it, whole or not at all; cells with commas are put in quotes. Throws std::runtime_error naming the
/// file when it cannot be written.
void write_text_rows(const std::filesystem::path& file, const std::vector<std::string>& names,
                     const TextRows& rows, const Notes& notes = {});

/// Where the rows of such a file begin, for what is said of them: "FILE: row 1" is the first below the
/// headings.
std::string row_place(const std::filesystem::path& file, std::size_t row);

/// The numbers of a cell that holds several, spaces between. Throws exercise::ConfigError naming the place.
std::vector<double> numbers_in(const std::string& cell, const std::string& place);

/// The number in a cell; 0 when it is empty. Throws exercise::ConfigError naming the place.
double number_in(const std::string& cell, const std::string& place);

/// Value at x by straight lines between the rows of a rising first column; clamped beyond its ends.
double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x);

} // namespace windlass::lab
