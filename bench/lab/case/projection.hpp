#pragma once
// The nonlinear projection that one step of a position-based method comes to: predicted places are moved, by
// inverse masses, until every link has its length. By Newton's method here; by sweeps in
// bench/methods/pbd_constraints.hpp.

#include "bench/lab/case/case.hpp"

namespace windlass::lab {

using physics::Field;

/// One step as a problem of geometry.
struct StepProblem {
    std::string title;
    Field before;                     ///< m, where the step began
    Field predicted;                  ///< m, where it would end without links: x_0
    std::vector<double> inverse_mass; ///< 1/kg, 0: held
    std::vector<double> rest;         ///< m, of each link: its length when the step began
};

/// The step of dt (s) that begins when the production solver, at 600 steps in a second, has brought the case
/// to the given time (s). Throws std::invalid_argument when it cannot do the case.
StepProblem step_problem(const Case& given, int particles, double time, double dt);

/// The same line, its free particles scattered at random (standard deviation: share of a link, each axis)
/// instead of predicted: errors that differ from particle to particle, where sweeps are at their best.
StepProblem scattered(const StepProblem& problem, double share);

/// Newton's method on the multipliers, a tridiagonal matrix at a time.
class NewtonProjection {
public:
    /// What the multipliers pull along.
    enum class Along {
        start, ///< the links when the step began: the production solver's way
        now    ///< the links as they are in each iteration
    };
    NewtonProjection(const StepProblem& problem, Along along);

    /// Goes on from other places, Along::now.
    void begin(const Field& places) { places_ = places; }
    void iterate();
    const Field& places() const { return places_; }

private:
    void measure();
    void eliminate();
    void move();

    Along along_;
    Field places_, unit_, pull_unit_;
    std::vector<double> inverse_mass_, rest_, error_, diagonal_, lower_, upper_;
};

} // namespace windlass::lab
