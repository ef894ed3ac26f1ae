#include "station/wind_sea.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::station {

WindSea wind_sea(double wind_speed, double fetch, double depth) {
    constexpr double kGravity = 9.80665; // m/s^2
    constexpr double kSteepest = 14;     // lengths to a height
    if (wind_speed <= 0) return {};
    const double u = 0.71 * std::pow(wind_speed, 1.23); // m/s, wind-stress factor
    const double x = kGravity * fetch / (u * u), d = kGravity * depth / (u * u);
    const double height_limit = std::tanh(0.530 * std::pow(d, 0.75));
    const double period_limit = std::tanh(0.833 * std::pow(d, 0.375));
    const double height =
        u * u / kGravity * 0.283 * height_limit * std::tanh(0.00565 * std::sqrt(x) / height_limit);
    const double period =
        u / kGravity * 7.54 * period_limit * std::tanh(0.0379 * std::cbrt(x) / period_limit);
    const double tenths = std::round(10 * height) / 10;
    if (tenths == 0) return {};
    const double least =
        std::max(2.0, std::sqrt(2 * std::numbers::pi * kSteepest * tenths / kGravity)); // s, as waves break
    return {.height = tenths, .period = std::ceil(10 * std::max(period, least)) / 10};
}

} // namespace windlass::station
