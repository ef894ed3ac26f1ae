#include "recorder/debrief/scale.hpp"

#include "station/format.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace windlass::debrief {

namespace {

double distance(Spot at, Spot from, Spot to) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    if (length == 0) return std::hypot(at.x - from.x, at.y - from.y);
    return std::abs(dx * (at.y - from.y) - dy * (at.x - from.x)) / length;
}

} // namespace

double round_step(double length, int parts) {
    if (!(length > 0)) return 1;
    const double least = length / parts, power = std::pow(10, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= least * (1 - 1e-9)) return step * power;
    return 10 * power;
}

double round_time_step(double seconds, int parts) {
    if (seconds < parts) return round_step(seconds, parts);
    constexpr std::array<double, 13> steps{1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600};
    for (const double step : steps)
        if (seconds <= step * parts) return step;
    return 3600 * round_step(seconds / 3600, parts);
}

std::string figure(double value, double step) {
    return station::number(value, step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

std::string time_figure(double seconds, double step) {
    if (seconds <= -step / 2) return '-' + time_figure(-seconds, step);
    if (step >= 1) return station::clock(seconds + 1e-6);
    const double whole = std::floor(seconds + 1e-6);
    return fmt::format("{}.{:.0f}", station::clock(whole), std::abs(seconds - whole) * 10);
}

std::vector<Spot> simplified(const std::vector<Spot>& line, double off) {
    if (line.size() < 3) return line;
    std::vector<bool> kept(line.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        double worst = off;
        std::size_t at = 0;
        for (std::size_t i = from + 1; i < to; ++i)
            if (const double far = distance(line[i], line[from], line[to]); far > worst) {
                worst = far;
                at = i;
            }
        if (at == 0) continue;
        kept[at] = true;
        open.emplace_back(from, at);
        open.emplace_back(at, to);
    }
    std::vector<Spot> left;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (kept[i]) left.push_back(line[i]);
    return left;
}

std::string path_of(const std::vector<Spot>& line) {
    if (line.size() < 2) return {};
    std::string path;
    for (const Spot& spot : line)
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", spot.x, spot.y);
    return path;
}

} // namespace windlass::debrief
