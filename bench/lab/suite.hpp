#pragma once
// Comparison suites: a ladder of links and steps for every case and method, run and kept as one table. The
// format is bench/schema/suite.schema.json.

#include "bench/lab/work_precision.hpp"

#include <functional>

namespace windlass::lab {

/// One case of a suite.
struct SuiteCase {
    std::string name; ///< of the case file, without its ending
    Case given;
    std::vector<int> nodes, rates;
    std::vector<int> drawn; ///< of nodes, with a column in the chart of error against cost
    int reference_rate = 0;
    double until = 1e9; ///< s
    bool bar = false;
};

struct Suite {
    std::vector<const MethodEntry*> methods;
    double most_seconds = 2; ///< s
    std::vector<SuiteCase> cases;
};

/// Throws exercise::ConfigError: file, JSON pointer, value, what is allowed.
Suite load_suite(const std::filesystem::path& file);

/// Method of the rows that check the converged run, with ": NAME" after it.
inline constexpr const char* kReferenceCheck = "reference check";

/// One run of a suite.
struct SuiteRow {
    std::string case_name, method;
    int nodes = 0, rate = 0;
    double cost = 0; ///< ms of processor time for a simulated second
    Errors errors;
    std::string end; ///< "", "blew up", "too long" or why the method cannot do the case
};

/// Runs everything. progress is told before each run what it is and how far the whole is; keep gets all rows
/// so far whenever a line is done. The rows of method "reference check" tell how far the converged run can be
/// trusted: production at half its rate, and leapfrog at its rate.
std::vector<SuiteRow> run_suite(const Suite& suite,
                                const std::function<void(double share, const std::string& what)>& progress,
                                const std::function<void(const std::vector<SuiteRow>&)>& keep);

/// As CSV, one line a row. Throws std::runtime_error naming the file when it cannot be written.
void write_rows(const std::filesystem::path& file, const std::vector<SuiteRow>& rows);

} // namespace windlass::lab
