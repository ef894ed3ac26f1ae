#include "rigs/error_coverage.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::rigs {

namespace {

constexpr std::size_t kHalfWindow = 10; ///< moments: a second; Moment::load is the mean of two about it

class Counter {
public:
    void count(double error, double estimate) {
        ++moments_;
        within_ += error <= estimate ? 1 : 0;
        within_three_ += error <= 3 * estimate ? 1 : 0;
        worst_ = std::max(worst_, error / estimate);
        error_ += error * error, estimate_ += estimate * estimate;
    }
    long moments() const { return moments_; }
    Coverage coverage() const {
        const auto n = static_cast<double>(moments_);
        return {static_cast<double>(within_) / n, static_cast<double>(within_three_) / n, worst_,
                std::sqrt(error_ / n), std::sqrt(estimate_ / n)};
    }

private:
    long moments_ = 0, within_ = 0, within_three_ = 0;
    double worst_ = 0, error_ = 0, estimate_ = 0;
};

} // namespace

std::vector<MomentError> moment_errors(const AnchoringRun& run, const AnchoringRun& reference) {
    std::vector<MomentError> errors;
    const std::size_t count = std::min(run.moments.size(), reference.moments.size());
    for (std::size_t k = 2 * kHalfWindow; k < count; ++k) {
        const Moment &now = run.moments[k], &mean = run.moments[k - kHalfWindow];
        const double load = reference.moments[k - kHalfWindow].load;
        errors.push_back(
            {.error = {std::abs(mean.load - load) / load, shape_distance(now, reference.moments[k])},
             .estimate = now.error,
             .friction = now.friction});
    }
    return errors;
}

ErrorCoverage coverage(const std::vector<MomentError>& moments) {
    Counter load, shape;
    for (const MomentError& moment : moments) {
        if (moment.estimate.load < 0) continue;
        load.count(moment.error.load, moment.estimate.load);
        shape.count(moment.error.shape, moment.estimate.shape);
    }
    return {static_cast<double>(load.moments()) / static_cast<double>(moments.size()), load.coverage(),
            shape.coverage()};
}

} // namespace windlass::rigs
