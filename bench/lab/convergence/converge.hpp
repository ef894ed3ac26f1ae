#pragma once
// Relative error against iterations and time in the projection of one step: sweeps of PBD beside Newton's
// method, as figure 14 and table 1 of Jiang, Ren, He (2020), doi 10.1371/journal.pone.0237563, measure it.

#include "bench/lab/case/projection.hpp"
#include "bench/lab/case/table.hpp"

namespace windlass::lab {

/// How far a method has come after some iterations.
struct ConvergePoint {
    int iterations = 0;
    double error = 0;   ///< |x_i - x*| / |x_0 - x*|, x* where the method itself converges to
    double seconds = 0; ///< s of processor time up to there
};

/// One method on one problem.
struct ConvergeCurve {
    std::string problem, method;
    std::vector<ConvergePoint> points;
    double limit_distance = 0; ///< |x* - x*(Newton)| / |x_0 - x*(Newton)|, as far as the limits differ
};

/// Sweeps with the given stiffness (both ways: links that are too short, too) in three orders, and Newton's
/// method along the links as they are and along those at the start of the step; this one is left out where it
/// finds no solution, the step being too long for it. max_sweeps: of PBD. progress: 0..1. Throws
/// std::invalid_argument where neither finds one.
std::vector<ConvergeCurve> converge(const StepProblem& problem, double stiffness, int max_sweeps,
                                    const std::function<void(double)>& progress = {});

/// As CSV, a line for each curve, its points as numbers with spaces between. Throws std::runtime_error naming
/// the file when it cannot be written, as draw_converge() does.
void write_converge(const std::filesystem::path& file, const std::vector<ConvergeCurve>& curves,
                    const Notes& notes = {});
/// Reads what write_converge() wrote; nothing when there is no file. Throws exercise::ConfigError.
std::vector<ConvergeCurve> read_converge(const std::filesystem::path& file);
void draw_converge(const std::filesystem::path& file, const std::vector<ConvergeCurve>& curves);

} // namespace windlass::lab
