#include "bench/lab/draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace windlass::lab {
namespace {

constexpr int kLetter = 12; ///< px, unless a text says otherwise

std::string escaped(const std::string& words) {
    std::string text;
    for (const char c : words) {
        if (c == '&')
            text += "&amp;";
        else if (c == '<')
            text += "&lt;";
        else if (c == '>')
            text += "&gt;";
        else
            text += c;
    }
    return text;
}

/// To a tenth of a pixel.
std::string px(double value) {
    const double tenths = std::round(10 * value);
    return fmt::format("{:g}", tenths == 0 ? 0 : tenths / 10);
}

std::string place(Point at) {
    const std::string y = px(at.y);
    return px(at.x) + (y.front() == '-' ? "" : " ") + y;
}

std::string stroked(const Stroke& stroke) {
    std::string text = fmt::format(R"( stroke="{}")", stroke.colour);
    if (stroke.width != 1) text += fmt::format(R"( stroke-width="{:.3g}")", stroke.width);
    if (!stroke.dash.empty()) text += fmt::format(R"( stroke-dasharray="{}")", stroke.dash);
    return text;
}

std::string lettered(const Lettering& lettering) {
    std::string text = fmt::format(R"( fill="{}")", lettering.colour);
    if (lettering.size != kLetter) text += fmt::format(R"( font-size="{:.3g}")", lettering.size);
    if (lettering.anchor != "start") text += fmt::format(R"( text-anchor="{}")", lettering.anchor);
    if (lettering.bold) text += R"( font-weight="bold")";
    return text;
}

double distance_from(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, size = dx * dx + dy * dy;
    const double along = size > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / size, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

} // namespace

std::vector<Point> simplified(const std::vector<Point>& points, double off) {
    if (points.size() < 3) return points;
    // Douglas and Peucker (1973): the farthest point from a chord stays, and both sides go on by themselves.
    std::vector<bool> stays(points.size(), false);
    stays.front() = stays.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t far = first;
        double most = off;
        for (std::size_t i = first + 1; i < last; ++i)
            if (const double away = distance_from(points[i], points[first], points[last]); away > most)
                far = i, most = away;
        if (far == first) continue;
        stays[far] = true;
        open.insert(open.end(), {{first, far}, {far, last}});
    }
    std::vector<Point> left;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (stays[i]) left.push_back(points[i]);
    return left;
}

Svg::Svg(double width, double height) : width_(width), height_(height) {}

void Svg::add(const std::string& element) {
    constexpr std::size_t kLine = 600; // letters: lines that a reader and a diff can bear
    if (body_.size() > line_ && body_.size() + element.size() > line_ + kLine) {
        body_ += '\n';
        line_ = body_.size();
    }
    body_ += element;
}

void Svg::curve(const std::vector<Point>& points, const Stroke& stroke) {
    curves({points}, stroke);
}

void Svg::curves(const std::vector<std::vector<Point>>& all, const Stroke& stroke) {
    constexpr double kOff = 0.15; // px
    std::string path;
    for (const std::vector<Point>& points : all) {
        std::string last;
        for (const Point& p : simplified(points, kOff)) {
            std::string next = place(p);
            if (next == last) continue;
            if (last.empty())
                path += 'M';
            else if (next.front() != '-')
                path += ' ';
            path += last = std::move(next);
        }
    }
    if (!path.empty()) add(fmt::format("<path d=\"{}\"{}/>", path, stroked(stroke)));
}

void Svg::dots(const std::vector<Point>& at, double radius, const std::string& colour) {
    constexpr double kSame = 0.5; // px
    std::string path;
    std::vector<Point> drawn;
    for (const Point& p : at) {
        if (std::ranges::any_of(drawn, [&](Point q) { return std::hypot(p.x - q.x, p.y - q.y) < kSame; }))
            continue;
        drawn.push_back(p);
        path += 'M' + place(p) + "h0";
    }
    if (!path.empty())
        add(fmt::format("<path d=\"{}\" stroke-linecap=\"round\"{}/>", path,
                        stroked({.colour = colour, .width = 2 * radius, .dash = {}})));
}

void Svg::boxes(const std::vector<Point>& corners, double width, double height, const std::string& fill) {
    std::string path;
    for (const Point& p : corners)
        path += fmt::format("M{}h{}v{}h-{}z", place(p), px(width), px(height), px(width));
    if (!path.empty()) add(fmt::format("<path d=\"{}\" fill=\"{}\"/>", path, fill));
}

void Svg::text(Point at, const std::string& words, const Lettering& lettering) {
    std::string turned;
    if (lettering.upright) turned = fmt::format(" transform=\"rotate(-90 {} {})\"", px(at.x), px(at.y));
    if (!words.empty())
        add(fmt::format(R"(<text x="{}" y="{}"{}{}>{}</text>)", px(at.x), px(at.y), lettered(lettering),
                        turned, escaped(words)));
}

void Svg::texts(const std::vector<std::pair<Point, std::string>>& words, const Lettering& lettering) {
    std::string group;
    for (const auto& [at, one] : words)
        if (!one.empty())
            group += fmt::format(R"(<text x="{}" y="{}">{}</text>)", px(at.x), px(at.y), escaped(one));
    if (!group.empty()) add(fmt::format("<g{}>{}</g>", lettered(lettering), group));
}

std::string Svg::document() const {
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                       "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"Helvetica, Arial, sans-serif\" "
                       "font-size=\"{2}\" fill=\"none\" stroke-linejoin=\"round\">\n"
                       "<path d=\"M0 0h{0:.0f}v{1:.0f}H0z\" fill=\"#fff\"/>\n",
                       width_, height_, kLetter) +
           body_ + "\n</svg>\n";
}

void Svg::save(const std::filesystem::path& file) const {
    std::ofstream out(file);
    out << document();
    out.close();
    if (!out) throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(errno));
}

} // namespace windlass::lab
