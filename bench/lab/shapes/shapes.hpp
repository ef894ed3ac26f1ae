#pragma once
// Figures of shapes: where lines lie at some times, by several methods and settings side by side. The format
// is bench/schema/shapes.schema.json.

#include "bench/lab/case/case.hpp"
#include "bench/lab/case/table.hpp"

#include <functional>

namespace windlass::lab {

/// One line of a panel, drawn at each of its times.
struct ShapeRun {
    std::string name;
    const MethodEntry* method = nullptr;
    Case given;
    std::vector<double> times; ///< s, rising
};

struct ShapePanel {
    std::string title;
    std::vector<ShapeRun> runs;
};

struct ShapeFigure {
    std::string name, title;
    std::array<double, 2> x{0, 1}, z{0, 1}; ///< m, drawn from, to; one scale for both
    std::vector<ShapePanel> panels;
};

/// Throws exercise::ConfigError: file, JSON pointer, value, what is allowed.
std::vector<ShapeFigure> load_shapes(const std::filesystem::path& file);

/// A line at one time, and what can be told of it.
struct LineShape {
    std::string panel, run;
    double time = 0;                    ///< s
    double longest_link = 0;            ///< of its unstretched length, more
    double shortest_link = 0;           ///< of its unstretched length, less
    double nearest = 0;                 ///< m, of particles with another between them
    double sharpest = 0;                ///< degrees, largest bend
    double lowest = 0;                  ///< m, z
    std::vector<double> x = {}, z = {}; ///< m, node by node from the lower end
};

/// Runs a figure. Throws std::invalid_argument when a method cannot do a case.
std::vector<LineShape> run_shapes(const ShapeFigure& figure);

/// As CSV, a line for each shape, its places as numbers with spaces between; and back. Throw as
/// write_text_rows() and read_text_rows() do.
void write_shapes(const std::filesystem::path& file, const std::vector<LineShape>& shapes,
                  const Notes& notes);
std::vector<LineShape> read_shapes(const std::filesystem::path& file);

/// Seen from the side, with the obstacles. Throws std::runtime_error naming the file when it cannot be
/// written.
void draw_shapes(const std::filesystem::path& file, const ShapeFigure& figure,
                 const std::vector<LineShape>& shapes);

} // namespace windlass::lab
