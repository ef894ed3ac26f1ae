#include "common/figure_text.hpp"

#include "words/words.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace windlass {

std::string figure_text(double value, const std::string& unit) {
    std::array<char, 64> text{};
    if (unit == "N") {
        std::snprintf(text.data(), text.size(), "%.0f kN", value / 1000);
    } else if (unit == "K") {
        std::snprintf(text.data(), text.size(), "%.0f degC", value - words::limits::ice_point);
    } else if (unit == "yes") {
        std::snprintf(text.data(), text.size(), "%s", value > 0.5 ? "yes" : "no");
    } else {
        const char* form = std::abs(value) < 999.5 ? "%.3g%s%s" : "%.0f%s%s"; // no powers of ten to a seaman
        std::snprintf(text.data(), text.size(), form, value, unit.empty() ? "" : " ", unit.c_str());
    }
    return text.data();
}

std::int64_t points_in_tenths(double points) {
    constexpr double kBinary = 1e-6; // of a tenth, by which 0.1 * 696 may be short of 69.6
    return static_cast<std::int64_t>(std::floor(10 * points + kBinary));
}

std::string points_text(double points) {
    const auto tenths = points_in_tenths(points);
    return std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10);
}

} // namespace windlass
