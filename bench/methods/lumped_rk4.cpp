// Lumped mass with internal damping, integrated by the classical Runge-Kutta method of fourth order.
// Formulation: Hall and Goupee (2015), "Validation of a lumped-mass mooring line model with DeepCwind
// semisubmersible model test data", Ocean Engineering 104, equations 1 to 14 (MoorDyn): tension EA e + BA
// de/dt in every link, Morison's drag and added mass on the tangent through the two neighbours of a node, the
// seabed as spring and damper. Friction on the seabed is Coulomb's, taken off after each step.
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

/// y += a x. Fields are parameters: only of those does the compiler believe that they share no memory.
void add(double* __restrict y, const double* __restrict x, double a, int from, int until) {
    for (int i = from; i < until; ++i)
        y[i] += a * x[i];
}

/// y = x + a u.
void set_sum(double* __restrict y, const double* __restrict x, const double* __restrict u, double a, int from,
             int until) {
    for (int i = from; i < until; ++i)
        y[i] = x[i] + a * u[i];
}

/// Force (fx, fy, fz) of each link on its lower node, N.
void pull_links(const double* __restrict x, const double* __restrict y, const double* __restrict z,
                const double* __restrict u, const double* __restrict v, const double* __restrict w,
                double* __restrict fx, double* __restrict fy, double* __restrict fz, const LumpedLine& line) {
    const double rest = line.rest, spring = line.spring, damper = line.damper;
    const int n = line.links;
    for (int i = 0; i < n; ++i) {
        const double dx = x[i + 1] - x[i], dy = y[i + 1] - y[i], dz = z[i + 1] - z[i];
        const double faster = dx * (u[i + 1] - u[i]) + dy * (v[i + 1] - v[i]) + dz * (w[i + 1] - w[i]);
        const double over = 1 / std::sqrt(dx * dx + dy * dy + dz * dz); // of no length: infinite
        const double stretched = 1 - rest * over;                       // share of the length; minus infinity
        const double pull = spring * stretched + damper * faster * over * over;
        const double taut = stretched > 0 && pull > 0 ? pull : 0; // chain does not push
        fx[i] = taut * dx, fy[i] = taut * dy, fz[i] = taut * dz;
    }
}

/// Acceleration of the inner nodes under the pull of two links each, one coordinate, m/s2.
void accelerate_inner(const double* __restrict f, double* __restrict a, double over_mass, double gravity,
                      int n) {
    for (int i = 1; i < n; ++i)
        a[i] = over_mass * (f[i] - f[i - 1]) - gravity;
}

/// How many nodes are below z (m).
int count_below(const double* __restrict z, double level, int nodes) {
    int count = 0;
    for (int i = 0; i < nodes; ++i)
        count += z[i] < level;
    return count;
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
          acceleration_(links + 1),
          rub_(links + 1),
          bed_(line_.bed_in_reach()) {
        line_.start(position_, velocity_);
        stage_position_ = position_;
        stage_velocity_ = velocity_;
        // The fastest mode has neighbours in opposition: 2 sqrt(k / m). A little less than its limit, because
        // a bent line in motion is not quite the linear one.
        const double frequency = 2 * std::sqrt(line_.spring / line_.min_mass());
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
        sum_velocity_ = velocity_, sum_acceleration_ = acceleration_;
        place(velocity_, half, t + half);
        accelerate(stage_position_, stage_velocity_);
        gather(2);
        place(stage_velocity_, half, t + half);
        accelerate(stage_position_, stage_velocity_);
        gather(2);
        place(stage_velocity_, step_, t + step_);
        accelerate(stage_position_, stage_velocity_);
        gather(1);
        advance(position_, sum_velocity_, step_ / 6);
        advance(velocity_, sum_acceleration_, step_ / 6);
        if (bed_) rub();
        ++taken_;
        line_.hold(time(), position_, velocity_);
    }

    /// Friction on the seabed, after all else has acted: Coulomb's law is too stiff for the stages. These
    /// know that of the step before, without which chain that it holds would creep.
    void rub() {
        const physics::ChainDef& def = line_.problem.line;
        const physics::EnvironmentDef& sea = line_.problem.environment;
        for (int i = line_.first; i <= line_.last; ++i) {
            const double sunk = -sea.depth - position_.z[i];
            const double u = velocity_.x[i] - step_ * rub_.x[i], v = velocity_.y[i] - step_ * rub_.y[i];
            if (sunk <= 0 && rub_.x[i] == 0 && rub_.y[i] == 0) continue;
            // Sliding along the chain moves less water with it than sliding across.
            const Vec3 span = position_.at(std::min(i + 1, line_.links)) - position_.at(std::max(i - 1, 0));
            const Vec3 slide(u, v, 0);
            const double along = slide.dot(span), scale = slide.squaredNorm() * span.squaredNorm();
            const double share = scale > 0 ? along * along / scale : 0;
            const double added =
                def.added_mass_normal + (def.added_mass_axial - def.added_mass_normal) * share;
            const double mass = line_.mass[i] + line_.end_mass[i] + added * line_.displaced[i];
            const double push = line_.bed_spring[i] * sunk,
                         normal =
                             line_.mass[i] + line_.end_mass[i] + def.added_mass_normal * line_.displaced[i];
            const bool borne =
                sunk > 0 && push > 2 * std::sqrt(line_.bed_spring[i] * normal) * velocity_.z[i];
            const double limit = borne ? sea.bed_friction * push : 0;
            const double keep = kept_by_friction(slide.norm(), step_ * limit / mass);
            velocity_.x[i] = keep * u, velocity_.y[i] = keep * v;
            rub_.x[i] = (keep - 1) * u / step_, rub_.y[i] = (keep - 1) * v / step_;
        }
    }

    /// y += a x, over the free nodes.
    void advance(Field& y, const Field& x, double a) const {
        const int from = line_.first, until = line_.last + 1;
        add(y.x.data(), x.x.data(), a, from, until);
        add(y.y.data(), x.y.data(), a, from, until);
        add(y.z.data(), x.z.data(), a, from, until);
    }

    void gather(double share) {
        advance(sum_velocity_, stage_velocity_, share);
        advance(sum_acceleration_, acceleration_, share);
    }

    /// to = from + h rate, over the free nodes.
    void move(Field& to, const Field& start, const Field& rate, double h) const {
        const int from = line_.first, until = line_.last + 1;
        set_sum(to.x.data(), start.x.data(), rate.x.data(), h, from, until);
        set_sum(to.y.data(), start.y.data(), rate.y.data(), h, from, until);
        set_sum(to.z.data(), start.z.data(), rate.z.data(), h, from, until);
    }

    /// The next stage: the state at the start of the step, moved for h (s) at the given speed and the
    /// acceleration.
    void place(const Field& speed, double h, double time) {
        move(stage_position_, position_, speed, h);
        move(stage_velocity_, velocity_, acceleration_, h);
        line_.hold(time, stage_position_, stage_velocity_);
    }

    void accelerate(const Field& p, const Field& v) {
        pull_links(p.x.data(), p.y.data(), p.z.data(), v.x.data(), v.y.data(), v.z.data(), pull_.x.data(),
                   pull_.y.data(), pull_.z.data(), line_);
        if (line_.in_water() ||
            (bed_ && count_below(p.z.data(), -line_.problem.environment.depth, line_.nodes()) > 0)) {
            accelerate_in_water(p, v);
        } else {
            accelerate_in_air();
        }
    }

    void accelerate_in_air() {
        const double over = 1 / line_.mass[1];
        accelerate_inner(pull_.x.data(), acceleration_.x.data(), over, 0, line_.links);
        accelerate_inner(pull_.y.data(), acceleration_.y.data(), over, 0, line_.links);
        accelerate_inner(pull_.z.data(), acceleration_.z.data(), over, physics::kGravity, line_.links);
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

    /// Nodes from to until, which have a link below, above or on both sides, and are all alike.
    template <bool Below, bool Above>
    void water_nodes(int from, int until, const Field& p, const Field& v);

    LumpedLine line_;
    Field position_, velocity_;
    Field pull_; ///< N, per link
    Field stage_position_, stage_velocity_, sum_velocity_, sum_acceleration_, acceleration_;
    Field rub_; ///< m/s2, level, of friction in the last step
    bool bed_;  ///< in reach
    int substeps_ = 1;
    double step_ = 0;
    long taken_ = 0;
};

template <bool Below, bool Above>
void LumpedRk4::water_nodes(int from, int until, const Field& p, const Field& q) {
    const physics::ChainDef& def = line_.problem.line;
    const physics::EnvironmentDef& sea = line_.problem.environment;
    constexpr int kBelow = Below ? 1 : 0, kAbove = Above ? 1 : 0;
    const double length = line_.length[from];
    const double mass = line_.mass[from] + line_.end_mass[from], displaced = line_.displaced[from];
    const double weight = line_.mass[from] * physics::kGravity + line_.end_weight[from];
    const double added_normal = def.added_mass_normal * displaced,
                 added_axial = def.added_mass_axial * displaced;
    const double area = 0.5 * sea.water_density * def.diameter * length;
    const double drag_normal = area * def.drag_normal, drag_axial = area * def.drag_axial;
    const double cx = line_.current.x(), cy = line_.current.y(), cz = line_.current.z();
    const double bed = -sea.depth, spring = line_.bed_spring[from];
    const double *x = p.x.data(), *y = p.y.data(), *z = p.z.data();
    const double *u = q.x.data(), *v = q.y.data(), *w = q.z.data();
    const double *fx = pull_.x.data(), *fy = pull_.y.data(), *fz = pull_.z.data();
    const double *bx = rub_.x.data(), *by = rub_.y.data();
    double *ax = acceleration_.x.data(), *ay = acceleration_.y.data(), *az = acceleration_.z.data();
#pragma GCC ivdep // no two of these arrays are the same
    for (int i = from; i <= until; ++i) {
        double tx = x[i + kAbove] - x[i - kBelow], ty = y[i + kAbove] - y[i - kBelow],
               tz = z[i + kAbove] - z[i - kBelow];
        const double scale = 1 / std::sqrt(tx * tx + ty * ty + tz * tz + 1e-300);
        tx *= scale, ty *= scale, tz *= scale;
        const double share = 0.5 - z[i] / length, capped = share > 1 ? 1 : share,
                     wet = capped > 0 ? capped : 0;
        const double normal = mass + wet * added_normal, axial = mass + wet * added_axial;

        const double rx = u[i] - cx, ry = v[i] - cy, rz = w[i] - cz; // flow past the node
        const double along = rx * tx + ry * ty + rz * tz;
        const double nx = rx - along * tx, ny = ry - along * ty, nz = rz - along * tz;
        const double across = wet * drag_normal * std::sqrt(nx * nx + ny * ny + nz * nz);
        const double lengthwise = wet * drag_axial * std::abs(along) * along;

        const double sunk = bed - z[i];
        const double borne = spring * sunk - 2 * std::sqrt(spring * normal) * w[i]; // critically damped
        const double support = ((sunk > 0) & (borne > 0)) ? borne : 0;              // mud does not pull

        double gx = -across * nx - lengthwise * tx, gy = -across * ny - lengthwise * ty,
               gz = -across * nz - lengthwise * tz + support - weight + wet * displaced * physics::kGravity;
        if constexpr (Above) gx += fx[i], gy += fy[i], gz += fz[i];
        if constexpr (Below) gx -= fx[i - 1], gy -= fy[i - 1], gz -= fz[i - 1];
        const double even = 1 / normal, more = (1 / axial - even) * (gx * tx + gy * ty + gz * tz);
        ax[i] = even * gx + more * tx + bx[i], ay[i] = even * gy + more * ty + by[i],
        az[i] = even * gz + more * tz;
    }
}

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
