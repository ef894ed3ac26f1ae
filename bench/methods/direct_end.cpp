// All links of a step at once, with the gradient of every constraint at the end of the step: what PBD's
// iteration converges to (implicit Euler on compliant constraints), reached by Newton's method on a
// tridiagonal matrix. Source: Deul, Kugelstadt, Weiler, Bender (2018), "Direct position-based solver for
// stiff rods", Computer Graphics Forum 37(6), equation 9, on the constraints of Macklin, Mueller, Chentanez
// (2016), equation 16: (J W J^T + l / (EA dt^2)) change = error. Robust and first order: it damps.
//
// The row of a slack link is left out; chain does not push.

#include "bench/methods/list.hpp"
#include "bench/methods/particles.hpp"
#include "bench/methods/tridiagonal.hpp"

#include <algorithm>
#include <cmath>

// The arrays do not overlap.
#define WINDLASS_VECTORISE _Pragma("GCC ivdep")

namespace windlass::lab {

namespace {

constexpr int kMaxIterations = 20;

/// Strain that is left at most: a thousandth of what chain has under its own weight.
constexpr double kTolerance = 1e-8;

/// Shortfall of a link's length, as a fraction, within which it is first taken to be taut: else a chain at
/// rest would be found taut only link by link.
constexpr double kNearlyTaut = 1e-3;

class DirectEnd final : public ParticleMethod {
public:
    DirectEnd(const Problem& problem, int links, double dt, int max_iterations)
        : ParticleMethod(problem, links, dt, SeabedBy::prediction),
          max_iterations_(max_iterations),
          unit_(links),
          up_(links),
          down_(links),
          error_(links),
          diagonal_(links),
          lower_(links),
          upper_(links),
          pull_(links) {}

    void step() override {
        particles_.predict();
        std::ranges::fill(pull_, 0);
        iterations_ = 0;
        while (measure() && iterations_ < max_iterations_) {
            ++iterations_;
            set_up_rows();
            eliminate();
            move();
        }
        particles_.accept();
    }

    double tension(int link) const override { return pull_[link] / (particles_.dt * particles_.dt); }
    int iterations() const override { return iterations_; }

private:
    /// Links as they are now. Returns whether any is off its constraint.
    bool measure() {
        const Particles& s = particles_;
        const double rest = s.line.rest, compliance = 1 / (s.line.spring * s.dt * s.dt);
        const double damping = s.line.problem.line.damping_time / s.dt;
        const int n = s.line.links;
        const double *px = s.target.x.data(), *py = s.target.y.data(), *pz = s.target.z.data();
        const double *x = s.position.x.data(), *y = s.position.y.data(), *z = s.position.z.data();
        double *ux = unit_.x.data(), *uy = unit_.y.data(), *uz = unit_.z.data();
        double *error = error_.data(), *pull = pull_.data();
        double worst = 0;
        WINDLASS_VECTORISE
        for (int i = 0; i < n; ++i) {
            const double dx = px[i + 1] - px[i], dy = py[i + 1] - py[i], dz = pz[i + 1] - pz[i];
            const double size = std::sqrt(dx * dx + dy * dy + dz * dz + 1e-30);
            const double over = 1 / size;
            ux[i] = dx * over, uy[i] = dy * over, uz[i] = dz * over;
            const double before =
                ux[i] * (x[i + 1] - x[i]) + uy[i] * (y[i + 1] - y[i]) + uz[i] * (z[i + 1] - z[i]);
            error[i] = size - rest - compliance * pull[i] + damping * (size - before);
        }
        for (int i = 0; i < n; ++i) // a slack link may be as short as it likes
            worst = std::max(worst, pull[i] > 0 ? std::abs(error[i]) : error[i]);
        return worst > kTolerance * rest;
    }

    void set_up_rows() {
        const Particles& s = particles_;
        const int n = s.line.links;
        const double gain = 1 + s.line.problem.line.damping_time / s.dt;
        const double compliance = 1 / (s.line.spring * s.dt * s.dt);
        const double *ux = unit_.x.data(), *uy = unit_.y.data(), *uz = unit_.z.data();
        if (s.wet) {
            WINDLASS_VECTORISE
            for (int i = 0; i < n; ++i) {
                const Vec3 unit = unit_.at(i);
                up_.set(i, s.inverse_matrix.at(i) * unit);
                down_.set(i, s.inverse_matrix.at(i + 1) * unit);
            }
        } else {
            WINDLASS_VECTORISE
            for (int i = 0; i < n; ++i) {
                const double below = s.inverse_mass[i], above = s.inverse_mass[i + 1];
                up_.x[i] = below * ux[i], up_.y[i] = below * uy[i], up_.z[i] = below * uz[i];
                down_.x[i] = above * ux[i], down_.y[i] = above * uy[i], down_.z[i] = above * uz[i];
            }
        }
        const auto dot = [&](int i, const Field& f, int k) {
            return ux[i] * f.x[k] + uy[i] * f.y[k] + uz[i] * f.z[k];
        };
        WINDLASS_VECTORISE
        for (int i = 0; i < n; ++i)
            diagonal_[i] = gain * (dot(i, up_, i) + dot(i, down_, i)) + compliance;
        WINDLASS_VECTORISE
        for (int i = 1; i < n; ++i)
            lower_[i] = -gain * dot(i, down_, i - 1);
        WINDLASS_VECTORISE
        for (int i = 0; i < n - 1; ++i)
            upper_[i] = -gain * dot(i, up_, i + 1);
        lower_[0] = upper_[n - 1] = 0;

        const double doubt = iterations_ == 1 ? kNearlyTaut * s.line.rest : 0;
        for (int i = 0; i < n; ++i)
            if (pull_[i] == 0 && error_[i] + doubt <= 0)
                diagonal_[i] = 1, lower_[i] = upper_[i] = error_[i] = 0;
    }

    /// error_ becomes the change of the pulls.
    void eliminate() {
        const int n = particles_.line.links;
        solve_tridiagonal(lower_, diagonal_, upper_, error_);
        for (int i = 0; i < n; ++i) {
            const double pull = std::max(0.0, pull_[i] + error_[i]); // chain does not push
            error_[i] = pull - pull_[i];
            pull_[i] = pull;
        }
    }

    void move() {
        const int n = particles_.line.links;
        const double* change = error_.data();
        const auto one = [&](double* p, const double* up, const double* down) {
            WINDLASS_VECTORISE
            for (int i = 1; i < n; ++i)
                p[i] += change[i] * up[i] - change[i - 1] * down[i - 1];
            p[0] += change[0] * up[0];
            p[n] -= change[n - 1] * down[n - 1];
        };
        one(particles_.target.x.data(), up_.x.data(), down_.x.data());
        one(particles_.target.y.data(), up_.y.data(), down_.y.data());
        one(particles_.target.z.data(), up_.z.data(), down_.z.data());
    }

    int max_iterations_, iterations_ = 0;
    Field unit_;                ///< direction of each link
    Field up_, down_;           ///< how a link's pull moves its lower and, backwards, its upper node, 1/kg
    std::vector<double> error_; ///< m, then the change of the pull
    std::vector<double> diagonal_, lower_, upper_; ///< 1/kg
    std::vector<double> pull_;                     ///< N s2, tension times dt^2
};

std::unique_ptr<Method> make(const Problem& problem, int links, double dt, const MethodSettings& settings) {
    return std::make_unique<DirectEnd>(problem, links, dt,
                                       settings.iterations > 0 ? settings.iterations : kMaxIterations);
}

} // namespace

MethodEntry direct_end_method() {
    return {"direct_end", "direct solve of all links, gradient at the end of the step (Deul and others 2018)",
            "", make};
}

} // namespace windlass::lab
