// Lumped mass with internal damping, integrated by the classical Runge-Kutta method of fourth order.
// Formulation: Hall and Goupee (2015), "Validation of a lumped-mass mooring line model with DeepCwind
// semisubmersible model test data", Ocean Engineering 104, equations 1 to 14 (MoorDyn): tension EA e + BA
// de/dt in every link, Morison's drag and added mass on the tangent through the two neighbours of a node, the
// seabed as spring and damper. Friction on the seabed is Coulomb's.
//
// Arrays per field and loops without branches, so that the compiler takes two nodes at once.

#include "bench/methods/list.hpp"
#include "bench/methods/lumped_line.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace windlass::lab {

namespace {

/// Largest step that keeps an oscillator of frequency w (rad/s) and damping ratio z bounded, s: the root of
/// |R(s dt)| = 1 on both its eigenvalues s, R being the method's polynomial.
double stable_step(double w, double z) {
    const std::complex<double> root = std::sqrt(std::complex<double>(z * z - 1));
    const auto bounded = [&](double dt) {
        const auto grows = [&](const std::complex<double>& s) {
            const std::complex<double> q = s * dt;
            return std::abs(1.0 + q * (1.0 + q / 2.0 * (1.0 + q / 3.0 * (1.0 + q / 4.0)))) > 1 + 1e-12;
        };
        return !grows(w * (-z + root)) && !grows(w * (-z - root));
    };
    double low = 0, high = 3 / w;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        (bounded(middle) ? low : high) = middle;
    }
    return low;
}

class LumpedRk4 final : public Method {
public:
    LumpedRk4(const Problem& problem, int links, double dt, const MethodSettings& settings)
        : line_(problem, links, dt),
          pull_(links),
          stage_position_(links + 1),
          stage_velocity_(links + 1),
          sum_velocity_(links + 1),
          sum_acceleration_(links + 1),
          acceleration_(links + 1) {
        line_.start(position_, velocity_);
        stage_position_ = position_;
        stage_velocity_ = velocity_;
        // The fastest mode has neighbours in opposition: 2 sqrt(k / m). A little less than its limit, because
        // a bent line in motion is not quite the linear one.
        const double frequency = 2 * std::sqrt(line_.spring / line_.least_mass());
        double limit = stable_step(frequency, 0.5 * frequency * problem.line.damping_time);
        if (problem.environment.bed_stiffness > 0)
            limit = std::min(limit, stable_step(line_.bed_frequency(), 1));
        substeps_ = settings.iterations > 0 ? settings.iterations
                                            : std::max(1, static_cast<int>(std::ceil(dt / (0.9 * limit))));
        step_ = dt / substeps_;
    }

    void step() override {
        for (int k = 0; k < substeps_; ++k)
            substep();
    }
    double time() const override { return static_cast<double>(taken_) * step_; }
    int links() const override { return line_.links; }
    Vec3 position(int node) const override { return position_.at(node); }
    Vec3 velocity(int node) const override { return velocity_.at(node); }
    double tension(int link) const override {
        const Vec3 span = position_.at(link + 1) - position_.at(link);
        const double size = span.norm(), stretch = size - line_.rest;
        if (stretch <= 0) return 0;
        const double rate = span.dot(velocity_.at(link + 1) - velocity_.at(link)) / size;
        return std::max(0.0, line_.spring * stretch + line_.damper * rate);
    }
    int iterations() const override { return substeps_; }

private:
    void substep() {
        const double t = time(), half = 0.5 * step_;
        // Each stage adds its share to the sums, then places the next.
        accelerate(position_, velocity_);
        gather(velocity_, 1, true);
        place(velocity_, half, t + half);
        accelerate(stage_position_, stage_velocity_);
        gather(stage_velocity_, 2, false);
        place(stage_velocity_, half, t + half);
        accelerate(stage_position_, stage_velocity_);
        gather(stage_velocity_, 2, false);
        place(stage_velocity_, step_, t + step_);
        accelerate(stage_position_, stage_velocity_);
        gather(stage_velocity_, 1, false);
        advance(position_, sum_velocity_, step_ / 6);
        advance(velocity_, sum_acceleration_, step_ / 6);
        ++taken_;
        line_.hold(time(), position_, velocity_);
    }

    /// y += a x over the free nodes.
    void advance(Field& y, const Field& x, double a) const {
        const auto one = [&](double* __restrict to, const double* __restrict from) {
            for (int i = line_.first; i <= line_.last; ++i)
                to[i] += a * from[i];
        };
        one(y.x.data(), x.x.data()), one(y.y.data(), x.y.data()), one(y.z.data(), x.z.data());
    }

    void gather(const Field& speed, double share, bool first) {
        if (first) {
            const auto clear = [](Field& f) {
                std::ranges::fill(f.x, 0), std::ranges::fill(f.y, 0), std::ranges::fill(f.z, 0);
            };
            clear(sum_velocity_), clear(sum_acceleration_);
        }
        advance(sum_velocity_, speed, share);
        advance(sum_acceleration_, acceleration_, share);
    }

    /// The next stage: the state at the start of the step, moved for h (s) at the given speed and
    /// acceleration.
    void place(const Field& speed, double h, double time) {
        const auto one = [&](double* __restrict x, double* __restrict v, const double* __restrict x0,
                             const double* __restrict v0, const double* u, const double* __restrict a) {
            for (int i = line_.first; i <= line_.last; ++i) { // u may be v: it is read before v is written
                x[i] = x0[i] + h * u[i];
                v[i] = v0[i] + h * a[i];
            }
        };
        one(stage_position_.x.data(), stage_velocity_.x.data(), position_.x.data(), velocity_.x.data(),
            speed.x.data(), acceleration_.x.data());
        one(stage_position_.y.data(), stage_velocity_.y.data(), position_.y.data(), velocity_.y.data(),
            speed.y.data(), acceleration_.y.data());
        one(stage_position_.z.data(), stage_velocity_.z.data(), position_.z.data(), velocity_.z.data(),
            speed.z.data(), acceleration_.z.data());
        line_.hold(time, stage_position_, stage_velocity_);
    }

    void accelerate(const Field& p, const Field& v) {
        pull_links(p, v);
        if (line_.in_water() || lowest(p) < -line_.problem.environment.depth) {
            accelerate_in_water(p, v);
        } else {
            accelerate_in_air();
        }
    }

    static double lowest(const Field& p) { return *std::ranges::min_element(p.z); }

    /// Force of each link on its lower node, N.
    void pull_links(const Field& p, const Field& v) {
        const double rest = line_.rest, spring = line_.spring, damper = line_.damper;
        const double* __restrict x = p.x.data(), * __restrict y = p.y.data(), * __restrict z = p.z.data();
        const double* __restrict vx = v.x.data(), * __restrict vy = v.y.data(), * __restrict vz = v.z.data();
        double* __restrict fx = pull_.x.data(), * __restrict fy = pull_.y.data(), * __restrict fz = pull_.z.data();
        for (int i = 0; i < line_.links; ++i) {
            const double dx = x[i + 1] - x[i], dy = y[i + 1] - y[i], dz = z[i + 1] - z[i];
            const double size = std::sqrt(dx * dx + dy * dy + dz * dz), stretch = size - rest;
            const double lengthening =
                dx * (vx[i + 1] - vx[i]) + dy * (vy[i + 1] - vy[i]) + dz * (vz[i + 1] - vz[i]);
            const double tension = spring * stretch + damper * lengthening / (size + 1e-300);
            const double taut = stretch > 0 && tension > 0 ? tension / size : 0;
            fx[i] = taut * dx, fy[i] = taut * dy, fz[i] = taut * dz;
        }
    }

    void accelerate_in_air() {
        const double *__restrict fx = pull_.x.data(), *__restrict fy = pull_.y.data(), *__restrict fz = pull_.z.data();
        double *__restrict ax = acceleration_.x.data(), *__restrict ay = acceleration_.y.data(),
                           *__restrict az = acceleration_.z.data();
        const double over = 1 / line_.mass[1];
        for (int i = 1; i < line_.links; ++i) {
            ax[i] = over * (fx[i] - fx[i - 1]);
            ay[i] = over * (fy[i] - fy[i - 1]);
            az[i] = over * (fz[i] - fz[i - 1]) - physics::kGravity;
        }
        for (const int end : {0, line_.links}) {
            const int link = end == 0 ? 0 : line_.links - 1;
            const double sign = end == 0 ? 1 : -1, mass = line_.mass[end] + line_.end_mass[end];
            const double weight = line_.mass[end] * physics::kGravity + line_.end_weight[end];
            acceleration_.set(end, (sign * pull_.at(link) - Vec3(0, 0, weight)) / mass);
        }
    }

    void accelerate_in_water(const Field& p, const Field& v) {
        water_nodes<true, true>(1, line_.links - 1, p, v);
        water_nodes<false, true>(0, 0, p, v);
        water_nodes<true, false>(line_.links, line_.links, p, v);
    }

    /// Nodes from to until, which have a link below, above or on both sides.
    template <bool Below, bool Above>
    void water_nodes(int from, int until, const Field& p, const Field& v) {
        const physics::ChainDef& def = line_.problem.line;
        const physics::EnvironmentDef& sea = line_.problem.environment;
        constexpr int below = Below ? 1 : 0, above = Above ? 1 : 0;
        const double half_density = 0.5 * sea.water_density * def.diameter;
        const double bed_damping = 2, over_step = 1 / step_;
        const double cx = line_.current.x(), cy = line_.current.y(), cz = line_.current.z();
        const double* __restrict x = p.x.data(), * __restrict y = p.y.data(), * __restrict z = p.z.data();
        const double* __restrict vx = v.x.data(), * __restrict vy = v.y.data(), * __restrict vz = v.z.data();
        const double *__restrict fx = pull_.x.data(), *__restrict fy = pull_.y.data(), *__restrict fz = pull_.z.data();
        const double* __restrict length = line_.length.data(), * __restrict dry = line_.mass.data();
        const double* __restrict displaced = line_.displaced.data(), * __restrict bed =
                                                                         line_.bed_spring.data();
        const double* __restrict end_mass = line_.end_mass.data(), * __restrict end_weight =
                                                                       line_.end_weight.data();
        double *__restrict ax = acceleration_.x.data(), *__restrict ay = acceleration_.y.data(),
                           *__restrict az = acceleration_.z.data();
        const auto net = [](const double* f, int i) { return (Above ? f[i] : 0) - (Below ? f[i - 1] : 0); };
        for (int i = from; i <= until; ++i) {
            double tx = x[i + above] - x[i - below], ty = y[i + above] - y[i - below],
                   tz = z[i + above] - z[i - below];
            const double scale = 1 / std::sqrt(tx * tx + ty * ty + tz * tz + 1e-300);
            tx *= scale, ty *= scale, tz *= scale;
            const double share = 0.5 - z[i] / length[i];
            const double wet = share < 0 ? 0 : share > 1 ? 1 : share;
            const double water = wet * displaced[i];
            const double body = dry[i] + end_mass[i];
            const double normal = body + def.added_mass_normal * water,
                         axial = body + def.added_mass_axial * water;

            const double ux = vx[i] - cx, uy = vy[i] - cy, uz = vz[i] - cz;
            const double along = ux * tx + uy * ty + uz * tz;
            const double nx = ux - along * tx, ny = uy - along * ty, nz = uz - along * tz;
            const double area = half_density * length[i] * wet;
            const double across = area * def.drag_normal * std::sqrt(nx * nx + ny * ny + nz * nz);
            const double lengthwise = area * def.drag_axial * std::abs(along) * along;

            const double sunk = -sea.depth - z[i], deep = sunk > 0 ? sunk : 0;
            const double spring = bed[i] * deep;
            const double raw = spring - (deep > 0 ? bed_damping * std::sqrt(bed[i] * normal) * vz[i] : 0);
            const double support = raw > 0 ? raw : 0; // mud does not pull
            // Coulomb's friction, but never more than would stop the node in this step.
            const double limit = sea.bed_friction * support;
            const double slide = std::sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
            const double stop = normal * over_step;
            const double rub = slide * stop > limit ? limit / (slide + 1e-300) : stop;
            const double friction = limit > 0 ? rub : 0;

            const double gx = net(fx, i) - across * nx - lengthwise * tx - friction * vx[i];
            const double gy = net(fy, i) - across * ny - lengthwise * ty - friction * vy[i];
            const double gz = net(fz, i) - across * nz - lengthwise * tz + support -
                              (dry[i] - water) * physics::kGravity - end_weight[i];
            const double even = 1 / normal, more = (1 / axial - even) * (gx * tx + gy * ty + gz * tz);
            ax[i] = even * gx + more * tx, ay[i] = even * gy + more * ty, az[i] = even * gz + more * tz;
        }
    }

    LumpedLine line_;
    Field position_, velocity_;
    Field pull_; ///< N, per link
    Field stage_position_, stage_velocity_, sum_velocity_, sum_acceleration_, acceleration_;
    int substeps_ = 1;
    double step_ = 0;
    long taken_ = 0;
};

} // namespace

MethodEntry lumped_rk4_method() {
    return {"lumped_rk4",
            "lumped mass with internal damping, Runge-Kutta 4 in substeps that it can bear (MoorDyn's "
            "formulation)",
            "",
            [](const Problem& problem, int links, double dt,
               const MethodSettings& settings) -> std::unique_ptr<Method> {
                return std::make_unique<LumpedRk4>(problem, links, dt, settings);
            }};
}

} // namespace windlass::lab
