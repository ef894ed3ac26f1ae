#include "station/format.hpp"

#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace windlass::station {

namespace {
constexpr double kStandstill = 0.005; // m/s; less is not a movement to a man on deck

// "-0" is no figure: what rounds to zero is shown as zero.
double without_minus_zero(double value, double step) {
    return std::abs(value) < step / 2 ? 0.0 : value;
}
} // namespace

std::string number(double value, int decimals) {
    return fmt::format("{:.{}f}", without_minus_zero(value, std::pow(10.0, -decimals)), decimals);
}

std::string clock(double seconds) {
    const auto whole = static_cast<long>(std::floor(std::max(seconds, 0.0)));
    const long hours = whole / 3600, minutes = whole / 60 % 60, rest = whole % 60;
    return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, rest)
                     : fmt::format("{}:{:02}", minutes, rest);
}

std::string tonnes(double newton) {
    const double t = newton / words::units::tonne;
    if (std::abs(t) < 9.95) return fmt::format("{:.1f} t", without_minus_zero(t, 0.1));
    return fmt::format("{:.0f} t", t);
}

std::string load(double newton) {
    return fmt::format("{:.0f} kN ({})", without_minus_zero(newton / 1000, 1), tonnes(newton));
}

std::string cable(double metres) {
    return fmt::format("{:.0f} m", without_minus_zero(metres, 1));
}

std::string shackles(double count) {
    return fmt::format("{:.1f} shackles", without_minus_zero(count, 0.1));
}

std::string in_shackles(double metres) {
    return shackles(metres / words::units::shackle);
}

std::string cable_speed(double speed) {
    if (std::abs(speed) < kStandstill) return "stopped";
    const int decimals = std::abs(speed) < 1 ? 2 : 1;
    return fmt::format("{:.{}f} m/s {}", std::abs(speed), decimals, speed > 0 ? "out" : "in");
}

std::string knots(double speed) {
    return fmt::format("{:.1f} kn", without_minus_zero(speed / words::units::knot, 0.1));
}

std::string way(double surge) {
    return (surge < 0 ? "astern " : "ahead ") + knots(std::abs(surge));
}

std::string bearing(double angle) {
    const long degrees = std::lround(angle / words::units::degree) % 360;
    return fmt::format("{:03}", degrees < 0 ? degrees + 360 : degrees);
}

std::string celsius(double kelvin) {
    return fmt::format("{:.0f} degC", without_minus_zero(kelvin - words::limits::ice_point, 1));
}

std::string megajoules(double joule) {
    return fmt::format("{:.1f} MJ", without_minus_zero(joule / 1e6, 0.1));
}

std::string percent(double fraction) {
    return fmt::format("{:.0f} %", without_minus_zero(100 * fraction, 1));
}

std::string lead(double clock_hours) {
    const long hour = (std::lround(clock_hours) % 12 + 12) % 12;
    return fmt::format("{} o'clock", hour == 0 ? 12 : hour);
}

} // namespace windlass::station
