#pragma once
// Comparison suites: a ladder of links and steps for every case and method, run and kept as one table. The
// format is bench/schema/suite.schema.json.

#include "bench/lab/accuracy/work_precision.hpp"
#include "bench/lab/case/table.hpp"

#include <functional>

namespace windlass::lab {

/// One case of a suite.
struct SuiteCase {
    std::string name; ///< unless given, that of the case file without its ending
    Case given;
    std::vector<int> nodes, rates;
    std::vector<int> drawn; ///< of nodes, with a column in the chart of error against cost
    int reference_rate = 0;
    double until = 1e9; ///< s
    std::string bar;    ///< of which bar a method must pass it, "": none
};

struct Suite {
    std::vector<const MethodEntry*> methods;
    double max_seconds = 2; ///< s
    std::vector<SuiteCase> cases;

    /// The bars of its cases, in the order in which they come.
    std::vector<std::string> bars() const;
};

/// Throws exercise::ConfigError: file, JSON pointer, value, what is allowed.
Suite load_suite(const std::filesystem::path& file);

/// Which runs of a suite are to be done; what is empty leaves nothing out.
struct Selection {
    std::vector<std::string> methods, cases;
    std::vector<int> nodes;
    bool missing = false; ///< only what is not among the rows yet
};

/// Method of the rows that check the converged run, with ": NAME" after it.
inline constexpr const char* kReferenceCheck = "reference check";

/// One run of a suite.
struct SuiteRow {
    std::string case_name;
    int nodes = 0;
    std::string method;
    int rate = 0;    ///< steps in a second
    double cost = 0; ///< ms of processor time for a simulated second
    Errors errors;
    std::string end; ///< "", "blew up", "too long", "unsolved" or why the method cannot do the case
};

/// Runs what is selected and puts it among the rows, in the place of what was there of the same case, links
/// and method. progress is told before each run what it is and how far the whole is; keep is told whenever a
/// method is done with a line. The rows of method "reference check" tell how far the converged run can be
/// trusted: production at half its rate, and leapfrog at its rate.
void run_suite(const Suite& suite, const Selection& selection, std::vector<SuiteRow>& rows,
               const std::function<void(double share, const std::string& what)>& progress,
               const std::function<void()>& keep);

/// The data of a case's chart: work_precision_NAME.csv in the folder.
std::filesystem::path rows_file(const std::filesystem::path& folder, const std::string& case_name);

/// As CSV, the rows of one case: a line for each curve, its points as numbers with spaces between, in the
/// order of the suite. Throws std::runtime_error naming the file when it cannot be written.
void write_rows(const std::filesystem::path& file, const Suite& suite, const std::string& case_name,
                std::vector<SuiteRow> rows, const Notes& notes = {});

/// Reads what write_rows() wrote; nothing when there is no file. Throws exercise::ConfigError: file, line or
/// row, what is allowed.
std::vector<SuiteRow> read_rows(const std::filesystem::path& file, const std::string& case_name);

} // namespace windlass::lab
