#include "bench/lab/draw/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace windlass::lab {
namespace {

constexpr double kLeft = 70, kTop = 28, kBottom = 46, kLetter = 12;

/// An axis with its limits known, laid over pixels.
class Scale {
public:
    Scale(Axis axis, const std::vector<Curve>& curves, double Point::*part, double from, double to)
        : log_(axis.log), from_(from), to_(to) {
        if (axis.low == axis.high) {
            axis.low = std::numeric_limits<double>::infinity(), axis.high = -axis.low;
            for (const Curve& curve : curves)
                for (const Point& p : curve.points)
                    if (std::isfinite(p.*part) && (!log_ || p.*part > 0)) {
                        axis.low = std::min(axis.low, p.*part);
                        axis.high = std::max(axis.high, p.*part);
                    }
            if (!(axis.low <= axis.high)) axis.low = axis.high = 1; // nothing to draw
            if (log_) {
                axis.low = round_below(axis.low);
                axis.high = 1 / round_below(1 / axis.high);
            }
            if (axis.low == axis.high) axis.high = log_ ? 10 * axis.low : axis.low + 1;
        }
        low_ = axis.low, high_ = axis.high;
    }

    bool holds(double v) const {
        return std::isfinite(v) && (!log_ || v > 0) && v >= low_ * (log_ ? 0.999 : 1) - (log_ ? 0 : 1e-9) &&
               v <= high_ * (log_ ? 1.001 : 1) + (log_ ? 0 : 1e-9);
    }
    double at(double v) const {
        const double share = log_ ? std::log(v / low_) / std::log(high_ / low_) : (v - low_) / (high_ - low_);
        return from_ + share * (to_ - from_);
    }
    std::vector<double> ticks() const {
        std::vector<double> values;
        if (log_) {
            const int first = int(std::floor(std::log10(low_) + 1e-9)),
                      last = int(std::floor(std::log10(high_) + 1e-9));
            const int every = std::max(1, (last - first + 7) / 8);
            const bool close = std::log10(high_ / low_) < 2.5; // room for what is between the powers of ten
            for (int k = first; k <= last; k += every)
                for (const double part : {1.0, 2.0, 5.0})
                    if (const double v = part * std::pow(10, k); (close || part == 1) && holds(v))
                        values.push_back(v);
            return values;
        }
        const double rough = (high_ - low_) / 5, power = std::pow(10, std::floor(std::log10(rough)));
        const double step = power * (rough / power > 5   ? 10
                                     : rough / power > 2 ? 5
                                     : rough / power > 1 ? 2
                                                         : 1);
        for (double v = std::ceil(low_ / step - 1e-9) * step; v <= high_ + 1e-9 * step; v += step)
            values.push_back(std::abs(v) < 1e-9 * step ? 0 : v);
        return values;
    }

private:
    /// 1, 2 or 5 times a power of ten.
    static double round_below(double v) {
        const double power = std::pow(10, std::floor(std::log10(v) + 1e-9));
        const double part = v / power * (1 + 1e-9);
        return power * (part >= 5 ? 5 : part >= 2 ? 2 : 1);
    }

    bool log_;
    double low_ = 0, high_ = 1, from_, to_;
};

/// A number at an axis: powers of ten from 10000 on, and below 0.001, are short.
std::string tick(double v) {
    const bool far = v != 0 && (std::abs(v) >= 1e4 || std::abs(v) < 1e-3);
    if (!far) return fmt::format("{:g}", v);
    const int power = static_cast<int>(std::floor(std::log10(std::abs(v)) + 1e-9));
    return fmt::format("{:g}e{}", v / std::pow(10, power), power);
}

/// A name beside the end of its curve.
struct Label {
    Point end;
    const Curve* curve;
    double y;
};

/// Moves labels apart, keeping their order and within the limits as far as there is room.
void spread(std::vector<Label>& labels, double top, double bottom) {
    std::sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
    for (std::size_t i = 1; i < labels.size(); ++i)
        labels[i].y = std::max(labels[i].y, labels[i - 1].y + kLetter + 1);
    double limit = bottom;
    for (std::size_t i = labels.size(); i-- > 0; limit = labels[i].y - kLetter - 1)
        labels[i].y = std::min(labels[i].y, limit);
    for (std::size_t i = 0; i < labels.size(); ++i)
        labels[i].y = std::max(labels[i].y, top + double(i) * (kLetter + 1));
}

void draw_axes(Svg& svg, const Panel& panel, const Scale& x, const Scale& y, Point low, Point high) {
    const Lettering small{.size = kLetter, .anchor = "middle"};
    std::vector<std::vector<Point>> grid;
    for (const double v : x.ticks())
        grid.push_back({{x.at(v), low.y}, {x.at(v), high.y}});
    for (const double v : y.ticks())
        grid.push_back({{low.x, y.at(v)}, {high.x, y.at(v)}});
    svg.curves(grid, {"#ddd", 0.7, ""});
    std::vector<std::pair<Point, std::string>> along, up;
    for (const double v : x.ticks())
        along.emplace_back(Point{x.at(v), low.y + 15}, tick(v));
    for (const double v : y.ticks())
        up.emplace_back(Point{low.x - 5, y.at(v) + 4}, tick(v));
    svg.texts(along, small);
    svg.texts(up, {.size = kLetter, .anchor = "end"});
    svg.curve({{low.x, high.y}, low, {high.x, low.y}}, {"#222", 1, ""});
    svg.text({0.5 * (low.x + high.x), low.y + 34}, panel.x.label, small);
    svg.text({low.x - 52, 0.5 * (low.y + high.y)}, panel.y.label,
             {.size = kLetter, .anchor = "middle", .upright = true});
    svg.text({low.x, high.y - 9}, panel.title, {.size = 14, .bold = true});
}

} // namespace

std::string colour_of(int number) {
    static constexpr std::array colours{"#d55e00", "#0072b2", "#009e73", "#cc79a7", "#8a6d00", "#56b4e9",
                                        "#000000", "#7b3fa0", "#8c1d18", "#4d7c0f", "#e69f00", "#5b6770"};
    return colours[std::size_t(number) % colours.size()];
}

void draw(Svg& svg, const Panel& panel, Point corner, double width, double height) {
    const Point low{corner.x + kLeft, corner.y + height - kBottom};
    const Point high{corner.x + width - panel.label_room, corner.y + kTop};
    const Scale x(panel.x, panel.curves, &Point::x, low.x, high.x);
    const Scale y(panel.y, panel.curves, &Point::y, low.y, high.y);
    const bool empty = std::all_of(panel.curves.begin(), panel.curves.end(),
                                   [](const Curve& curve) { return curve.points.empty(); });
    if (empty) {
        svg.text({low.x, high.y - 9}, panel.title + ": nothing to show", {.size = 14, .colour = "#777"});
        return;
    }
    draw_axes(svg, panel, x, y, low, high);

    std::vector<Label> labels;
    for (const Curve& curve : panel.curves) {
        std::vector<Point> points;
        for (const Point& p : curve.points)
            if (x.holds(p.x) && y.holds(p.y)) points.push_back({x.at(p.x), y.at(p.y)});
        if (points.empty()) continue;
        svg.curve(points, {curve.colour, curve.width, curve.dash});
        if (curve.marked) svg.dots(points, 2, curve.colour);
        const Point end = *std::max_element(points.begin(), points.end(),
                                            [](const Point& a, const Point& b) { return a.x < b.x; });
        if (!curve.name.empty()) labels.push_back({end, &curve, end.y});
    }
    spread(labels, high.y, low.y);
    for (const Label& label : labels) {
        svg.curve({label.end, {high.x + 2, label.end.y}, {high.x + 12, label.y}},
                  {label.curve->colour, 0.5, "1 2"});
        svg.text({high.x + 14, label.y + 4}, label.curve->name,
                 {.size = kLetter, .colour = label.curve->colour});
    }
}

} // namespace windlass::lab
