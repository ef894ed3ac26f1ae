#include "server/physics/sea/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace windlass::physics {

namespace {

/// The steepest that the slope may be: 72 degrees.
constexpr double kSteepest = 3;

constexpr int kMaxPoints = 1000; ///< of a grid, each way

/// Three neighbours on one axis: their shares in a value (sum 1) and in its derivative.
struct Axis {
    std::array<int, 3> index;
    std::array<double, 3> share, change;
};

/// at: in points of the grid; count: of points.
Axis axis_around(double at, int count, double spacing) {
    const double last = count;
    const double u = at > -1 ? std::min(at, last) : -1; // a number that is none is taken for the edge
    const double middle = std::floor(u + 0.5), t = u - middle;
    const int i = static_cast<int>(middle);
    const auto within = [&](int k) { return std::clamp(k, 0, count - 1); };
    return {{within(i - 1), within(i), within(i + 1)},
            {0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)},
            {(t - 0.5) / spacing, -2 * t / spacing, (t + 0.5) / spacing}};
}

/// A field at a point, and its gradient.
struct Sample {
    double value = 0, x = 0, y = 0;
};

} // namespace

/// The nine points of the grid around a place.
struct Ground::Stencil {
    Axis x, y;
    int columns;

    template <class Field>
    Sample sample(const Field& field) const {
        Sample s;
        for (int r = 0; r < 3; ++r) {
            double value = 0, change = 0;
            for (int c = 0; c < 3; ++c) {
                const double f = field(static_cast<std::size_t>(y.index[r] * columns + x.index[c]));
                value += x.share[c] * f;
                change += x.change[c] * f;
            }
            s.value += y.share[r] * value;
            s.x += y.share[r] * change;
            s.y += y.change[r] * value;
        }
        return s;
    }
    template <class Field>
    double value(const Field& field) const {
        double sum = 0;
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                sum += y.share[r] * x.share[c] *
                       field(static_cast<std::size_t>(y.index[r] * columns + x.index[c]));
        return sum;
    }
};

Ground::Ground(const GroundDef& def, const EnvironmentDef& environment)
    : def_(def), soil_(environment.soil), heights_(def.heights) {
    const Vec3 down = compass(def.slope_towards) * std::tan(def.slope);
    fall_x_ = -down.x(), fall_y_ = -down.y();
    if (!(std::abs(std::tan(def.slope)) <= kSteepest))
        throw std::invalid_argument("a seabed's slope is a wall");
    if (def.columns < 0 || def.columns > kMaxPoints || def.rows < 0 || def.rows > kMaxPoints ||
        (def.columns == 0) != (def.rows == 0) || !(def.spacing > 0))
        throw std::invalid_argument("a seabed's grid has no size");
    const std::size_t points = static_cast<std::size_t>(def.columns) * static_cast<std::size_t>(def.rows);
    if ((!def.heights.empty() && def.heights.size() != points) ||
        (!def.soils.empty() && def.soils.size() != points))
        throw std::invalid_argument("a seabed's heights or soils are not as many as its grid has points");
    heights_.resize(points);
    figures_.resize(points);
    for (std::size_t k = 0; k < points; ++k) {
        highest_ = std::max(highest_, heights_[k]);
        const Soil soil = def.soils.empty() ? soil_ : def.soils[k];
        const ChainBed bed = soil != soil_ ? chain_bed(soil)
                                           : ChainBed{environment.bed_friction, environment.bed_stiffness,
                                                      environment.bed_suction};
        figures_[k] = {1 / bed.stiffness, bed.friction, bed.suction};
    }
    if (points == 0)
        figures_ = {{1 / environment.bed_stiffness, environment.bed_friction, environment.bed_suction}};
}

Ground::Stencil Ground::around(double x, double y) const {
    return {axis_around((x - def_.west) / def_.spacing, def_.columns, def_.spacing),
            axis_around((y - def_.south) / def_.spacing, def_.rows, def_.spacing), def_.columns};
}

double Ground::height(double x, double y) const {
    const double plane = fall_x_ * x + fall_y_ * y;
    return has_grid() ? plane + around(x, y).value([&](std::size_t k) { return heights_[k]; }) : plane;
}

Vec3 Ground::normal(double x, double y) const {
    Vec3 up(-fall_x_, -fall_y_, 1);
    if (has_grid()) {
        const Sample h = around(x, y).sample([&](std::size_t k) { return heights_[k]; });
        up -= Vec3(h.x, h.y, 0);
    }
    return up.normalized();
}

Soil Ground::soil(double x, double y) const {
    if (def_.soils.empty()) return soil_;
    const Stencil near = around(x, y);
    return def_.soils[static_cast<std::size_t>(near.y.index[1] * near.columns + near.x.index[1])];
}

double Ground::friction(double x, double y) const {
    if (def_.soils.empty()) return figures_.front().friction;
    return around(x, y).value([&](std::size_t k) { return figures_[k].friction; });
}

/// The force for each metre, -grad U = (g / c) (-h_x + g c_x / 2c, -h_y + g c_y / 2c, 1), is a push along the
/// normal that it makes with z: with that vector's length L, penetration g / L and stiffness L^2 / c.
BedUnder Ground::under(double level, const Vec3& at) const {
    const double plane = level + fall_x_ * at.x() + fall_y_ * at.y();
    BedUnder bed;
    Vec3 up(-fall_x_, -fall_y_, 1);
    double sunk = plane - at.z();
    Figures figures = figures_.front();
    if (has_grid()) {
        if (sunk + highest_ <= 0) return bed;
        const Stencil near = around(at.x(), at.y());
        const Sample h = near.sample([&](std::size_t k) { return heights_[k]; });
        sunk += h.value;
        up -= Vec3(h.x, h.y, 0);
        if (!def_.soils.empty() && sunk > 0) {
            const Sample c = near.sample([&](std::size_t k) { return figures_[k].compliance; });
            const double tilt = 0.5 * sunk / c.value;
            up += Vec3(tilt * c.x, tilt * c.y, 0);
            figures = {c.value, near.value([&](std::size_t k) { return figures_[k].friction; }),
                       near.value([&](std::size_t k) { return figures_[k].suction; })};
        }
    }
    if (sunk <= 0) return bed;
    const double length = up.norm();
    return {up / length, sunk / length, length * length / figures.compliance, figures.friction,
            figures.suction};
}

void lay_ground(EnvironmentDef& environment, const GroundDef& def) {
    environment.ground = std::make_shared<const Ground>(def, environment);
}

double bed_height(const EnvironmentDef& environment, double x, double y) {
    return environment.ground ? environment.ground->height(x, y) - environment.depth : -environment.depth;
}

double height_over_bed(const EnvironmentDef& environment, const Vec3& at) {
    return at.z() - bed_height(environment, at.x(), at.y());
}

Vec3 bed_normal(const EnvironmentDef& environment, double x, double y) {
    return environment.ground ? environment.ground->normal(x, y) : Vec3(Vec3::UnitZ());
}

Soil soil_at(const EnvironmentDef& environment, double x, double y) {
    return environment.ground ? environment.ground->soil(x, y) : environment.soil;
}

double bed_grip(const EnvironmentDef& environment, double x, double y) {
    if (!environment.ground) return environment.bed_friction;
    const double cosine = environment.ground->normal(x, y).z();
    return std::max(0.0, environment.ground->friction(x, y) * cosine - std::sqrt(1 - cosine * cosine));
}

BedUnder bed_under(const EnvironmentDef& environment, const Vec3& at) {
    if (environment.ground) return environment.ground->under(-environment.depth, at);
    const double sunk = -environment.depth - at.z();
    return {Vec3::UnitZ(), sunk > 0 ? sunk : 0, environment.bed_stiffness, environment.bed_friction,
            environment.bed_suction};
}

} // namespace windlass::physics
