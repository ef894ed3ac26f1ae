#pragma once
// Where a bench writes its table.

#include <CLI/CLI.hpp>
#include <fmt/ostream.h>

#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace windlass::bench {

/// File and note of a table, as the command line has them.
struct TableOptions {
    std::string out;  ///< empty: standard output
    std::string note; ///< written above the table, behind a #; empty: none
};

inline void add_table_options(CLI::App& app, TableOptions& options) {
    app.add_option("--out", options.out, "file for the table; else standard output");
    app.add_option("--note", options.note, "line above the table: date, machine, commit");
}

/// The table itself, begun with its note.
class TableFile {
public:
    /// Throws std::runtime_error where the file cannot be written.
    explicit TableFile(const TableOptions& options) {
        if (!options.out.empty()) {
            file_.open(options.out);
            if (!file_) throw std::runtime_error(options.out + ": cannot be written");
        }
        if (!options.note.empty()) fmt::print(stream(), "# {}\n", options.note);
    }
    std::ostream& stream() { return file_.is_open() ? file_ : std::cout; }

private:
    std::ofstream file_;
};

} // namespace windlass::bench
