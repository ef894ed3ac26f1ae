#pragma once
// Whether the error that the model publishes of itself covers the one that it makes.

#include "rigs/whole_anchoring.hpp"

namespace windlass::rigs {

/// How one kind of error and its estimate go together over the moments of a run for which there is one.
struct Coverage {
    double within = 0;       ///< share of the moments in which the error is at most the estimate
    double within_three = 0; ///< share in which it is at most three times the estimate
    double worst = 0;        ///< largest error over its estimate
    double error = 0;        ///< root mean square over the moments
    double estimate = 0;     ///< root mean square
};

/// Of the load: what the mean of two seconds differs, as a fraction of the reference's, against the estimate
/// at the end of these seconds. Of the shape: root mean square distance (m) of the nodes from the reference's
/// cable, against the estimate of that moment.
struct ErrorCoverage {
    double estimated = 0; ///< share of the moments for which there is an estimate
    Coverage load, shape;
};

/// The error of one moment.
struct MomentError {
    physics::ModelError error, estimate;
    double friction = 0; ///< share of the steps before it with friction of the step's start
};

/// Of each moment that both runs have, but for the first and the last two seconds.
std::vector<MomentError> moment_errors(const AnchoringRun& run, const AnchoringRun& reference);
ErrorCoverage coverage(const std::vector<MomentError>& moments);

} // namespace windlass::rigs
