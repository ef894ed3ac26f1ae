// The hour and the air, which whoever looks out sees alike.

#include "server/perceive/perceive.hpp"
#include "server/perceive/senses.hpp"

#include <cmath>

namespace windlass::perceive {

namespace {

constexpr double kMinute = 60; ///< s, as a clock on a bulkhead is read

/// As an eye estimates it: two figures. 0 stays 0.
double in_two_figures(double value) {
    if (value <= 0) return 0;
    return in_steps(value, std::pow(10, std::floor(std::log10(value)) - 1));
}

} // namespace

void perceive_daylight(const exercise::Snapshot& from, Daylight& to) {
    to.tick(from.tick);
    to.time(from.time);
    to.time_of_day(kMinute * std::floor(from.environment.now.time_of_day / kMinute));
    to.visibility(in_two_figures(from.environment.now.visibility));
}

} // namespace windlass::perceive
