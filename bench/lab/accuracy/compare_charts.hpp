#pragma once
// The charts of a comparison: error against cost, and cost against nodes.

#include "bench/lab/accuracy/suite.hpp"

namespace windlass::lab {

/// For one case: a column for each number of links that is to be drawn, a row for each kind of error. Throws
/// std::runtime_error naming the file when it cannot be written.
void draw_work_precision(const Suite& suite, const SuiteCase& one, const std::vector<SuiteRow>& rows,
                         const std::filesystem::path& file);

/// The least cost (ms for a simulated second) at which a method errs by less than limit in the top tension,
/// and by less than 3 % in its peak, in every case of the suite that belongs to the bar, at one rate.
struct CheapestRun {
    std::string method;
    int nodes = 0, rate = 0;
    double cost = 0;
};
std::vector<CheapestRun> cheapest_runs(const Suite& suite, const std::vector<SuiteRow>& rows,
                                       const std::string& bar, double limit);

/// The limits of the tables and charts.
inline constexpr double kLimits[]{0.01, 0.001};

/// Cases of a bar: "hang and swing".
std::string cases_of(const Suite& suite, const std::string& bar);

/// Cheapest runs at each limit against the number of links, a line of panels for each bar.
void draw_cost(const Suite& suite, const std::vector<SuiteRow>& rows, const std::filesystem::path& file);

} // namespace windlass::lab
