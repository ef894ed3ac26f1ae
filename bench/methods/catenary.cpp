// The static elastic catenary with seabed contact and friction, solved anew from the end points in every
// step. Sources: plane_catenary.hpp.

#include "bench/methods/list.hpp"
#include "bench/methods/lumped_line.hpp"
#include "bench/methods/plane_catenary.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace windlass::lab {

namespace {

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
