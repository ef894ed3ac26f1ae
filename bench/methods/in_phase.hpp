#pragma once
// The server's step carried to fourth order, for taut, undamped chain in air that touches nothing: what its
// chart needs to be held against leapfrog at a few links, and no exercise's chain can have.
//
// Lengthwise. With Newmark's mean pull F = T + d2T / 4, d2T = T(n+1) - 2 T(n) + T(n-1), a mode of x = (w
// dt)^2 is late by x / 12 of its phase: most of what a swing errs by. T + d2T / 12 is of fourth order
// (Numerov; Hairer, Norsett, Wanner 1993, III.10), but not stable for stiff modes, x > 6. So the difference,
// d2T / 6, is taken off only after it has passed twice through U = 1 / (1 + x / 4), which is what Newmark's
// matrix makes of tensions, F = U T:
//     F - U U d2T / 6,  and T(n+1), as the lengths then have it, more by 4 (U - U U) d2T / 6.
// The phase then errs by 0.033 x^2. Of a mode a step makes 4 sin^2(w' dt / 2) = 4 (1 - U)(1 + 2/3 U (1 - U)),
// never beyond 4: stable for every x; and the same forwards and backwards, so that energy stays.
//
// Crosswise. The links pull along the directions that they have at x + dt^2 / 12 d2x/dt^2 instead of x: the
// leapfrog of fourth order, up to a change of variables (Takahashi, Imada 1984).

#include "server/physics/chain/chain.hpp"
#include "server/physics/chain/step_time.hpp"

#include <vector>

namespace windlass::lab {

/// Takes such steps of a chain whose top is held. Holds only memory to work in.
class InPhaseStep {
public:
    /// bed_depth: of the seabed, m.
    InPhaseStep(const physics::ChainDef& def, double bed_depth, int links);

    /// One step of dt (s), as ChainSolver takes it in two halves. False, and the state as it was, where it is
    /// not of the kind: another size than the last, a link that is or was or would be slack, a node in the
    /// seabed, a tension that changes by more than a tenth, Newton's method at no end.
    bool step(physics::ChainState& state, double dt, const physics::ChainTail& tail,
              const physics::Vec3& hawse);

private:
    bool begin(const physics::ChainState& state, double dt, const physics::ChainTail& tail,
               const physics::Vec3& hawse);
    void lead_directions(const physics::ChainState& state);
    bool solve(const physics::ChainState& state);
    bool keep_phase(const physics::ChainState& state);
    void place_nodes(int links);
    void pass(const physics::ChainState& state, std::vector<double>& tensions);

    physics::ChainDef def_;
    double bed_depth_;
    double reach_ = 0;                 ///< s2, dt times the kick
    std::vector<double> inverse_;      ///< 1/kg, of each node
    physics::Field free_, placed_;     ///< m, the nodes without pulls and with them
    physics::Field direction_, led_;   ///< of each link
    std::vector<double> known_, pull_; ///< N, the mean pull's known part, and all of it
    std::vector<double> lower_, diagonal_, upper_, upper_left_, right_; ///< Newton's matrix
    std::vector<double> once_, twice_; ///< N, what passed through the matrix so often
};

} // namespace windlass::lab
