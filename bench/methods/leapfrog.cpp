// Springs and masses, explicit: the leapfrog (Stoermer-Verlet) scheme on elastic links, the fastest rival
// known. Source: Hairer, Lubich, Wanner (2003), "Geometric numerical integration illustrated by the
// Stoermer-Verlet method", Acta Numerica 12, equations 1.5 and 1.10; the loads on a node are those of
// server/physics/chain/chain_forces.hpp.
//
// One array per field and loops without branches, so that the compiler takes two nodes at once. A step longer
// than the scheme can bear (dt about l/c, c = sqrt(EA/mu)) is divided.

#include "bench/methods/list.hpp"
#include "bench/methods/lumped_line.hpp"

#include <algorithm>
#include <cmath>

// The arrays do not overlap.
#define WINDLASS_VECTORISE _Pragma("GCC ivdep")

namespace windlass::lab {

namespace {

/// Share of the largest stable step that is taken: a bent line in motion is not quite the linear one.
constexpr double kSafety = 0.97;

class Leapfrog final : public Method {
public:
    Leapfrog(const Problem& problem, int links, double dt, const MethodSettings& settings)
        : line_(problem, links, dt), pull_(links), wet_(line_.in_water() || line_.bed_in_reach()) {
        line_.start(position_, velocity_);
        substeps_ = settings.iterations > 0
                        ? settings.iterations
                        : std::max(1, static_cast<int>(std::ceil(dt / stable_step() - 1e-9)));
        h_ = dt / substeps_;
        pull_links();
    }

    void step() override {
        for (int k = 0; k < substeps_; ++k)
            substep();
    }
    double time() const override { return static_cast<double>(taken_) * h_; }
    int links() const override { return line_.links; }
    Vec3 position(int node) const override { return position_.at(node); }
    double tension(int link) const override { return pull_.at(link).norm(); }
    int iterations() const override { return substeps_; }

    /// The speed of the last half step, brought to this instant.
    Vec3 velocity(int node) const override {
        const Vec3 v = velocity_.at(node);
        if (taken_ == 0 || node < line_.first || node > line_.last) return v;
        Vec3 push(0, 0, -(line_.mass[node] * physics::kGravity + line_.end_weight[node]));
        if (node > 0) push -= pull_.at(node - 1);
        if (node < line_.links) push += pull_.at(node);
        // In water all but gravity and the links is left out: the half step is short.
        return wet_ ? v : Vec3(v + 0.5 * h_ / (line_.mass[node] + line_.end_mass[node]) * push);
    }

private:
    /// s; from the fastest mode: neighbours in opposition, 2 sqrt(k / m), its damping known half a step late.
    double stable_step() const {
        double frequency = 2 * std::sqrt(line_.spring / line_.min_mass());
        if (wet_) frequency = std::hypot(frequency, line_.bed_frequency());
        const double damping = 0.5 * frequency * line_.problem.line.damping_time;
        return kSafety * 2 / frequency * (std::sqrt(1 + damping * damping) - damping);
    }

    void substep() {
        // Velocities live at half steps: the first kick is half of one.
        const double kick = taken_ == 0 ? 0.5 * h_ : h_;
        const int n = line_.links;
        if (wet_) {
            move_in_water<true, true>(1, n - 1, kick);
            if (line_.first == 0) move_in_water<false, true>(0, 0, kick);
            if (line_.last == n) move_in_water<true, false>(n, n, kick);
        } else {
            move_in_air(kick);
            if (line_.first == 0) move_end_in_air(0, pull_.at(0), kick);
            if (line_.last == n) move_end_in_air(n, -pull_.at(n - 1), kick);
        }
        ++taken_;
        drive(line_.problem.lower, 0);
        drive(line_.problem.upper, n);
        pull_links();
    }

    void drive(const End& end, int node) {
        if (end.kind != EndKind::driven) return;
        const Vec3 place = end.motion(time());
        velocity_.set(node, (place - position_.at(node)) / h_);
        position_.set(node, place);
    }

    void pull_links() {
        if (line_.damper > 0) {
            pull_links<true>();
        } else {
            pull_links<false>();
        }
    }

    /// Force of each link on its lower node, N.
    template <bool Damped>
    void pull_links() {
        const double *x = position_.x.data(), *y = position_.y.data(), *z = position_.z.data();
        const double *u = velocity_.x.data(), *v = velocity_.y.data(), *w = velocity_.z.data();
        double *fx = pull_.x.data(), *fy = pull_.y.data(), *fz = pull_.z.data();
        const double spring = line_.spring, force = spring * line_.rest, damper = line_.damper;
        const int n = line_.links;
        WINDLASS_VECTORISE
        for (int i = 0; i < n; ++i) {
            const double dx = x[i + 1] - x[i], dy = y[i + 1] - y[i], dz = z[i + 1] - z[i];
            const double size = std::sqrt(dx * dx + dy * dy + dz * dz);
            double pull = spring - force / size; // over the link's length; of no length: minus infinity
            if constexpr (Damped) {
                const double faster =
                    dx * (u[i + 1] - u[i]) + dy * (v[i + 1] - v[i]) + dz * (w[i + 1] - w[i]);
                const double damped = pull + damper * faster / (size * size);
                pull = pull > 0 ? damped : 0; // a slack link does not damp
            }
            pull = pull > 0 ? pull : 0; // chain does not push
            fx[i] = pull * dx, fy[i] = pull * dy, fz[i] = pull * dz;
        }
    }

    /// Kick and drift of the nodes between the ends.
    void move_in_air(double kick) {
        const auto one = [&](double* x, double* v, const double* f, double fall) {
            const double gain = kick / line_.mass[1], h = h_;
            const int n = line_.links;
            WINDLASS_VECTORISE
            for (int i = 1; i < n; ++i) {
                v[i] += gain * (f[i] - f[i - 1]) - fall;
                x[i] += h * v[i];
            }
        };
        one(position_.x.data(), velocity_.x.data(), pull_.x.data(), 0);
        one(position_.y.data(), velocity_.y.data(), pull_.y.data(), 0);
        one(position_.z.data(), velocity_.z.data(), pull_.z.data(), kick * physics::kGravity);
    }

    void move_end_in_air(int node, const Vec3& pull, double kick) {
        const double mass = line_.mass[node] + line_.end_mass[node];
        const double weight = line_.mass[node] * physics::kGravity + line_.end_weight[node];
        velocity_.add(node, kick / mass * Vec3(pull.x(), pull.y(), pull.z() - weight));
        position_.add(node, h_ * velocity_.at(node));
    }

    /// The same for nodes in reach of water or seabed, and for the ends. Below, Above: on which sides there
    /// is a link.
    template <bool Below, bool Above>
    void move_in_water(int from, int until, double kick);

    LumpedLine line_;
    Field position_, velocity_; ///< velocities half a step late
    Field pull_;                ///< N, of each link on its lower node, at this instant
    bool wet_;
    int substeps_ = 1;
    double h_ = 0; ///< s
    long taken_ = 0;
};

template <bool Below, bool Above>
void Leapfrog::move_in_water(int from, int until, double kick) {
    const physics::ChainDef& def = line_.problem.line;
    const physics::EnvironmentDef& sea = line_.problem.environment;
    constexpr int kBelow = Below ? 1 : 0, kAbove = Above ? 1 : 0;
    const double length = line_.length[from], over_length = 1 / length;
    const double mass = line_.mass[from] + line_.end_mass[from], displaced = line_.displaced[from];
    const double weight = line_.mass[from] * physics::kGravity + line_.end_weight[from];
    const double added_normal = def.added_mass_normal * displaced,
                 added_axial = def.added_mass_axial * displaced;
    const double area = 0.5 * sea.water_density * def.diameter * length;
    const double cx = line_.current.x(), cy = line_.current.y(), cz = line_.current.z();
    const double bed = -sea.depth, bed_spring = line_.bed_spring[from], friction = sea.bed_friction;
    const double bed_damper = 2 * std::sqrt(bed_spring * (mass + added_normal)); // critical, as in the server
    const double h = h_;
    double *x = position_.x.data(), *y = position_.y.data(), *z = position_.z.data();
    double *u = velocity_.x.data(), *v = velocity_.y.data(), *w = velocity_.z.data();
    const double *fx = pull_.x.data(), *__restrict fy = pull_.y.data(), *__restrict fz = pull_.z.data();

    WINDLASS_VECTORISE
    for (int i = from; i <= until; ++i) {
        double tx = x[i + kAbove] - x[i - kBelow], ty = y[i + kAbove] - y[i - kBelow],
               tz = z[i + kAbove] - z[i - kBelow];
        const double over_size = 1 / std::sqrt(tx * tx + ty * ty + tz * tz + 1e-30);
        tx *= over_size, ty *= over_size, tz *= over_size;
        const double share = 0.5 - z[i] * over_length, capped = share > 1 ? 1 : share,
                     submerged = capped > 0 ? capped : 0;

        const double ux = u[i] - cx, uy = v[i] - cy, uz = w[i] - cz;
        const double along = ux * tx + uy * ty + uz * tz;
        const double across2 = ux * ux + uy * uy + uz * uz - along * along;
        const double across = std::sqrt(across2 > 0 ? across2 : 0);
        const double drag_normal = area * submerged * def.drag_normal * across;
        const double drag_axial = area * submerged * def.drag_axial * std::abs(along);

        const double sunk = bed - z[i];
        const double before = w[i];
        const bool borne = sunk > 0 && bed_damper * before < bed_spring * sunk; // mud does not pull
        const double support = borne ? bed_spring * sunk : 0;

        double px = -drag_normal * ux, py = -drag_normal * uy,
               pz = -drag_normal * uz - weight + submerged * displaced * physics::kGravity + support;
        if constexpr (Above) px += fx[i], py += fy[i], pz += fz[i];
        if constexpr (Below) px -= fx[i - 1], py -= fy[i - 1], pz -= fz[i - 1];
        // Drag along the chain differs; its resistance to the change in this kick is taken with the mass.
        const double push = px * tx + py * ty + pz * tz;
        const double even = kick / (mass + submerged * added_normal + kick * drag_normal);
        const double lengthwise = kick / (mass + submerged * added_axial + kick * drag_axial);
        const double more = lengthwise * (push + (drag_normal - drag_axial) * along) - even * push;
        u[i] += even * px + more * tx;
        v[i] += even * py + more * ty;
        w[i] += even * pz + more * tz;

        // The seabed's damper and friction, once its spring and all else have acted.
        const double over_mass = 1 / (mass + submerged * added_normal);
        const double slowing = 0.5 * kick * bed_damper * over_mass;
        const double damped = (w[i] - slowing * before) / (1 + slowing);
        w[i] = borne ? damped : w[i];
        // Sliding along the chain moves less water with it than sliding across.
        const double slide2 = u[i] * u[i] + v[i] * v[i] + 1e-30, lengthways = u[i] * tx + v[i] * ty;
        const double along2 = lengthways * lengthways / slide2;
        const double heavy = mass + submerged * (added_normal + (added_axial - added_normal) * along2);
        const double keep = kept_by_friction(std::sqrt(slide2), kick * friction * support / heavy);
        u[i] *= keep, v[i] *= keep;
    }
    WINDLASS_VECTORISE
    for (int i = from; i <= until; ++i) {
        x[i] += h * u[i];
        y[i] += h * v[i];
        z[i] += h * w[i];
    }
}

std::unique_ptr<Method> make(const Problem& problem, int links, double dt, const MethodSettings& settings) {
    return std::make_unique<Leapfrog>(problem, links, dt, settings);
}

} // namespace

MethodEntry leapfrog_method() {
    return {"leapfrog",
            "springs and masses, explicit leapfrog at its stable step (Hairer, Lubich, Wanner 2003)", "",
            make};
}

} // namespace windlass::lab
