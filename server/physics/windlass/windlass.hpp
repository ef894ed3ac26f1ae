#pragma once
// One windlass: hand-wheel and band brake, dog clutch, chain stopper, motor; what they do to the gypsy in
// each step, and what that does to them (heat, wear, trips).

#include "server/physics/base/equipment_faults.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/windlass/band_brake.hpp"
#include "server/physics/windlass/chain_counter.hpp"
#include "server/physics/windlass/chain_stopper.hpp"
#include "server/physics/windlass/dog_clutch.hpp"
#include "server/physics/windlass/drive_line.hpp"
#include "server/physics/windlass/gypsy.hpp"
#include "server/physics/windlass/hawse_friction.hpp"
#include "server/physics/windlass/prime_mover.hpp"
#include "server/physics/windlass/spurling_pipe.hpp"
#include "server/physics/windlass/windlass_def.hpp"

#include <algorithm>

namespace windlass::physics {

/// The levers as the hand left them.
struct WindlassLevers {
    double brake = 1; ///< 0 open .. 1 hard on
    double speed = 0; ///< -1 full lower .. 1 full heave
    bool clutch_in = false;
    bool stopper_closed = false;
    bool emergency_stop = false;
    bool operator==(const WindlassLevers&) const = default;
};
template <class Visitor, StateOf<WindlassLevers> State>
void visit_state(Visitor& v, State& levers);

/// All that changes of a windlass; a plain value.
struct WindlassState {
    double cable_speed = 0; ///< m/s at the gypsy, paying out positive
    double cable_out = 0;   ///< m, hawse pipe lip to anchor shackle
    BandBrakeState brake;
    DogClutchState clutch;
    ChainStopperState stopper;
    PrimeMoverState motor;
    GypsyState gypsy;
    ChainCounterState counter;
    SpurlingPipeState pipe;
    bool bitter_end_parted = false; ///< its connection in the locker did not hold
    bool chain_gone = false;        ///< its end has run over the gypsy, or was slipped
};
template <class Visitor, StateOf<WindlassState> State>
void visit_state(Visitor& v, State& state);

/// Loads of the last step, N at the gypsy's pitch line.
struct WindlassLoads {
    DeckResult deck;
    double brake = 0; ///< by the band brake; positive against paying out
    double stopper = 0;
    double shaft_brake = 0;    ///< by the motor's own brake
    double jam = 0;            ///< by a jam in the spurling pipe, or, negative, the heap above it
    double pockets = 0;        ///< by links jumping over worn pockets
    double brake_capacity = 0; ///< that the band brake could hold against paying out
    double brake_power = 0;    ///< W into the lining
};
template <class Visitor, StateOf<WindlassLoads> State>
void visit_state(Visitor& v, State& loads);

/// Length limits of the cable, m from lip to shackle.
struct CableLimits {
    double home = 0;       ///< no more comes in; below zero the shackle is up the pipe
    double bitter_end = 0; ///< the chain comes taut in the locker
};
template <class Visitor, StateOf<CableLimits> State>
void visit_state(Visitor& v, State& limits);

/// The machine itself: parameters const, state a value, causes given with each step.
class Windlass {
public:
    Windlass(const WindlassDef& def, const ChainDef& chain, const CableLimits& limits, double cable_out);

    /// Levers and causes to loads on deck for the next step of dt (s).
    DeckLoads prepare(double dt, const WindlassLevers& levers, const EquipmentFaults& causes,
                      const CableInHawse& cable = {});
    /// Takes the result of the step: speeds, heat, trips; books into the ledger. stretch: permanent, of the
    /// links on the gypsy: fewer of them pass in a metre.
    void settle(double dt, const DeckResult& result, const EquipmentFaults& causes, EnergyLedger* ledger,
                double stretch = 0);

    /// Chain outboard or in the locker is no more what it was: it ends at the given lengths from now on.
    void limit(const CableLimits& limits) { limits_ = limits; }
    const CableLimits& limits() const { return limits_; }
    /// Cable outboard has stretched by so many metres: more is out, and the gypsy has not turned.
    void lengthen(double metres) {
        state_.cable_out += metres, limits_.bitter_end += metres, state_.pipe.taut_at += metres;
    }

    const WindlassDef& def() const { return def_; }
    const WindlassState& state() const { return state_; }
    WindlassState& state() { return state_; }
    const WindlassLoads& loads() const { return loads_; }

    /// Share of the lining used up, 0..1, with what the causes add to it now.
    double brake_wear(const EquipmentFaults& causes) const { return lining_wear(state_.brake, causes); }
    /// m of cable out as the chain counter has it.
    double counter_reading() const { return physics::counter_reading(chain_diameter_, state_.counter); }
    /// Motor winding, K.
    double motor_temperature() const { return physics::motor_temperature(def_, state_.motor); }
    /// kg at the pitch line: gypsy; motor and gear as felt there.
    double gypsy_mass() const;
    double motor_mass() const;
    /// kg at the pitch line, of what turns with the chain: gypsy and what is coupled to it.
    double turning_mass() const;
    /// m up the hawse pipe from the lip at which the cable's upper end is, drawn in.
    double drawn_in() const { return std::max(0.0, min_outboard_ - state_.cable_out); }
    /// kg, of chain between locker and the upper end of what is outboard, which runs.
    double inboard_mass() const {
        return chain_mass_ * (def_.hawse_pipe_length - drawn_in() + hanging_in_locker());
    }
    double locker_weight() const; ///< N, of it on the gypsy: what is below a jam hangs on that
    /// m of chain hanging below the gypsy into the locker: less of it once the bitter end has come up.
    double hanging_in_locker() const;
    /// N m, weight times height above the lip of all chain that is inboard; chain at rest lies in the locker.
    double inboard_potential() const;

    /// What one step leaves to the next: the loads decide what the levers can do.
    template <class Visitor, StateOf<Windlass> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    /// Most that each holds in a step, N: what prepare() finds, and settle() shares the load out by.
    struct Capacities {
        BrakeGrip brake;
        double stopper_out = 0, stopper_in = 0; ///< against paying out, and against heaving in
        double shaft_brake = 0, pockets = 0;    ///< either way
        double heap = 0;                        ///< against heaving in
    };

    double drawn_up() const; ///< m, height of the drawn in end above the lip
    bool move_levers(double dt, const WindlassLevers& levers, const EquipmentFaults& causes);
    void share_out(const DeckResult& deck);

    const WindlassDef def_;
    const double chain_diameter_;  ///< m
    const double chain_mass_;      ///< kg/m
    const double chain_stiffness_; ///< N, EA
    const double breaking_load_;   ///< N, of the chain
    const double min_outboard_;    ///< m

    CableLimits limits_;
    WindlassState state_;
    WindlassLoads loads_;

    Capacities capacities_; ///< of the step under way
    double turned_ = 0;     ///< kg, turning mass of the last step; for the ledger
};

} // namespace windlass::physics
