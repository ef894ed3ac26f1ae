#include "recorder/debrief/wall_time.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ctime>

namespace windlass::debrief {

namespace {

std::string formatted(std::int64_t unix_ns, const char* form) {
    const std::time_t seconds = unix_ns / 1'000'000'000;
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    char text[40];
    return {text, std::strftime(text, sizeof text, form, &parts)};
}

} // namespace

std::string iso_time(std::int64_t unix_ns) {
    return formatted(unix_ns, "%Y-%m-%dT%H:%M:%SZ");
}
std::string wall_time(std::int64_t unix_ns) {
    return formatted(unix_ns, "%Y-%m-%d %H:%M:%S UTC");
}
std::string iso_duration(double seconds) {
    const auto minutes = static_cast<long>(std::floor(seconds / 60));
    return fmt::format("PT{}M{:.2f}S", minutes, seconds - 60.0 * static_cast<double>(minutes));
}

} // namespace windlass::debrief
