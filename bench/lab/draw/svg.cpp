#include "bench/lab/draw/svg.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace windlass::lab {
namespace {

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

std::string style(const Stroke& stroke) {
    return fmt::format(R"(stroke="{}" stroke-width="{:.3g}"{})", stroke.colour, stroke.width,
                       stroke.dash.empty() ? "" : fmt::format(R"( stroke-dasharray="{}")", stroke.dash));
}

} // namespace

Svg::Svg(double width, double height) : width_(width), height_(height) {}

void Svg::line(Point from, Point to, const Stroke& stroke) {
    body_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", from.x,
                         from.y, to.x, to.y, style(stroke));
}

void Svg::curve(const std::vector<Point>& points, const Stroke& stroke) {
    if (points.empty()) return;
    body_ += "<polyline points=\"";
    for (const Point& p : points)
        body_ += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
    body_.back() = '"';
    body_ += fmt::format(" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", style(stroke));
}

void Svg::dot(Point at, double radius, const std::string& colour) {
    body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>\n", at.x, at.y,
                         radius, colour);
}

void Svg::box(Point corner, double width, double height, const std::string& fill) {
    body_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
                         corner.x, corner.y, width, height, fill);
}

void Svg::text(Point at, const std::string& words, const Lettering& lettering) {
    body_ +=
        fmt::format(
            R"(<text x="{0:.1f}" y="{1:.1f}" font-size="{2:.3g}" text-anchor="{3}" fill="{4}"{5}{6}>{7}</text>)",
            at.x, at.y, lettering.size, lettering.anchor, lettering.colour,
            lettering.bold ? " font-weight=\"bold\"" : "",
            lettering.upright ? fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", at.x, at.y) : "",
            escaped(words)) +
        '\n';
}

std::string Svg::document() const {
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                       "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"Helvetica, Arial, sans-serif\">\n"
                       "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
                       width_, height_) +
           body_ + "</svg>\n";
}

void Svg::save(const std::filesystem::path& file) const {
    std::ofstream out(file);
    out << document();
    out.close();
    if (!out) throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(errno));
}

} // namespace windlass::lab
