#include "common/figure_text.hpp"

#include "words/words.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace windlass {

namespace {

/// That many decimals at most, and no minus before a zero.
std::string decimals(double value, int most) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", most, value);
    std::string all = text.data();
    if (all.find('.') != std::string::npos) {
        all.erase(all.find_last_not_of('0') + 1);
        if (all.back() == '.') all.pop_back();
    }
    return all == "-0" ? "0" : all;
}

/// "11.5 o'clock": as fine as a lead is made out.
std::string clock_hour(double hours) {
    const double half = std::fmod(std::round(2 * hours) / 2 + 12, 12);
    return decimals(half < 1 ? half + 12 : half, 1) + " o'clock";
}

/// Three figures; no powers of ten to a seaman.
std::string three_figures(double value) {
    constexpr double kNothing = 0.0005;
    if (std::abs(value) < kNothing) return "0";
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), std::abs(value) < 999.5 ? "%.3g" : "%.0f", value);
    return text.data();
}

} // namespace

std::string figure_text(double value, const std::string& unit) {
    if (unit == "N") return decimals(value / 1000, 0) + " kN";
    if (unit == "K") return decimals(value - words::limits::ice_point, 0) + " \u00b0C";
    if (unit == "yes") return value > 0.5 ? "yes" : "no";
    if (unit == "h") return clock_hour(value);
    if (unit == "shackles") return shackles_figure(value) + ' ' + unit;
    return three_figures(value) + (unit.empty() ? "" : " " + unit);
}

std::string shackles_figure(double shackles) {
    return decimals(shackles, 2);
}

std::int64_t points_in_tenths(double points) {
    constexpr double kBinary = 1e-6; // of a tenth, by which 0.1 * 696 may be short of 69.6
    return static_cast<std::int64_t>(std::floor(10 * points + kBinary));
}

std::string points_text(double points) {
    const auto tenths = points_in_tenths(points);
    return std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10);
}

std::string share_text(double points) {
    return points_text(points + 0.05);
}

} // namespace windlass
