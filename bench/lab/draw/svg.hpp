#pragma once
// Drawings in SVG: what charts need, and no more. Units are pixels of 1/96 inch, y downwards. Kept small: one
// path for many strokes, places to a tenth of a pixel, no points that a pixel does not show.

#include <filesystem>
#include <string>
#include <utility>
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

    void curve(const std::vector<Point>& points, const Stroke& stroke);
    /// Several curves in one stroke.
    void curves(const std::vector<std::vector<Point>>& all, const Stroke& stroke);
    /// Points that lie on one another are drawn once.
    void dots(const std::vector<Point>& at, double radius, const std::string& colour);
    /// Boxes of one size with their upper left corners there.
    void boxes(const std::vector<Point>& corners, double width, double height, const std::string& fill);
    void box(Point corner, double width, double height, const std::string& fill) {
        boxes({corner}, width, height, fill);
    }
    void text(Point at, const std::string& words, const Lettering& lettering = {});

    /// Several words alike.
    void texts(const std::vector<std::pair<Point, std::string>>& words, const Lettering& lettering);

    /// The whole document.
    std::string document() const;
    /// Throws std::runtime_error naming the file when it cannot be written.
    void save(const std::filesystem::path& file) const;

private:
    void add(const std::string& element);

    double width_, height_;
    std::string body_;
    std::size_t line_ = 0; ///< where the last line of body_ begins
};

/// The same line without points that lie within off (px) of what is left.
std::vector<Point> simplified(const std::vector<Point>& points, double off);

} // namespace windlass::lab
