#include "bench/lab/shapes/shapes.hpp"

#include "bench/lab/draw/chart.hpp"
#include "bench/methods/pbd_constraints.hpp"
#include "common/json_file.hpp"
#include "common/json_schema.hpp"
#include "embedded/shapes_schema.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::lab {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> kHeadings{"panel",         "line",      "time_s",       "longest_link",
                                         "shortest_link", "nearest_m", "sharpest_deg", "lowest_m",
                                         "x_m",           "z_m"};

ShapeRun read_run(const Json& given, const Json& panel, const std::string& at,
                  const std::filesystem::path& file) {
    ShapeRun run;
    run.name = given.at("name");
    run.method = find_method(given.value("method", "pbd"));
    if (run.method == nullptr)
        throw ConfigError(fmt::format("{}: {}/method: {} is not allowed: a method of chain_lab list",
                                      file.string(), at, given.at("method").dump()));
    std::vector<std::string> set = panel.value("set", std::vector<std::string>());
    for (const std::string& one : given.value("set", std::vector<std::string>()))
        set.push_back(one);
    run.given = load_case(file.parent_path() / panel.at("case").get<std::string>(), set);
    run.times = given.contains("at") ? given.at("at").get<std::vector<double>>()
                                     : panel.at("at").get<std::vector<double>>();
    if (!std::ranges::is_sorted(run.times))
        throw ConfigError(fmt::format("{}: {}/at: {} is not allowed: times that rise", file.string(), at,
                                      Json(run.times).dump()));
    return run;
}

LineShape measure(const std::string& panel, const ShapeRun& run, const Method& method, double time) {
    LineShape shape{.panel = panel, .run = run.name, .time = time};
    const int links = method.links();
    const double rest = run.given.problem.length / links;
    Field places(links + 1);
    shape.lowest = shape.nearest = 1e300;
    for (int i = 0; i <= links; ++i) {
        const Vec3 place = method.position(i);
        places.set(i, place);
        shape.x.push_back(place.x());
        shape.z.push_back(place.z());
        shape.lowest = std::min(shape.lowest, place.z());
        if (i > 0) {
            const double strain = (place - places.at(i - 1)).norm() / rest - 1;
            shape.longest_link = std::max(shape.longest_link, strain);
            shape.shortest_link = std::max(shape.shortest_link, -strain);
        }
        for (int j = 0; j + 2 <= i; ++j)
            shape.nearest = std::min(shape.nearest, (place - places.at(j)).norm());
    }
    for (int i = 1; i < links; ++i)
        shape.sharpest = std::max(shape.sharpest, 180 / std::numbers::pi * bend_angle(places, i));
    return shape;
}

std::string list_of(const std::vector<double>& values) {
    std::string cell;
    for (const double value : values)
        cell += fmt::format("{}{:g}", cell.empty() ? "" : " ", std::round(1000 * value) / 1000 + 0.0);
    return cell;
}

/// The same with points between, so that only what is outside the axes is cut off.
std::vector<Point> dense(const std::vector<Point>& points, const ShapeFigure& figure) {
    const double piece = (figure.x[1] - figure.x[0]) / 400;
    std::vector<Point> more;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) {
            const Point a = points[i - 1], b = points[i];
            const int pieces = static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / piece);
            for (int k = 1; k < pieces; ++k)
                more.push_back({a.x + (b.x - a.x) * k / pieces, a.y + (b.y - a.y) * k / pieces});
        }
        more.push_back(points[i]);
    }
    return more;
}

/// What of the obstacles is seen from the side: edges of triangles, and planes as far as the axes go.
Curve seen(const Obstacle& obstacle, const ShapeFigure& figure) {
    Curve curve{.name = "", .points = {}, .colour = "#999999", .width = 2};
    if (!obstacle.is_plane()) {
        for (const std::array<int, 3>& triangle : obstacle.triangles)
            for (const int corner : {0, 1, 2, 0})
                curve.points.push_back(
                    {obstacle.corners[triangle[corner]].x(), obstacle.corners[triangle[corner]].z()});
        curve.points = dense(curve.points, figure);
        return curve;
    }
    const Vec3& n = obstacle.normal;
    if (std::abs(n.z()) > 1e-6)
        for (const double x : figure.x)
            curve.points.push_back({x, obstacle.point.z() - n.x() / n.z() * (x - obstacle.point.x())});
    curve.points = dense(curve.points, figure);
    return curve;
}

} // namespace

std::vector<ShapeFigure> load_shapes(const std::filesystem::path& file) {
    static const JsonSchema schema(embedded::shapes_schema);
    const Json document = read_json(file);
    schema.check(document, file.string());
    std::vector<ShapeFigure> figures;
    for (const Json& given : document.at("figures")) {
        ShapeFigure figure{.name = given.at("name"), .title = given.at("title"), .panels = {}};
        figure.x = given.at("x");
        figure.z = given.at("z");
        for (const Json& one : given.at("panels")) {
            ShapePanel panel{.title = one.at("title"), .runs = {}};
            const std::string at = fmt::format("/figures/{}/panels/{}", figures.size(), figure.panels.size());
            for (const Json& line : one.at("lines"))
                panel.runs.push_back(
                    read_run(line, one, fmt::format("{}/lines/{}", at, panel.runs.size()), file));
            figure.panels.push_back(std::move(panel));
        }
        figures.push_back(std::move(figure));
    }
    return figures;
}

std::vector<LineShape> run_shapes(const ShapeFigure& figure) {
    std::vector<LineShape> shapes;
    for (const ShapePanel& panel : figure.panels)
        for (const ShapeRun& run : panel.runs) {
            const Case& given = run.given;
            const auto method =
                make_method(*run.method, given.problem, given.links, given.dt, given.settings);
            for (const double time : run.times) {
                while (method->time() < time - 0.5 * given.dt)
                    method->step();
                shapes.push_back(measure(panel.title, run, *method, time));
            }
        }
    return shapes;
}

void write_shapes(const std::filesystem::path& file, const std::vector<LineShape>& shapes,
                  const Notes& notes) {
    TextRows rows;
    for (const LineShape& s : shapes) {
        std::vector<std::string> row{s.panel, s.run};
        for (const double figure : {s.time, s.longest_link, s.shortest_link, s.nearest, s.sharpest, s.lowest})
            row.push_back(fmt::format("{:.3g}", figure));
        row.push_back(list_of(s.x));
        row.push_back(list_of(s.z));
        rows.push_back(std::move(row));
    }
    write_text_rows(file, kHeadings, rows, notes);
}

std::vector<LineShape> read_shapes(const std::filesystem::path& file) {
    std::vector<LineShape> shapes;
    std::size_t count = 0;
    for (const std::vector<std::string>& cells : read_text_rows(file, kHeadings)) {
        const std::string at = row_place(file, ++count);
        const auto value = [&](std::size_t k) { return number_in(cells[k], at); };
        shapes.push_back({cells[0], cells[1], value(2), value(3), value(4), value(5), value(6), value(7),
                          numbers_in(cells[8], at), numbers_in(cells[9], at)});
        if (shapes.back().x.size() != shapes.back().z.size())
            throw ConfigError(at + ": as many z_m as x_m are allowed");
    }
    return shapes;
}

void draw_shapes(const std::filesystem::path& file, const ShapeFigure& figure,
                 const std::vector<LineShape>& shapes) {
    constexpr double kAcross = 250, kRoom = 120, kAround = 70 + kRoom, kAbove = 28 + 46, kHead = 34;
    const double width = kAcross + kAround;
    const double height = kAcross * (figure.z[1] - figure.z[0]) / (figure.x[1] - figure.x[0]) + kAbove;
    Svg svg(width * static_cast<double>(figure.panels.size()), kHead + height);
    svg.text({14, 20}, figure.title, {.size = 15, .bold = true});
    for (std::size_t k = 0; k < figure.panels.size(); ++k) {
        const ShapePanel& shown = figure.panels[k];
        Panel panel{.title = shown.title,
                    .x = {"x, m", false, figure.x[0], figure.x[1]},
                    .y = {"z, m", false, figure.z[0], figure.z[1]},
                    .curves = {},
                    .label_room = kRoom};
        for (const Obstacle& obstacle : shown.runs.front().given.problem.obstacles)
            panel.curves.push_back(seen(obstacle, figure));
        int number = 0;
        for (const ShapeRun& run : shown.runs)
            for (const LineShape& shape : shapes) {
                if (shape.panel != shown.title || shape.run != run.name) continue;
                Curve curve{.name = run.name,
                            .points = {},
                            .colour = shown.runs.size() > 1 && run.method->name == "production"
                                          ? "#777777"
                                          : colour_of(number++),
                            .marked = false};
                if (run.times.size() > 1)
                    curve.name += fmt::format("{}{:g} s", run.name.empty() ? "" : ", ", shape.time);
                for (std::size_t i = 0; i < shape.x.size(); ++i)
                    curve.points.push_back({shape.x[i], shape.z[i]});
                curve.points = dense(curve.points, figure);
                panel.curves.push_back(std::move(curve));
            }
        draw(svg, panel, {width * static_cast<double>(k), kHead}, width, height);
    }
    svg.save(file);
}

} // namespace windlass::lab
