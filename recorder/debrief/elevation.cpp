#include "recorder/debrief/elevation.hpp"

#include "recorder/debrief/html.hpp"
#include "recorder/debrief/scale.hpp"
#include "station/format.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windlass::debrief {

namespace {

constexpr double kWidth = 720, kMargin = 8, kMostHeight = 230; // px
constexpr double kFoot = 22;                                   // px, for scale and directions
constexpr double kPlumb = 10;    // m: an anchor that is nearer than that hangs under the lip
constexpr double kShipSeen = 70; // m of her beside the lip
constexpr double kClear = 6;     // m round what is drawn
constexpr double kHullColumns = 160;
constexpr double kBedStep = 4;     // px
constexpr double kAnchorSeen = 13; // px at least

struct Point {
    double x = 0, y = 0, z = 0;
};

Point turned(const Quaternion& q, const Point& v) {
    // v + 2 u x (u x v + w v), u the vector part
    const Point c{q.y() * v.z - q.z() * v.y + q.w() * v.x, q.z() * v.x - q.x() * v.z + q.w() * v.y,
                  q.x() * v.y - q.y() * v.x + q.w() * v.z};
    return {v.x + 2 * (q.y() * c.z - q.z() * c.y), v.y + 2 * (q.z() * c.x - q.x() * c.z),
            v.z + 2 * (q.x() * c.y - q.y() * c.x)};
}

/// m along the plane and m over the water, to px.
struct Frame {
    double left = 0, right = 0, bottom = 0, top = 0; // m
    double scale = 1;                                // px per m, the same both ways

    void take(double along, double z, double around = kClear) {
        left = std::min(left, along - around);
        right = std::max(right, along + around);
        bottom = std::min(bottom, z - around);
        top = std::max(top, z + around);
    }
    void fit() {
        scale = std::min((kWidth - 2 * kMargin) / (right - left), kMostHeight / (top - bottom));
        const double more = (kWidth - 2 * kMargin) / scale - (right - left); // the strip is filled
        left -= more / 2;
        right += more / 2;
    }
    Spot at(double along, double z) const {
        return {kMargin + (along - left) * scale, kMargin + (top - z) * scale};
    }
    double foot() const { return kMargin + (top - bottom) * scale; }
    double height() const { return foot() + kFoot; }
};

/// Her outline in the plane: highest and lowest point of her plating in each column.
std::vector<Spot> silhouette(const SceneDescription& form, const ShipState& ship, const Elevation& plane,
                             const Frame& frame) {
    std::vector<std::pair<double, double>> corners; // along, z
    double least = 1e9, most = -1e9;
    for (const Point3f& corner : form.hull_corners()) {
        const Point at = turned(ship.attitude(), {corner.x(), corner.y(), corner.z()});
        const double along = plane.along(ship.position().x() + at.x, ship.position().y() + at.y);
        corners.emplace_back(along, ship.position().z() + at.z);
        least = std::min(least, along);
        most = std::max(most, along);
    }
    if (!(most > least)) return {};
    struct Column {
        double low = 1e9, high = -1e9;
    };
    std::vector<Column> columns(static_cast<std::size_t>(kHullColumns) + 1);
    const double wide = (most - least) / kHullColumns;
    const auto take = [&](std::size_t i, double z) {
        columns[i].low = std::min(columns[i].low, z);
        columns[i].high = std::max(columns[i].high, z);
    };
    const auto& triangles = form.hull_triangles();
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = triangles[i + k], b = triangles[i + (k + 1) % 3];
            if (a >= corners.size() || b >= corners.size()) return {};
            auto [from, z_from] = corners[a];
            auto [to, z_to] = corners[b];
            if (from > to) {
                std::swap(from, to);
                std::swap(z_from, z_to);
            }
            const auto first = static_cast<std::size_t>(std::ceil((from - least) / wide - 1e-9));
            for (std::size_t c = first;
                 c < columns.size() && least + wide * static_cast<double>(c) <= to + 1e-9; ++c) {
                const double t =
                    to > from ? (least + wide * static_cast<double>(c) - from) / (to - from) : 0.5;
                take(c, z_from + std::clamp(t, 0.0, 1.0) * (z_to - z_from));
            }
        }
    std::vector<Spot> above, below;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (columns[c].low > columns[c].high) continue;
        const double along = least + wide * static_cast<double>(c);
        above.push_back(frame.at(along, columns[c].high));
        below.push_back(frame.at(along, columns[c].low));
    }
    above = simplified(above, 0.4);
    below = simplified(below, 0.4);
    above.insert(above.end(), below.rbegin(), below.rend());
    return above;
}

std::string cable(const ChainState& chain, const Elevation& plane, const Frame& frame,
                  const TensionLimits& limits) {
    std::string svg;
    const auto& nodes = chain.nodes();
    for (std::size_t i = 0; i + 1 < nodes.size() && i < chain.tension().size();) {
        const int kind = tension_class(chain.tension()[i], limits);
        std::vector<Spot> line;
        const auto add = [&](std::size_t n) {
            line.push_back(frame.at(plane.along(nodes[n].x(), nodes[n].y()), nodes[n].z()));
        };
        add(i);
        for (; i + 1 < nodes.size() && i < chain.tension().size() &&
               tension_class(chain.tension()[i], limits) == kind;
             ++i)
            add(i + 1);
        svg += fmt::format("<path class=\"cable pull{}\" d=\"{}\"/>", kind, path_of(simplified(line, 0.2)));
    }
    return svg;
}

/// Shank, flukes and ring. Smaller than one sees, it is drawn larger from its ring on.
std::string anchor(const AnchorState& anchor, const Elevation& plane, const Frame& frame) {
    const Vec3 &ring = anchor.shackle(), &middle = anchor.position();
    const double size =
        1.7 * std::sqrt(std::pow(ring.x() - middle.x(), 2) + std::pow(ring.y() - middle.y(), 2) +
                        std::pow(ring.z() - middle.z(), 2)); // m, ring to crown, about
    const double seen = std::max(size, kAnchorSeen / frame.scale);
    const double along = plane.along(ring.x(), ring.y());
    // Axes of the anchor: x from crown to ring, the flukes turned towards -z by their angle.
    const auto place = [&](double x, double z) {
        const Point to = turned(anchor.attitude(), {x * seen, 0, z * seen});
        return frame.at(along + plane.along(plane.x + to.x, plane.y + to.y), ring.z() + to.z);
    };
    const Spot top = place(0, 0), crown = place(-1, 0);
    const double angle = anchor.fluke_angle();
    const Spot fluke = place(-1 + 0.65 * std::cos(angle), -0.65 * std::sin(angle));
    return fmt::format("<path class=\"anchor\" d=\"{}\"/><path class=\"fluke\" d=\"{}\"/>"
                       "<circle class=\"dot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\"/>",
                       path_of({top, crown}), path_of({crown, fluke}), crown.x, crown.y);
}

std::string bed(const SeabedDescription& ground, const Elevation& plane, const Frame& frame) {
    std::vector<Spot> line;
    const double step = kBedStep / frame.scale, edge = kMargin / frame.scale;
    for (double along = frame.left - edge; along <= frame.right + edge + step / 2; along += step)
        line.push_back(frame.at(along, bed_height(ground, plane.x + along * std::sin(plane.direction),
                                                  plane.y + along * std::cos(plane.direction))));
    line = simplified(line, 0.3);
    const std::string top = path_of(line);
    return fmt::format("<path class=\"ground\" d=\"{}V{:.1f}H{:.1f}z\"/><path class=\"bed\" d=\"{}\"/>", top,
                       frame.foot() + kMargin, line.front().x, top);
}

/// Scale and the direction that lies to the right.
std::string foot(const Frame& frame, const Elevation& plane) {
    const double metres = round_step((frame.right - frame.left) / 3, 2), y = frame.height() - 5;
    return fmt::format("<path class=\"zero\" d=\"M{0} {1:.1f}v5h{2:.1f}v-5\"/><text x=\"{3:.1f}\" "
                       "y=\"{4:.1f}\">{5:.0f} m, both ways</text><text x=\"{6}\" y=\"{4:.1f}\" "
                       "text-anchor=\"end\">to the right: {7}</text>",
                       kMargin, y - 6, metres * frame.scale, kMargin + metres * frame.scale + 6, y, metres,
                       kWidth - kMargin, station::bearing(plane.direction));
}

} // namespace

TensionLimits tension_limits(const std::vector<SceneAt>& scenes) {
    double largest = 20; // t
    for (const SceneAt& scene : scenes)
        for (const auto& chain : scene.chains)
            if (chain)
                for (const float each : chain->tension())
                    largest = std::max(largest, each / words::units::tonne);
    const double step = round_step(largest, 4) * words::units::tonne;
    return {step, 2 * step, 3 * step};
}

int tension_class(double tension, const TensionLimits& limits) {
    return static_cast<int>(std::ranges::count_if(limits, [&](double limit) { return tension >= limit; }));
}

double Elevation::along(double at_x, double at_y) const {
    return (at_x - x) * std::sin(direction) + (at_y - y) * std::cos(direction);
}

std::optional<Elevation> elevation_of(const SceneAt& scene, int side) {
    const auto& chain = scene.chains[static_cast<std::size_t>(side)];
    if (!scene.ship || !chain || chain->nodes().size() < 2) return std::nullopt;
    const Point3f &lip = chain->nodes().front(), &end = chain->nodes().back();
    const double east = end.x() - lip.x(), north = end.y() - lip.y();
    const bool led = std::hypot(east, north) > kPlumb;
    return Elevation{
        .x = lip.x(), .y = lip.y(), .direction = led ? std::atan2(east, north) : scene.ship->heading()};
}

double bed_height(const SeabedDescription& bed, double x, double y) {
    double z = -bed.depth() + std::tan(bed.slope()) *
                                  (std::sin(bed.slope_towards()) * x + std::cos(bed.slope_towards()) * y);
    const std::size_t columns = bed.columns(), rows = bed.rows();
    if (columns == 0 || rows == 0 || bed.heights().size() < columns * rows) return z;
    // Three neighbours on each axis, and their shares in a quadratic B-spline; beyond the edges it goes on.
    struct Neighbour {
        std::size_t place;
        double share;
    };
    const auto neighbours = [](double at, std::size_t count) {
        const double u = std::clamp(at, -1.0, static_cast<double>(count));
        const double middle = std::floor(u + 0.5), t = u - middle;
        const auto within = [&](double k) {
            return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(count - 1)));
        };
        return std::array<Neighbour, 3>{{{within(middle - 1), 0.5 * (0.5 - t) * (0.5 - t)},
                                         {within(middle), 0.75 - t * t},
                                         {within(middle + 1), 0.5 * (0.5 + t) * (0.5 + t)}}};
    };
    for (const auto& [row, up] : neighbours((y - bed.origin_y()) / bed.spacing(), rows))
        for (const auto& [column, across] : neighbours((x - bed.origin_x()) / bed.spacing(), columns))
            z += up * across * bed.heights()[row * columns + column];
    return z;
}

std::string elevation_svg(const Attempt& attempt, const SceneAt& scene, int side, const TensionLimits& limits,
                          std::size_t number, std::string_view title, std::string_view words) {
    const auto plane = elevation_of(scene, side);
    if (!plane) return {};
    Frame frame;
    frame.take(0, scene.chains[static_cast<std::size_t>(side)]->nodes().front().z(), 12);
    for (const auto& chain : scene.chains)
        if (chain)
            for (const Point3f& node : chain->nodes())
                frame.take(plane->along(node.x(), node.y()), node.z());
    if (attempt.bed) frame.take(0, bed_height(*attempt.bed, plane->x, plane->y));
    // As much of her as there is room for, on the side of the lip where she is.
    const double ship = plane->along(scene.ship->position().x(), scene.ship->position().y());
    frame.take(std::clamp(ship, -kShipSeen, kShipSeen), 0);
    frame.fit();
    std::string svg =
        fmt::format("<rect class=\"water\" x=\"0\" y=\"{0:.1f}\" width=\"{1:.0f}\" height=\"{2:.1f}\"/>",
                    frame.at(0, 0).y, kWidth, frame.foot() + kMargin - frame.at(0, 0).y);
    if (attempt.ship_form)
        if (const auto hull = silhouette(*attempt.ship_form, *scene.ship, *plane, frame); !hull.empty())
            svg += fmt::format("<path class=\"plating\" d=\"{}z\"/>", path_of(hull));
    svg += fmt::format("<path class=\"surface\" d=\"M0 {:.1f}h{:.0f}\"/>", frame.at(0, 0).y, kWidth);
    if (attempt.bed) svg += bed(*attempt.bed, *plane, frame);
    for (std::size_t i = 0; i < scene.chains.size(); ++i) {
        if (scene.chains[i]) svg += cable(*scene.chains[i], *plane, frame, limits);
        if (scene.anchors[i] && scene.chains[i]) svg += anchor(*scene.anchors[i], *plane, frame);
    }
    return fmt::format(
        "<svg role=\"img\" aria-labelledby=\"scene{0}-title scene{0}-words\" viewBox=\"0 0 {1:.0f} {2:.0f}\" "
        "width=\"{1:.0f}\" height=\"{2:.0f}\"><title id=\"scene{0}-title\">{3}</title><desc "
        "id=\"scene{0}-words\">{4}</desc><clipPath id=\"scene{0}-strip\"><rect width=\"{1:.0f}\" "
        "height=\"{5:.1f}\"/></clipPath><g clip-path=\"url(#scene{0}-strip)\">{6}</g>{7}</svg>",
        number, kWidth, frame.height(), escaped(title), escaped(words), frame.foot() + kMargin, svg,
        foot(frame, *plane));
}

std::string tension_key(const TensionLimits& limits) {
    std::string svg;
    for (int kind = 0; kind < 4; ++kind) {
        const double x = 8 + 178 * kind;
        const std::string words = kind < 3
                                      ? "below " + station::tonnes(limits[static_cast<std::size_t>(kind)])
                                      : station::tonnes(limits.back()) + " or more";
        svg += fmt::format("<path class=\"cable pull{0}\" d=\"M{1:.0f} 10h34\"/><text x=\"{2:.0f}\" "
                           "y=\"14\">{3}</text>",
                           kind, x, x + 40, words);
    }
    return "<svg role=\"img\" aria-labelledby=\"pull-title pull-words\" viewBox=\"0 0 720 20\" width=\"720\" "
           "height=\"20\"><title id=\"pull-title\">Key</title><desc id=\"pull-words\">Tension of the cable "
           "by the width and the colour of its line</desc>" +
           svg + "</svg>";
}

} // namespace windlass::debrief
