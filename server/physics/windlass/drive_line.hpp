#pragma once
// The last unknown of the chain's solve: how much chain the gypsy gives in a step. Everything that holds,
// brakes or drives the chain on deck meets the chain's pull in one scalar equation, solved exactly, so that
// stick, slip, stall and overhaul come out of it and no spring stands between windlass and chain.

#include "server/physics/base/state_visitor.hpp"
#include "server/physics/solver/chain_solver.hpp"
#include "server/physics/windlass/gearbox.hpp"

#include <array>

namespace windlass::physics {

/// A prime mover's pull before its gear against chain speed: straight pieces that rise with speed, and flat
/// beyond them. As felt at the gypsy's pitch line.
struct MotorPull {
    struct Corner {
        double speed = 0; ///< m/s, paying out positive
        double pull = 0;  ///< N, heaving positive
    };
    std::array<Corner, 4> corners;
    int count = 0; ///< 0: no motor

    /// The next corner; speed and pull not below those of the last.
    void add(double speed, double pull) { corners[count++] = {speed, pull}; }
    /// Pull at a chain speed (m/s), N.
    double at(double speed) const;
    /// Speed at which the pull changes its sign; 0 where it does not.
    double turn() const;
};

/// Chain inboard of the gypsy that is fast somewhere and stretches: a pull against paying out. It does not
/// push, and does not pull by more than it bears.
struct InboardTie {
    double pull = 0;  ///< N at rest; below 0: so much before it comes taut
    double slope = 0; ///< N s/m
    double max = 0;   ///< N; 0: there is none

    /// Pull at a chain speed (m/s), N.
    double at(double speed) const;
    /// Speed at which it comes to so much (N); 0 where it does not.
    double reaches(double load) const { return slope > 0 ? (load - pull) / slope : 0; }
};

/// Everything on deck in one step. Forces in N along the chain, speeds in m/s, paying out positive.
struct DeckLoads {
    double speed = 0;         ///< of the chain before the step
    double gypsy_mass = 0;    ///< kg, gypsy and all that turns with it, and the chain hanging to the locker
    double pipe_mass = 0;     ///< kg, chain between gypsy and lip
    double pipe_weight = 0;   ///< its weight along the chain, pulling outboard
    double locker_weight = 0; ///< of the chain hanging between gypsy and locker, pulling inboard
    double pick_up = 0; ///< N s/m, momentum that chain at rest in the locker takes: mass per metre x speed
    double hawse_efficiency = 1; ///< pull at the gypsy / pull outboard while paying out
    double holding_out = 0;      ///< most that brakes and stopper together hold against paying out
    double holding_in = 0;       ///< ... against heaving in
    double min_speed = -1e3;     ///< end stop: anchor home
    double max_speed = 1e3;      ///< end stop: no chain left
    InboardTie bitter_end, jam;  ///< in the locker; in the spurling pipe
    MotorPull motor;
    Gearbox gear;
    double pipe_length = 0;    ///< m, whose stretch the top link takes over
    double pipe_stiffness = 0; ///< N/m, of the chain between gypsy and lip
    double standing_pull = 0;  ///< that of the last step's DeckResult
};

/// What the step came to.
struct DeckResult {
    double speed = 0;         ///< m/s after the step
    double hawse_tension = 0; ///< N, just outboard of the lip
    double pipe_pull = 0;     ///< N, on the gypsy if the hawse pipe had no friction
    double gypsy_load = 0;    ///< N, on the gypsy
    double standing_pull = 0; ///< N, on the gypsy if it stood: friction keeps it so, and so far, at rest
    double held = 0;          ///< N, by brakes and stopper together; positive against paying out
    double motor = 0;         ///< N, before the gear, heaving positive
    double gear = 0;          ///< N, friction of the gear: the gypsy feels motor + gear
    double bitter_end = 0;    ///< N, by the bitter end's connection in the locker
    double jam = 0;           ///< N, by a jam in the spurling pipe, against paying out
    double end_stop = 0;      ///< N, anchor's seat (negative); rounding
};
template <class Visitor, StateOf<DeckResult> State>
void visit_state(Visitor& v, State& result);

/// Closes the chain's solve with the deck machinery.
class DriveLine final : public UpperEnd {
public:
    explicit DriveLine(const DeckLoads& loads) : loads_(loads) {}
    /// The one at which all on deck balances the chain's pull; 0 where brakes and stopper hold it.
    double speed(const TopLink& link) const override;
    double speed_before() const override { return loads_.speed; }
    double deck_length() const override { return loads_.pipe_length; }
    /// Every load at the solution, given the top link as the chain's solve left it.
    DeckResult result(const TopLink& link) const;

private:
    enum class Direction { out, in };
    double excess(const TopLink& link, double speed, Direction direction) const;

    DeckLoads loads_;
};

} // namespace windlass::physics
