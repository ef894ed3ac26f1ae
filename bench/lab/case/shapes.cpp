#include "bench/lab/case/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::lab {
namespace {

/// The point where a rising function passes zero.
double root(const std::function<double(double)>& f, double low, double high) {
    for (int k = 0; k < 200 && high - low > 1e-15 * (std::abs(low) + std::abs(high)); ++k) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// A line under the pulls H along and V upwards at its upper end, N.
struct Catenary {
    CatenaryLine line;
    bool on_bed;
    double H, V;

    /// Length lying on the bed, m.
    double lying() const { return on_bed ? std::max(0.0, line.length - V / line.weight) : 0; }

    /// Place along and above the lower end.
    Eigen::Vector2d at(double arc) const {
        const double bed = lying(), w = line.weight, a = H / w;
        const double along = arc * H / line.stiffness; // stretch
        if (arc <= bed) return {arc + along, 0};
        const double foot = bed > 0 ? 0 : V - w * line.length; // vertical pull where it begins to rise
        const double s = arc - bed, head = foot + w * s;
        return {bed + a * (std::asinh(head / H) - std::asinh(foot / H)) + along,
                a * (std::hypot(1, head / H) - std::hypot(1, foot / H)) +
                    (foot * s + 0.5 * w * s * s) / line.stiffness};
    }
};

} // namespace

Shape straight_shape(const Vec3& lower, const Vec3& upper, double length) {
    return [=](double arc) -> Vec3 { return lower + (upper - lower) * (arc / length); };
}

Shape hanging_shape(const Vec3& upper, double length, double weight, double stiffness, double pull) {
    return [=](double arc) -> Vec3 {
        const double up = length - arc;
        return upper - Vec3(0, 0, up + (pull * up + weight * (length * up - 0.5 * up * up)) / stiffness);
    };
}

Shape folded_shape(const Vec3& lower, const Vec3& upper, double length, const Vec3& direction) {
    if ((upper - lower).norm() > length)
        throw std::invalid_argument("the line is shorter than the distance of its ends");
    const Vec3 middle = 0.5 * (lower + upper);
    const auto bight = [=](double depth) -> Vec3 { return middle + depth * direction.normalized(); };
    const double depth = root(
        [&](double d) { return (bight(d) - lower).norm() + (bight(d) - upper).norm() - length; }, 0, length);
    const Vec3 turn = bight(depth);
    const double first = (turn - lower).norm(), second = length - first;
    return [=](double arc) -> Vec3 {
        return arc < first ? lower + (turn - lower) * (arc / first)
                           : turn + (upper - turn) * (second > 0 ? (arc - first) / second : 0);
    };
}

Shape catenary_shape(const Vec3& lower, const Vec3& upper, const CatenaryLine& line, bool on_bed) {
    const Vec3 span = upper - lower;
    const double reach = std::hypot(span.x(), span.y()), height = span.z();
    if (line.weight <= 0 || height < 0 || reach <= 0)
        throw std::invalid_argument(
            "a catenary needs weight, and an upper end above and away from the lower");
    if (on_bed && reach + height <= line.length)
        throw std::invalid_argument("the line is so long that it would lie in a heap");
    const double total = line.weight * line.length;
    // The vertical pull that lifts the upper end to its height, for a given horizontal one: both rise
    // together.
    const auto balanced = [&](double H) {
        Catenary c{line, on_bed, H, 0};
        c.V = root(
            [&](double V) {
                c.V = V;
                return c.at(line.length).y() - height;
            },
            on_bed ? 0 : -total, 2 * (total + line.stiffness));
        return c;
    };
    const double log_pull =
        root([&](double log_H) { return balanced(std::exp(log_H)).at(line.length).x() - reach; },
             std::log(1e-6 * total), std::log(10 * line.stiffness));
    const Catenary c = balanced(std::exp(log_pull));
    const Vec3 along = Vec3(span.x(), span.y(), 0) / reach;
    return [=](double arc) -> Vec3 {
        const Eigen::Vector2d p = c.at(arc);
        return lower + p.x() * along + Vec3(0, 0, p.y());
    };
}

Shape points_shape(std::vector<Vec3> points, double length) {
    std::vector<double> along{0};
    for (std::size_t i = 1; i < points.size(); ++i)
        along.push_back(along.back() + (points[i] - points[i - 1]).norm());
    return [=](double arc) -> Vec3 {
        const double s = std::clamp(arc / length, 0.0, 1.0) * along.back();
        const std::size_t i = std::clamp<std::size_t>(
            std::upper_bound(along.begin(), along.end(), s) - along.begin(), 1, along.size() - 1);
        const double piece = along[i] - along[i - 1];
        return points[i - 1] + (points[i] - points[i - 1]) * (piece > 0 ? (s - along[i - 1]) / piece : 0);
    };
}

} // namespace windlass::lab
