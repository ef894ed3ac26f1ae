#pragma once
// Drawings in SVG: what charts need, and no more. Units are pixels of 1/96 inch, y downwards.

#include <filesystem>
#include <string>
#include <vector>

namespace windlass::lab {

struct Point {
    double x = 0, y = 0;
};

/// A stroke.
struct Stroke {
    std::string colour = "#222";
    double width = 1;
    std::string dash; ///< SVG's stroke-dasharray, "" for a full line
};

/// A line of text.
struct Lettering {
    double size = 11;
    std::string anchor = "start"; ///< start, middle, end
    std::string colour = "#222";
    bool bold = false;
    bool upright = false; ///< turned to read from below
};

/// One drawing on white.
class Svg {
public:
    Svg(double width, double height);

    void line(Point from, Point to, const Stroke& stroke = {});
    void curve(const std::vector<Point>& points, const Stroke& stroke);
    void dot(Point at, double radius, const std::string& colour);
    void box(Point corner, double width, double height, const std::string& fill);
    void text(Point at, const std::string& words, const Lettering& lettering = {});

    /// The whole document.
    std::string document() const;
    /// Throws std::runtime_error naming the file when it cannot be written.
    void save(const std::filesystem::path& file) const;

private:
    double width_, height_;
    std::string body_;
};

} // namespace windlass::lab
