#include "bench/lab/case/projection.hpp"

#include "bench/methods/particles.hpp"
#include "bench/methods/tridiagonal.hpp"

#include <cmath>
#include <random>

// The arrays do not overlap.
#define WINDLASS_VECTORISE _Pragma("GCC ivdep")

namespace windlass::lab {

namespace {

constexpr int kRate = 600; ///< steps in a second of the run up to the step

void set_directions(const Field& places, Field& unit) {
    const int n = unit.size();
    const double *px = places.x.data(), *py = places.y.data(), *pz = places.z.data();
    double *ux = unit.x.data(), *uy = unit.y.data(), *uz = unit.z.data();
    WINDLASS_VECTORISE
    for (int i = 0; i < n; ++i) {
        const double dx = px[i + 1] - px[i], dy = py[i + 1] - py[i], dz = pz[i + 1] - pz[i];
        const double over = 1 / std::sqrt(dx * dx + dy * dy + dz * dz + 1e-30);
        ux[i] = dx * over, uy[i] = dy * over, uz[i] = dz * over;
    }
}

} // namespace

StepProblem step_problem(const Case& given, int particles, double time, double dt) {
    const int links = particles - 1;
    const auto run = make_method(*find_method("production"), given.problem, links, 1.0 / kRate, {});
    while (run->time() < time - 0.5 / kRate)
        run->step();
    Particles line(given.problem, links, dt, SeabedBy::method);
    line.steps = std::lround(time / dt);
    for (int i = 0; i <= links; ++i) {
        line.position.set(i, run->position(i));
        line.velocity.set(i, run->velocity(i));
    }
    line.predict();
    StepProblem problem{given.title, line.position, line.target, line.inverse_mass, {}};
    for (int i = 0; i < links; ++i)
        problem.rest.push_back((line.position.at(i + 1) - line.position.at(i)).norm());
    return problem;
}

StepProblem scattered(const StepProblem& problem, double share) {
    StepProblem result = problem;
    result.predicted = problem.before;
    std::mt19937 random(1);
    std::normal_distribution<double> some(0, share * problem.rest.front());
    for (int i = 0; i < result.predicted.size(); ++i)
        if (problem.inverse_mass[i] > 0) result.predicted.add(i, {some(random), some(random), some(random)});
    return result;
}

NewtonProjection::NewtonProjection(const StepProblem& problem, Along along)
    : along_(along),
      places_(problem.predicted),
      unit_(static_cast<int>(problem.rest.size())),
      pull_unit_(unit_.size()),
      inverse_mass_(problem.inverse_mass),
      rest_(problem.rest),
      error_(rest_.size()),
      diagonal_(rest_.size()),
      lower_(rest_.size()),
      upper_(rest_.size()) {
    set_directions(problem.before, pull_unit_);
}

void NewtonProjection::iterate() {
    measure();
    eliminate();
    move();
}

/// How far each link is from its length, and what the multipliers around it do about that.
void NewtonProjection::measure() {
    set_directions(places_, unit_);
    if (along_ == Along::now) pull_unit_ = unit_;
    const int n = unit_.size();
    const double *px = places_.x.data(), *py = places_.y.data(), *pz = places_.z.data();
    const double *ux = unit_.x.data(), *uy = unit_.y.data(), *uz = unit_.z.data();
    const double *gx = pull_unit_.x.data(), *gy = pull_unit_.y.data(), *gz = pull_unit_.z.data();
    const double* w = inverse_mass_.data();
    WINDLASS_VECTORISE
    for (int i = 0; i < n; ++i) {
        error_[i] = ux[i] * (px[i + 1] - px[i]) + uy[i] * (py[i + 1] - py[i]) + uz[i] * (pz[i + 1] - pz[i]) -
                    rest_[i];
        diagonal_[i] = (w[i] + w[i + 1]) * (ux[i] * gx[i] + uy[i] * gy[i] + uz[i] * gz[i]);
    }
    WINDLASS_VECTORISE
    for (int i = 1; i < n; ++i)
        lower_[i] = -w[i] * (ux[i] * gx[i - 1] + uy[i] * gy[i - 1] + uz[i] * gz[i - 1]);
    WINDLASS_VECTORISE
    for (int i = 0; i < n - 1; ++i)
        upper_[i] = -w[i + 1] * (ux[i] * gx[i + 1] + uy[i] * gy[i + 1] + uz[i] * gz[i + 1]);
    lower_[0] = upper_[n - 1] = 0;
}

/// error_ becomes the change of the multipliers, kg m.
void NewtonProjection::eliminate() {
    solve_tridiagonal(lower_, diagonal_, upper_, error_);
}

void NewtonProjection::move() {
    const int n = unit_.size();
    const double *w = inverse_mass_.data(), *change = error_.data();
    const auto one = [&](double* p, const double* g) {
        WINDLASS_VECTORISE
        for (int i = 1; i < n; ++i)
            p[i] += w[i] * (change[i] * g[i] - change[i - 1] * g[i - 1]);
        p[0] += w[0] * change[0] * g[0];
        p[n] -= w[n] * change[n - 1] * g[n - 1];
    };
    one(places_.x.data(), pull_unit_.x.data());
    one(places_.y.data(), pull_unit_.y.data());
    one(places_.z.data(), pull_unit_.z.data());
}

} // namespace windlass::lab
