#pragma once
// The charts of a comparison: error against cost, and cost against nodes.

#include "bench/lab/suite.hpp"

namespace windlass::lab {

/// For one case: a column for each number of links that is to be drawn, a row for each kind of error. Throws
/// std::runtime_error naming the file when it cannot be written.
void draw_work_precision(const Suite& suite, const SuiteCase& one, const std::vector<SuiteRow>& rows,
                         const std::filesystem::path& file);

/// The least cost (ms for a simulated second) at which a method errs by less than limit in the top tension,
/// and by less than 3 % in its peak, in every case of the suite that is a bar, at one rate.
struct CheapestRun {
    std::string method;
    int nodes = 0, rate = 0;
    double cost = 0, limit = 0;
};
std::vector<CheapestRun> cheapest_runs(const Suite& suite, const std::vector<SuiteRow>& rows, double limit);

/// Cheapest runs at 1 % and at 0.1 % against the number of links.
void draw_cost(const Suite& suite, const std::vector<SuiteRow>& rows, const std::filesystem::path& file);

} // namespace windlass::lab
