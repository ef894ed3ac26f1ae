#pragma once
// Runs one method on one case and writes down what its probes read.

#include "bench/lab/case/case.hpp"
#include "bench/lab/case/table.hpp"

namespace windlass::lab {

/// What a run came to.
struct RunResult {
    Table series;         ///< "t_s" and a column for each probe
    double seconds = 0;   ///< s of processor time spent in the method's steps, settling included
    double simulated = 0; ///< s
    long steps = 0;
    bool finite = true; ///< false: stopped where a probe ceased to be a number
    double stopped = 0; ///< s of the result's time where that was
};

/// Told now and then how far the run is, 0..1.
using Progress = std::function<void(double share)>;

/// Throws std::invalid_argument when the method cannot do the case.
RunResult run_case(const Case& given, const MethodEntry& method, int links, double dt,
                   const Progress& progress = {});

/// Measured beside computed, over the time that both cover.
struct Comparison {
    double from = 0, to = 0; ///< s of the result
    struct Figures {
        double largest = 0, mean = 0, min = 0;
        double low_share = 0; ///< 0..1 of the time below ReferenceDef::low
    } computed, measured;
    double rms = 0; ///< of their difference, at the times of the measured series
    Table both;     ///< t_s, computed, measured
};

/// Lays a measured series (time in the first column, value in the second) beside a result. Throws
/// exercise::ConfigError when they do not overlap.
Comparison compare_with(const Table& series, const ReferenceDef& reference, const Table& measured,
                        const std::string& measured_name);

} // namespace windlass::lab
