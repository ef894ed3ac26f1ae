#pragma once
// The commands of chain_lab, each in its own file.

#include "bench/lab/case/table.hpp"

#include <CLI/CLI.hpp>

namespace windlass::lab {

/// Exit codes of chain_lab.
enum ExitCode {
    kDone = 0,
    kBlewUp = 1, ///< the method's numbers ceased to be numbers
    kBadOption = 2,
    kBadFile = 3, ///< a case, suite, table or result file cannot be read or written
    kCannotDo = 4 ///< the method cannot do the case
};

/// Each adds its command; when it was given, its callback does the work and sets exit_code.
void add_run(CLI::App& app, int& exit_code);
void add_list(CLI::App& app);
void add_compare(CLI::App& app);
void add_converge(CLI::App& app);
void add_shapes(CLI::App& app);
void add_stability(CLI::App& app);

/// --note: what is written above data that a run makes.
void add_note(CLI::App& command, std::string& note);

/// The notes that such a file has after the run: of all its rows, made anew, or with one on those made now.
Notes notes_after(const std::filesystem::path& file, bool anew, const std::string& note);

} // namespace windlass::lab
