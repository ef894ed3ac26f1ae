#include "recorder/debrief/plot.hpp"

#include "recorder/debrief/html.hpp"
#include "recorder/debrief/scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace windlass::debrief {

namespace {

// px. An A4 page has 680 of them between its margins.
constexpr double kWidth = 720, kLeft = 62, kRight = 12, kBelow = 36;
constexpr double kKeyRow = 16, kKeyColumn = 320, kFlagRow = 11, kStripRow = 16, kGhostBelow = 8;
constexpr int kFlagRows = 3;
constexpr double kNear = 0.25; // px, by which a line may be drawn beside its points

struct Style {
    const char *colour, *dashes;
};
/// Each 4.5:1 against white at least, and each with dashes of its own.
constexpr std::array<Style, 4> kStyles{
    {{"#00518f", ""}, {"#a33b00", "7 3"}, {"#00664b", "2 2.5"}, {"#6b3fa0", "9 3 2 3"}}};
/// Of a ghost: paler and wider, 3:1 against white at least, each with dashes that no line beside it has.
constexpr std::array<Style, 4> kGhosts{
    {{"#6f97bd", "6 4"}, {"#c08050", "2 4"}, {"#5f9f8c", "10 3"}, {"#9a80bd", "4 2 1 2"}}};
/// Of other attempts: dark grey, thin.
constexpr std::array<Style, 3> kOthers{{{"#444", "1.5 3"}, {"#444", "5 2 1 2"}, {"#444", "10 5"}}};

struct Frame {
    double left = kLeft, right = kWidth - kRight, top = 0, bottom = 0;
    double from = 0, to = 1, low = 0, high = 1;

    double x(double time) const { return left + (time - from) / (to - from) * (right - left); }
    double y(double value) const { return bottom - (value - low) / (high - low) * (bottom - top); }
};

void take_range(const Plot& plot, Frame& frame) {
    double low = plot.from_zero ? 0 : std::numeric_limits<double>::infinity(), high = -low;
    for (const PlotLine& line : plot.lines)
        for (const Sample& sample : line.samples)
            if (line.sets_axis && sample.time >= plot.from && sample.time <= plot.to) {
                low = std::min(low, sample.value);
                high = std::max(high, sample.value);
            }
    if (!(low <= high)) low = high = 0; // nothing is drawn
    if (high == low) high = low + 1;
    const double step = round_step(high - low, 5);
    frame.low = std::floor(low / step + 1e-9) * step;
    frame.high = std::ceil(high / step - 1e-9) * step;
    frame.from = plot.from;
    frame.to = std::max(plot.to, plot.from + 1);
}

double row_of(const PlotStrip& strip) {
    return strip.ghost.empty() ? kStripRow : kStripRow + kGhostBelow;
}

std::string key(const Plot& plot) {
    std::string svg;
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        const PlotLine& line = plot.lines[i];
        const double x = kLeft + kKeyColumn * static_cast<double>(i % 2);
        const double y = 11 + kKeyRow * std::floor(static_cast<double>(i) / 2);
        svg += key_of(line.name, line.style, line.whose, x, y);
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
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", frame.right,
                       labels + 15, escaped(plot.axis));
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
                               escaped(flag.label));
        row = (row + 1) % kFlagRows;
    }
    return fmt::format("<path class=\"flags\" d=\"{}\"/><g class=\"numbers\">{}</g>", lines, numbers);
}

std::string lines(const Plot& plot, const Frame& frame) {
    std::string behind, svg;
    for (const PlotLine& line : plot.lines) {
        std::vector<Spot> spots;
        for (const Sample& sample : line.samples)
            spots.push_back({frame.x(sample.time), frame.y(sample.value)});
        if (const std::string path = path_of(simplified(spots, kNear)); !path.empty())
            (line.whose == kGhost ? behind : svg) +=
                fmt::format("<path {} d=\"{}\"/>", stroke_of(line.style, line.whose), path);
    }
    return fmt::format(
        "<clipPath id=\"{0}-clip\"><rect x=\"{1:.1f}\" y=\"{2:.1f}\" width=\"{3:.1f}\" "
        "height=\"{4:.1f}\"/></clipPath><g class=\"lines\" clip-path=\"url(#{0}-clip)\">{5}</g>",
        plot.id, frame.left, frame.top - 1, frame.right - frame.left, frame.bottom - frame.top + 2,
        behind + svg);
}

/// Where samples are above one half, as a path.
std::string filled(const std::vector<Sample>& samples, const Frame& frame, double y) {
    std::string path;
    bool on = false;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const bool now = i + 1 < samples.size() && samples[i].value > 0.5;
        if (now && !on) path += fmt::format("M{:.1f} {:.1f}", frame.x(samples[i].time), y);
        if (on && !now) path += fmt::format("H{:.1f}", frame.x(samples[i].time));
        on = now;
    }
    return path;
}

/// Its row with the ghost's below it.
std::string strip(const PlotStrip& strip, const Frame& frame, double y) {
    std::string svg =
        fmt::format("<path class=\"off\" d=\"M{:.1f} {:.1f}H{:.1f}\"/><path class=\"on\" d=\"{}\"/>",
                    frame.left, y, frame.right, filled(strip.samples, frame, y));
    if (!strip.ghost.empty())
        svg +=
            fmt::format("<path class=\"ghost on\" d=\"{}\"/>", filled(strip.ghost, frame, y + kGhostBelow));
    return svg;
}

/// Their names at the left, and they themselves no farther than the plot goes.
std::string strips(const Plot& plot, const Frame& frame) {
    if (plot.strips.empty()) return {};
    std::string names, rows;
    double y = frame.bottom + 0.75 * kStripRow;
    for (const PlotStrip& each : plot.strips) {
        names += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", frame.left - 5,
                             y + 4, escaped(each.name));
        rows += strip(each, frame, y);
        y += row_of(each);
    }
    return fmt::format(
        "<clipPath id=\"{0}-strips\"><rect x=\"{1:.1f}\" y=\"{2:.1f}\" width=\"{3:.1f}\" "
        "height=\"{4:.1f}\"/></clipPath>{5}<g class=\"lines\" clip-path=\"url(#{0}-strips)\">{6}</g>",
        plot.id, frame.left, frame.bottom, frame.right - frame.left, y - frame.bottom, names, rows);
}

} // namespace

double width_of(double seconds, double from, double to) {
    return seconds / (to - from) * (kWidth - kRight - kLeft);
}

std::string stroke_of(std::size_t style, int whose) {
    const Style is = whose == kOwn     ? kStyles[style % kStyles.size()]
                     : whose == kGhost ? kGhosts[style % kGhosts.size()]
                                       : kOthers[static_cast<std::size_t>(whose - 1) % kOthers.size()];
    std::string attributes = fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"", is.colour,
                                         whose == kOwn     ? 1.6
                                         : whose == kGhost ? 2.2
                                                           : 1.2);
    if (*is.dashes != '\0') attributes += fmt::format(" stroke-dasharray=\"{}\"", is.dashes);
    if (whose == kGhost) attributes += " class=\"ghost\"";
    return attributes;
}

std::string key_of(const std::string& name, std::size_t style, int whose, double x, double y) {
    return fmt::format("<path {} d=\"M{:.0f} {:.0f}h34\"/><text{} x=\"{:.0f}\" y=\"{:.0f}\">{}</text>",
                       stroke_of(style, whose), x, y - 4, whose == kGhost ? " class=\"ghost\"" : "", x + 40,
                       y, escaped(name));
}

std::string svg_of(const Plot& plot) {
    Frame frame;
    take_range(plot, frame);
    frame.top = kKeyRow * std::ceil(static_cast<double>(plot.lines.size()) / 2) + 8 + kFlagRow * kFlagRows;
    frame.bottom = frame.top + plot.height;
    double below = 0;
    for (const PlotStrip& each : plot.strips)
        below += row_of(each);
    const double height = frame.bottom + below + kBelow;
    std::string svg = fmt::format(
        "<svg role=\"img\" aria-labelledby=\"{0}-title {0}-words\" viewBox=\"0 0 {1:.0f} {2:.0f}\" "
        "width=\"{1:.0f}\" height=\"{2:.0f}\"><title id=\"{0}-title\">{3}</title>"
        "<desc id=\"{0}-words\">{4}</desc>",
        plot.id, kWidth, height, escaped(plot.title), escaped(plot.sentence));
    svg += key(plot) + axes(plot, frame, frame.bottom + below + 16) + flags(plot, frame) +
           lines(plot, frame) + strips(plot, frame);
    return svg + "</svg>\n";
}

} // namespace windlass::debrief
