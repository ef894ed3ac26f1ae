#pragma once
// Charts of curves over two axes, each curve labelled where it ends.

#include "bench/lab/draw/svg.hpp"

namespace windlass::lab {

/// An axis. Limits that are equal are taken from the curves.
struct Axis {
    std::string label; ///< with its unit
    bool log = false;
    double low = 0, high = 0;
};

/// One curve. On a log axis points that are not positive are left out.
struct Curve {
    std::string name;
    std::vector<Point> points;
    std::string colour;
    bool marked = false; ///< a dot at every point
    std::string dash = {};
    double width = 1.4; ///< px
};

/// A colour that differs from its neighbours' in print and for the colour-blind (Okabe and Ito 2008, and
/// darker ones); the same number gives the same colour.
std::string colour_of(int number);

/// One chart within a drawing.
struct Panel {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
    double label_room = 145; ///< px right of the axes, for the names of the curves
};

/// Draws it with its outer corner at the given place; its title alone when its curves have no points.
void draw(Svg& svg, const Panel& panel, Point corner, double width, double height);

} // namespace windlass::lab
