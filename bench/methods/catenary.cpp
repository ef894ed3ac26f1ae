// The static elastic catenary with seabed contact and friction, solved anew from the end points in every
// step. Sources: Irvine (1981), "Cable Structures", section 2.4 (elastic catenary); Jonkman (2007), "Dynamics
// modeling and loads analysis of an offshore floating wind turbine", NREL/TP-500-41958, equations 2-35 to
// 2-38 (with the seabed's friction) and 2-39 to 2-41 (starting guess); the same stand in MAP and MoorPy.
//
// In the plane of the two ends: H is the horizontal pull, the same wherever the line hangs, V the vertical
// pull at the upper end. A line that reaches the bed hangs from each of its ends down to a touchdown, and
// lies between.

#include "bench/methods/list.hpp"
#include "bench/methods/lumped_line.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace windlass::lab {

namespace {

/// One line in its vertical plane. SI; x from the lower end towards the upper, z upwards from the lower end.
class PlaneCatenary {
public:
    /// Unstretched length (m), weight in water (N/m), EA (N), friction (-).
    PlaneCatenary(double length, double weight, double stiffness, double friction)
        : length_(length), weight_(weight), stiffness_(stiffness), friction_(friction) {}

    /// Finds the line between ends that lie x apart and at the given heights above the bed (m; the bed out of
    /// reach: infinite).
    void solve(double x, double low, double high) {
        span_ = std::max(x, 1e-9 * length_);
        low_ = low < 1e-3 * length_ ? 0 : low; // an end that lies on the bed may have sunk in a little
        high_ = std::max(0.0, high);
        rise_ = high - low;
        hanging_ = !lies_on_bed();
        if (hanging_) hang();
    }

    /// Place of the point at unstretched length s, m.
    Eigen::Vector2d place(double s) const {
        if (hanging_) {
            const double from = vertical_ - weight_ * length_;
            return arc(from + weight_ * s) - arc(from);
        }
        const double off = vertical_low_ / weight_, on = length_ - vertical_ / weight_;
        if (s < off)
            return {sag_x(vertical_low_) - sag_x(vertical_low_ - weight_ * s),
                    sag_z(weight_ * (off - s)) - low_};
        if (s > on)
            return {span_ - sag_x(vertical_) + sag_x(weight_ * (s - on)), sag_z(weight_ * (s - on)) - low_};
        // Between the touchdowns, stretched by what friction leaves of the pull; slack lies evenly.
        const double from = sag_x(vertical_low_), to = span_ - sag_x(vertical_);
        const double whole = lying_stretched(on - off, on - off);
        const double part = on > off ? whole - lying_stretched(on - off, on - s) : 0;
        return {from + (to - from) * (whole > 0 ? part / whole : 0), -low_};
    }

    /// Tension at unstretched length s, N.
    double tension(double s) const {
        if (hanging_) return std::hypot(horizontal_, vertical_ - weight_ * (length_ - s));
        const double off = vertical_low_ / weight_, on = length_ - vertical_ / weight_;
        if (s < off) return std::hypot(horizontal_, weight_ * (off - s));
        if (s > on) return std::hypot(horizontal_, weight_ * (s - on));
        return std::max(0.0, horizontal_ - rubbing() * (on - s));
    }

private:
    /// Of a hanging line from its apex to where the vertical pull is v, m: Irvine's parametric form.
    double sag_x(double v) const {
        if (horizontal_ <= 0) return 0;
        return horizontal_ / weight_ * std::asinh(v / horizontal_) + horizontal_ * v / (weight_ * stiffness_);
    }
    double sag_z(double v) const {
        return (std::hypot(horizontal_, v) - horizontal_) / weight_ + 0.5 * v * v / (weight_ * stiffness_);
    }
    Eigen::Vector2d arc(double v) const { return {sag_x(v), sag_z(v)}; }

    /// Friction counts where the lower end lies on the bed; a line that hangs at both ends is pulled alike
    /// from both.
    double rubbing() const { return low_ > 0 ? 0 : friction_ * weight_; }

    /// Stretched length of the uppermost part (m, unstretched) of all that lies on the bed.
    double lying_stretched(double lying, double part) const {
        part = std::min(part, lying);
        const double loss = rubbing();
        const double pulled = loss > 0 ? std::min(part, horizontal_ / loss) : part;
        return part + (horizontal_ - 0.5 * loss * pulled) * pulled / stiffness_;
    }

    /// Vertical pull that lifts a hanging part to the given height, N. Newton from the inextensible line's,
    /// which is above it: the function is convex, so that it comes down to the root without passing it.
    double lifts(double height) const {
        double v = std::sqrt(weight_ * height * (weight_ * height + 2 * horizontal_));
        for (int k = 0; k < 30 && v > 0; ++k) {
            const double slope = v / (weight_ * std::hypot(horizontal_, v)) + v / (weight_ * stiffness_);
            const double change = (sag_z(v) - height) / slope;
            v -= change;
            if (std::abs(change) < 1e-13 * v) break;
        }
        return v;
    }

    /// Metres by which the line at this H reaches further than its ends lie apart; not a number where it is
    /// all off the bed.
    double excess(double h) {
        horizontal_ = h;
        vertical_low_ = lifts(low_);
        vertical_ = lifts(high_);
        const double lying = length_ - (vertical_low_ + vertical_) / weight_;
        if (lying < 0) return std::numeric_limits<double>::quiet_NaN();
        return sag_x(vertical_low_) + sag_x(vertical_) + lying_stretched(lying, lying) - span_;
    }

    /// Solves the line with a part on the bed. False if there is none.
    bool lies_on_bed() {
        if (!std::isfinite(low_) || weight_ <= 0) return false;
        double below = 0;
        const double slack = excess(0);
        if (std::isnan(slack)) return false;
        if (slack >= 0) return true; // more chain than room: it hangs straight down and lies in a heap
        double above = 0.01 * weight_ * length_, end = excess(above);
        while (end < 0) {
            below = above;
            above *= 4;
            end = excess(above);
        }
        // A line all off the bed counts as too far: the root, if there is one, is below.
        bool found = !std::isnan(end);
        for (int k = 0; k < 200 && above - below > 1e-14 * above; ++k) {
            const double middle = 0.5 * (below + above), value = excess(middle);
            if (value < 0) {
                below = middle;
            } else {
                above = middle;
                found = found || !std::isnan(value);
            }
        }
        if (!found) return false;
        return !std::isnan(excess(above)) || !std::isnan(excess(below));
    }

    /// Solves the line that hangs free of the bed: Newton on H and V.
    void hang() {
        const double chord2 = span_ * span_ + rise_ * rise_;
        const double bow = length_ * length_ <= chord2
                               ? 0.2
                               : std::sqrt(3 * ((length_ * length_ - rise_ * rise_) / (span_ * span_) - 1));
        horizontal_ = std::max(std::abs(weight_ * span_ / (2 * bow)), 1e-9 * weight_ * length_);
        vertical_ = 0.5 * weight_ * (rise_ / std::tanh(bow) + length_);
        const Eigen::Vector2d goal(span_, rise_);
        Eigen::Vector2d miss = reach() - goal;
        for (int k = 0; k < 100 && miss.norm() > 1e-12 * length_; ++k) {
            const Eigen::Vector2d change = jacobian().fullPivLu().solve(miss);
            const double h = horizontal_, v = vertical_;
            double share = 1;
            Eigen::Vector2d next = miss;
            for (int halving = 0; halving < 40; ++halving, share *= 0.5) {
                horizontal_ = h - share * change.x();
                vertical_ = v - share * change.y();
                if (horizontal_ <= 0) continue; // a line that hangs has none or pulls inwards
                next = reach() - goal;
                if (next.norm() < miss.norm()) break;
            }
            if (next.norm() >= miss.norm()) {
                horizontal_ = h, vertical_ = v;
                return;
            }
            miss = next;
        }
    }
    Eigen::Vector2d reach() const { return arc(vertical_) - arc(vertical_ - weight_ * length_); }
    Eigen::Matrix2d jacobian() const {
        const double h = horizontal_, v = vertical_, u = vertical_ - weight_ * length_;
        const double top = std::hypot(h, v), foot = std::hypot(h, u), along = length_ / stiffness_;
        Eigen::Matrix2d j;
        j(0, 0) = (std::asinh(v / h) - std::asinh(u / h) - v / top + u / foot) / weight_ + along;
        j(0, 1) = j(1, 0) = (h / top - h / foot) / weight_;
        j(1, 1) = (v / top - u / foot) / weight_ + along;
        return j;
    }

    double length_, weight_, stiffness_, friction_;
    double span_ = 0, rise_ = 0, low_ = 0, high_ = 0;
    double horizontal_ = 0;   ///< H, N
    double vertical_ = 0;     ///< V at the upper end, N
    double vertical_low_ = 0; ///< at the lower end where the line also hangs down from it, N
    bool hanging_ = false;    ///< none of it on the bed
};

class Catenary final : public Method {
public:
    Catenary(const Problem& problem, int links, double dt)
        : problem_(problem),
          links_(links),
          dt_(dt),
          place_(links + 1),
          before_(links + 1),
          tension_(links),
          weight_(physics::weight_in_water(problem.line, problem.environment.water_density)),
          plane_(problem.length, weight_, problem.line.stiffness, problem.environment.bed_friction) {
        check_problem(problem, dt);
        if (links < 1) throw std::invalid_argument("a catenary needs a link or more");
        if (!held(problem.lower) && !held(problem.upper))
            throw std::invalid_argument("a catenary needs an end that is held: it knows no falling line");
        if (weight_ <= 0) throw std::invalid_argument("a catenary needs a line that is heavier than water");
        solve();
        before_ = place_;
    }

    void step() override {
        ++taken_;
        std::swap(before_, place_);
        solve();
    }
    double time() const override { return taken_ * dt_; }
    int links() const override { return links_; }
    Vec3 position(int node) const override { return place_[node]; }
    Vec3 velocity(int node) const override { return (place_[node] - before_[node]) / dt_; }
    double tension(int link) const override { return tension_[link]; }

private:
    Vec3 at(const End& end, double arc) const {
        return end.kind == EndKind::driven ? end.motion(time()) : problem_.start(arc);
    }

    void solve() {
        const Vec3 lower = at(problem_.lower, 0), upper = at(problem_.upper, problem_.length);
        if (!held(problem_.lower)) {
            hang_down(upper, problem_.lower, true);
        } else if (!held(problem_.upper)) {
            hang_down(lower, problem_.upper, false);
        } else {
            span(lower, upper);
        }
    }

    double arc(double node) const { return problem_.length * node / links_; }

    /// The line between two held ends. The upper one is the higher: the other way round it is the same line.
    void span(const Vec3& lower, const Vec3& upper) {
        const bool turned = upper.z() < lower.z();
        const Vec3& foot = turned ? upper : lower;
        Vec3 level = (turned ? lower : upper) - foot;
        level.z() = 0;
        const double bed = -problem_.environment.depth, x = level.norm();
        plane_.solve(x, foot.z() - bed, std::max(lower.z(), upper.z()) - bed);
        if (x > 0) level /= x;
        for (int i = 0; i <= links_; ++i) {
            const Eigen::Vector2d p = plane_.place(turned ? problem_.length - arc(i) : arc(i));
            place_[i] = foot + p.x() * level + Vec3(0, 0, p.y());
        }
        for (int i = 0; i < links_; ++i) {
            const double s = arc(i + 0.5);
            tension_[i] = plane_.tension(turned ? problem_.length - s : s);
        }
    }

    /// The line that hangs from one end, with what is attached to its other; what reaches the bed lies in a
    /// heap.
    void hang_down(const Vec3& held, const End& end, bool lower_hangs) {
        const double room = held.z() + problem_.environment.depth, ea = problem_.line.stiffness;
        double load = end.kind == EndKind::mass ? end.weight : 0, length = problem_.length;
        const auto reach = [&](double s) { return s + (load * s + weight_ * s * (length - 0.5 * s)) / ea; };
        if (reach(length) > room) {
            load = 0; // on the bed; its length is the hanging part's
            length = ea / weight_ * (std::sqrt(1 + 2 * weight_ * std::max(0.0, room) / ea) - 1);
        }
        for (int i = 0; i <= links_; ++i) {
            const double s = lower_hangs ? problem_.length - arc(i) : arc(i); // from the held end
            place_[i] = held - Vec3(0, 0, reach(std::min(s, length)));
        }
        for (int i = 0; i < links_; ++i) {
            const double s = lower_hangs ? problem_.length - arc(i + 0.5) : arc(i + 0.5);
            tension_[i] = s < length ? load + weight_ * (length - s) : 0;
        }
    }

    Problem problem_;
    int links_;
    double dt_;
    std::vector<Vec3> place_, before_;
    std::vector<double> tension_;
    double weight_; ///< N/m
    PlaneCatenary plane_;
    long taken_ = 0;
};

} // namespace

MethodEntry catenary_method() {
    return {
        "catenary", "static elastic catenary with seabed friction (Irvine 1981, Jonkman 2007)",
        "all dynamics and drag; weight in water also above the surface; friction where both ends are off the "
        "bed",
        [](const Problem& problem, int links, double dt, const MethodSettings&) -> std::unique_ptr<Method> {
            return std::make_unique<Catenary>(problem, links, dt);
        }};
}

} // namespace windlass::lab
