#include "server/physics/sea/gusts.hpp"

#include "server/physics/sea/chance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::physics {

namespace {

constexpr double kSlowest = 1.0 / 600, kFastest = 0.1; ///< Hz
constexpr double kShape = 0.468;                       ///< n of the spectrum
/// Standard deviations by which the largest of ten minutes passes their mean, in the mean (found by adding
/// up, at 10 and 20 m/s; test Gusts).
constexpr double kPeak = 2.55;
constexpr double kCrosswise = 0.75;

/// NPD's density over f, without its height; f in units of the frequency that 172 (z / 10)^(2/3)
/// (U / 10)^(-3/4) makes 1.
double density(double f) {
    return std::pow(1 + std::pow(f, kShape), -5 / (3 * kShape));
}

} // namespace

void Gusts::make(const WindDef& mean) {
    made_of_ = mean;
    // f S is largest where f^n is 3/2.
    static const double peak = std::pow(1.5, 1 / kShape);
    const double own = peak / 172 * std::pow(mean.speed / 10, 0.75); // Hz, at 10 m
    const double scale = peak * (mean.gust_period > 0 ? mean.gust_period : 1 / own);
    double variance = 0;
    const double step = std::log(kFastest / kSlowest) / kWaves;
    for (std::size_t i = 0; i < kWaves; ++i) {
        const auto number = static_cast<int>(i);
        const double place = number + 0.2 + 0.6 * golden(number + 1);
        const double f = kSlowest * std::exp(step * place);
        const double width = kSlowest * (std::exp(step * (number + 1)) - std::exp(step * number));
        omega_[i] = 2 * std::numbers::pi * f;
        along_[i] = std::sqrt(2 * density(scale * f) * width);
        phase_[i] = 2 * std::numbers::pi * chance(mean.seed, Chance::gust, number);
        phase_across_[i] = 2 * std::numbers::pi * chance(mean.seed, Chance::gust_across, number);
        variance += 0.5 * along_[i] * along_[i];
    }
    const double deviation = (mean.gust_factor - 1) * mean.speed / kPeak;
    for (double& a : along_)
        a *= deviation / std::sqrt(variance);
}

WindNow Gusts::wind(const WindDef& mean, double t) {
    if (mean.gust_factor <= 1 || mean.speed <= 0) return {mean.speed, mean.from};
    if (mean != made_of_) {
        WindDef steady = mean; // of the direction the gusts know nothing
        steady.from = made_of_.from;
        if (steady != made_of_) make(mean);
    }
    double along = 0, across = 0;
    for (std::size_t i = 0; i < kWaves; ++i) {
        along += along_[i] * std::cos(omega_[i] * t + phase_[i]);
        across += along_[i] * std::cos(omega_[i] * t + phase_across_[i]);
    }
    return {std::max(0.0, mean.speed + along), mean.from + kCrosswise * across / mean.speed};
}

} // namespace windlass::physics
