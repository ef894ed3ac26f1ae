// XPBD: position-based dynamics whose constraints have a compliance, so that stiffness no longer depends on
// step and iteration count. Source: Macklin, Mueller, Chentanez (2016), "XPBD: position-based simulation of
// compliant constrained dynamics", MIG 2016, equations 17, 18 and, with damping, 26. Small steps: Macklin,
// Storey, Lu, Terdiman, Chentanez, Jeschke, Mueller (2019), "Small steps in physics simulation", SCA 2019,
// algorithm 1: one iteration in each of many substeps instead of many iterations in one.
//
// The compliance of a link is l / EA; its multiplier is the pull times dt^2, with which the tension is known
// without calibration. Chain does not push: the multiplier of a link keeps its sign.

#include "bench/methods/list.hpp"
#include "bench/methods/particles.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::lab {

namespace {

constexpr double kPoint = 1e-30; ///< m2, so that a link of no length has a direction: none
constexpr int kIterations = 10;  ///< as PBD's sweeps over the links in Jiang, Ren, He (2020)

class Xpbd final : public ParticleMethod {
public:
    Xpbd(const Problem& problem, int links, double dt, int iterations)
        : ParticleMethod(problem, links, dt, SeabedBy::prediction), pull_(links), iterations_(iterations) {}

    void step() override {
        particles_.predict();
        std::ranges::fill(pull_, 0);
        for (int k = 0; k < iterations_; ++k) {
            if (particles_.wet) {
                sweep<true>();
            } else {
                sweep<false>();
            }
        }
        particles_.accept();
    }

    double tension(int link) const override { return pull_[link] / (particles_.dt * particles_.dt); }
    int iterations() const override { return iterations_; }

private:
    /// Gauss-Seidel, from the lower end up. What a link does not wait for from the one before is kept out of
    /// its way: in air the mass that it moves, in still chain the damping.
    template <bool Wet>
    void sweep() {
        Particles& s = particles_;
        const double rest = s.line.rest, compliance = 1 / (s.line.spring * s.dt * s.dt);
        const double damping = s.line.problem.line.damping_time / s.dt;
        const int n = s.line.links;
        Vec3 below = s.target.at(0);
        for (int i = 0; i < n; ++i) {
            Vec3 above = s.target.at(i + 1);
            const Vec3 span = above - below;
            const double size = std::sqrt(span.squaredNorm() + kPoint), over_size = 1 / size;
            double error = size - rest - compliance * pull_[i];
            if (damping > 0)
                error += damping * (size - over_size * span.dot(s.position.at(i + 1) - s.position.at(i)));
            const double w_below = s.inverse_mass[i], w_above = s.inverse_mass[i + 1];
            if constexpr (Wet) {
                const Vec3 unit = over_size * span;
                const Vec3 up = s.inverse_matrix.at(i) * unit, down = s.inverse_matrix.at(i + 1) * unit;
                const double change = error / ((1 + damping) * unit.dot(up + down) + compliance);
                const double pull = std::max(0.0, pull_[i] + change);
                below += (pull - pull_[i]) * up;
                above -= (pull - pull_[i]) * down;
                pull_[i] = pull;
            } else {
                const double gain = 1 / ((1 + damping) * (w_below + w_above) + compliance);
                const double pull = std::max(0.0, pull_[i] + error * gain);
                const Vec3 move = (pull - pull_[i]) * over_size * span;
                below += w_below * move;
                above -= w_above * move;
                pull_[i] = pull;
            }
            s.target.set(i, below);
            below = above;
        }
        s.target.set(n, below);
    }

    std::vector<double> pull_; ///< N s2, tension times dt^2
    int iterations_;
};

std::unique_ptr<Method> make(const Problem& problem, int links, double dt, const MethodSettings& settings) {
    return std::make_unique<Xpbd>(problem, links, dt,
                                  settings.iterations > 0 ? settings.iterations : kIterations);
}

std::unique_ptr<Method> make_small_steps(const Problem& problem, int links, double dt,
                                         const MethodSettings& settings) {
    return std::make_unique<Xpbd>(problem, links, dt, settings.iterations > 0 ? settings.iterations : 1);
}

} // namespace

MethodEntry xpbd_method() {
    return {"xpbd", "XPBD, 10 Gauss-Seidel sweeps in a step (Macklin, Mueller, Chentanez 2016)", "", make};
}

MethodEntry small_step_xpbd_method() {
    return {"xpbd_small_steps", "XPBD, one Gauss-Seidel sweep in each small step (Macklin and others 2019)",
            "", make_small_steps};
}

} // namespace windlass::lab
