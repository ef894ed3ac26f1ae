#pragma once
// How wrong a method is, and what it costs: each run against a converged one of the same line and links.

#include "bench/lab/case/case.hpp"

#include <vector>

namespace windlass::lab {

/// Samples are taken this often, whatever the step: rates are multiples of it.
inline constexpr int kSampleRate = 15; ///< 1/s

/// What one run passed through, 15 times in a second, from time 0 on; one that does not settle first, from
/// the sample after it.
struct Trace {
    int links = 0;
    double rest = 0;                          ///< m, unstretched length of a link
    std::vector<double> top_tension;          ///< N
    std::vector<std::vector<Vec3>> positions; ///< m, node by node
    double peak = 0;                          ///< N, largest top tension of any step
    double cost = 0; ///< ms of processor time for a simulated second, settling left out; see stepping_cost()
    enum class End { whole, blew_up, too_long, unsolved } end = End::whole;
};

/// Limits of a run.
struct TraceLimits {
    double until = 1e9;       ///< s to which positions are kept
    double max_seconds = 1e9; ///< s of processor time; a run that would need more is given up at once
};

/// Runs a case with rate steps in a second. Blown up: a node no number, or a hundred lengths away; unsolved:
/// see Method::unsolved(). Throws std::invalid_argument when the method cannot do the case.
Trace trace(const Case& given, const MethodEntry& method, int links, int rate, const TraceLimits& limits);

/// ms of processor time for a simulated second, settling left out, of a run that nobody looks at: samples
/// between the steps empty the caches.
double stepping_cost(const Case& given, const MethodEntry& entry, int links, int rate);

/// Errors of a run against a converged one; roots of mean squares over the samples until both end.
struct Errors {
    double tension = 0;  ///< of the top tension's own root mean square
    double position = 0; ///< of the line's length, over all nodes
    double link = 0;     ///< of a link's unstretched length, over all links
    double peak = 0;     ///< of the largest top tension, signed
};
Errors errors_of(const Trace& run, const Trace& converged, double until);

} // namespace windlass::lab
