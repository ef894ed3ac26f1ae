#include "recorder/debrief/plot.hpp"

#include "recorder/debrief/html.hpp"
#include "recorder/debrief/scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::debrief {

namespace {

// px. An A4 page has 680 of them between its margins.
constexpr double kWidth = 720, kLeft = 62, kRight = 12, kHeight = 170, kBelow = 36;
constexpr double kKeyRow = 16, kKeyColumn = 320, kFlagRow = 11, kStripRow = 16;
constexpr int kFlagRows = 3;
constexpr double kNear = 0.25; // px, by which a line may be drawn beside its points

struct Style {
    const char *colour, *dashes;
};
/// Each 4.5:1 against white at least, and each with dashes of its own.
constexpr std::array<Style, 4> kStyles{
    {{"#00518f", ""}, {"#a33b00", "7 3"}, {"#00664b", "2 2.5"}, {"#6b3fa0", "9 3 2 3"}}};
/// Of other attempts: dark grey, thin.
constexpr std::array<Style, 3> kOthers{{{"#444", "1.5 3"}, {"#444", "5 2 1 2"}, {"#444", "10 5"}}};

struct Frame {
    double left = kLeft, right = kWidth - kRight, top = 0, bottom = 0;
    double from = 0, to = 1, low = 0, high = 1;

    double x(double time) const { return left + (time - from) / (to - from) * (right - left); }
    double y(double value) const { return bottom - (value - low) / (high - low) * (bottom - top); }
};

void take_range(const Plot& plot, Frame& frame) {
    double low = 0, high = 0;
    for (const PlotLine& line : plot.lines)
        for (const Sample& sample : line.samples)
            if (line.sets_axis && sample.time >= plot.from && sample.time <= plot.to) {
                low = std::min(low, sample.value);
                high = std::max(high, sample.value);
            }
    if (high == low) high = low + 1;
    const double step = round_step(high - low, 5);
    frame.low = std::floor(low / step + 1e-9) * step;
    frame.high = std::ceil(high / step - 1e-9) * step;
    frame.from = plot.from;
    frame.to = std::max(plot.to, plot.from + 1);
}

std::string key(const Plot& plot) {
    std::string svg;
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        const PlotLine& line = plot.lines[i];
        const double x = kLeft + kKeyColumn * static_cast<double>(i % 2);
        const double y = 11 + kKeyRow * std::floor(static_cast<double>(i) / 2);
        svg += fmt::format("<path {} d=\"M{:.0f} {:.0f}h34\"/><text x=\"{:.0f}\" y=\"{:.0f}\">{}</text>",
                           stroke_of(i, line.other), x, y - 4, x + 40, y, escaped(line.name));
    }
    return svg;
}

std::string axes(const Plot& plot, const Frame& frame, double labels) {
    std::string grid, svg;
    const double step = round_step(frame.high - frame.low, 5);
    for (double value = frame.low; value <= frame.high + step / 2; value += step) {
        grid += fmt::format("M{:.1f} {:.1f}H{:.1f}", frame.left, frame.y(value), frame.right);
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", frame.left - 5,
                           frame.y(value) + 4, figure(value, step));
    }
    const double span = frame.to - frame.from, time_step = round_time_step(span, 9);
    const double first = std::ceil(frame.from / time_step - 1e-9) * time_step;
    for (double time = first; time <= frame.to + 1e-6; time += time_step) {
        grid += fmt::format("M{:.1f} {:.1f}V{:.1f}", frame.x(time), frame.top, frame.bottom);
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", frame.x(time),
                           labels, time_figure(time, time_step));
    }
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">time of exercise, m:ss</text>",
                       frame.right, labels + 15);
    if (!plot.unit.empty())
        svg +=
            fmt::format("<text x=\"14\" y=\"{:.1f}\" transform=\"rotate(-90 14 {:.1f})\" "
                        "text-anchor=\"middle\">{}</text>",
                        (frame.top + frame.bottom) / 2, (frame.top + frame.bottom) / 2, escaped(plot.unit));
    return fmt::format("<path class=\"grid\" d=\"{}\"/>", grid) +
           (frame.low < 0 ? fmt::format("<path class=\"zero\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", frame.left,
                                        frame.y(0), frame.right)
                          : "") +
           svg;
}

std::string flags(const Plot& plot, const Frame& frame) {
    std::string lines, numbers;
    int row = 0;
    for (const PlotFlag& flag : plot.flags) {
        if (flag.time < frame.from || flag.time > frame.to) continue;
        const double x = frame.x(flag.time), y = frame.top - 4 - kFlagRow * row;
        lines += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, y + 2, frame.bottom);
        numbers += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", x, y,
                               flag.number);
        row = (row + 1) % kFlagRows;
    }
    return fmt::format("<path class=\"flags\" d=\"{}\"/><g class=\"numbers\">{}</g>", lines, numbers);
}

std::string lines(const Plot& plot, const Frame& frame) {
    std::string svg;
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        std::vector<Spot> spots;
        for (const Sample& sample : plot.lines[i].samples)
            spots.push_back({frame.x(sample.time), frame.y(sample.value)});
        if (const std::string path = path_of(simplified(spots, kNear)); !path.empty())
            svg += fmt::format("<path {} d=\"{}\"/>", stroke_of(i, plot.lines[i].other), path);
    }
    return fmt::format(
        "<clipPath id=\"{0}-clip\"><rect x=\"{1:.1f}\" y=\"{2:.1f}\" width=\"{3:.1f}\" "
        "height=\"{4:.1f}\"/></clipPath><g class=\"lines\" clip-path=\"url(#{0}-clip)\">{5}</g>",
        plot.id, frame.left, frame.top - 1, frame.right - frame.left, frame.bottom - frame.top + 2, svg);
}

std::string strip(const PlotStrip& strip, const Frame& frame, double y) {
    std::string filled;
    const auto& samples = strip.samples;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
        if (samples[i].value > 0.5)
            filled += fmt::format("M{:.1f} {:.1f}H{:.1f}", frame.x(samples[i].time), y,
                                  frame.x(samples[i + 1].time));
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text><path class=\"off\" "
                       "d=\"M{:.1f} {:.1f}H{:.1f}\"/><path class=\"on\" d=\"{}\"/>",
                       frame.left - 5, y + 4, escaped(strip.name), frame.left, y, frame.right, filled);
}

} // namespace

std::string stroke_of(std::size_t place, int other) {
    const Style style = other == 0 ? kStyles[place % kStyles.size()]
                                   : kOthers[static_cast<std::size_t>(other - 1) % kOthers.size()];
    std::string attributes =
        fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"", style.colour, other == 0 ? 1.6 : 1.2);
    if (*style.dashes != '\0') attributes += fmt::format(" stroke-dasharray=\"{}\"", style.dashes);
    return attributes;
}

std::string svg_of(const Plot& plot) {
    Frame frame;
    take_range(plot, frame);
    frame.top = kKeyRow * std::ceil(static_cast<double>(plot.lines.size()) / 2) + 8 + kFlagRow * kFlagRows;
    frame.bottom = frame.top + kHeight;
    const double strips = kStripRow * static_cast<double>(plot.strips.size());
    const double height = frame.bottom + strips + kBelow;
    std::string svg = fmt::format(
        "<svg role=\"img\" aria-labelledby=\"{0}-title {0}-words\" viewBox=\"0 0 {1:.0f} {2:.0f}\" "
        "width=\"{1:.0f}\" height=\"{2:.0f}\"><title id=\"{0}-title\">{3}</title>"
        "<desc id=\"{0}-words\">{4}</desc>",
        plot.id, kWidth, height, escaped(plot.title), escaped(plot.sentence));
    svg +=
        key(plot) + axes(plot, frame, frame.bottom + strips + 16) + flags(plot, frame) + lines(plot, frame);
    for (std::size_t i = 0; i < plot.strips.size(); ++i)
        svg += strip(plot.strips[i], frame, frame.bottom + kStripRow * (static_cast<double>(i) + 0.75));
    return svg + "</svg>\n";
}

} // namespace windlass::debrief
