#pragma once
// One windlass: hand-wheel and band brake, dog clutch, chain stopper, motor; what they do to the gypsy in
// each step, and what that does to them (heat, wear, trips).

#include "server/physics/drive_line.hpp"
#include "server/physics/windlass_def.hpp"

namespace windlass::physics {

/// The levers as the hand left them.
struct WindlassLevers {
    double brake = 1; ///< 0 open .. 1 hard on
    double speed = 0; ///< -1 full lower .. 1 full heave
    bool clutch_in = false;
    bool stopper_closed = false;
    bool emergency_stop = false;
};

/// What is wrong with the machine: causes, each 0 (sound) to 1 (gone).
struct WindlassCauses {
    double lining_faded = 0;   ///< share of the lining's friction that is lost
    double power_lost = 0;     ///< share of the motor's pull that is lost
    double clutch_worn = 0;    ///< dog clutch jumps out above (1 - this) x rated pull; 0: never
    double load_cell_dead = 0; ///< share of the load that the cell does not show
};

enum class Clutch { out, engaging, in };

/// All that changes of a windlass; a plain value.
struct WindlassState {
    double cable_speed = 0;        ///< m/s at the gypsy, paying out positive
    double cable_out = 0;          ///< m, hawse pipe lip to anchor shackle
    int last_direction = 1;        ///< +1 last paid out, -1 last hove in
    double brake_position = 1;     ///< 0..1, where the hand-wheel is
    double lining_temperature = 0; ///< K
    double drum_temperature = 0;   ///< K
    double brake_energy = 0;       ///< J since the start
    Clutch clutch = Clutch::out;
    bool stopper_closed = false;
    double motor_speed = 0;  ///< m/s at the pitch line, paying out positive: what the motor turns at
    double motor_target = 0; ///< m/s, what the drive aims at
    double overload = 0;     ///< s, I2t count: rises with (pull / rated)^2 - 1
    bool tripped = false;
    bool clutch_refused = false;  ///< asked for but the teeth cannot go in or out
    bool stopper_refused = false; ///< asked for but the chain runs, or its bar is loaded
};

/// Loads of the last step, N at the gypsy's pitch line.
struct WindlassLoads {
    DeckResult deck;
    double brake = 0; ///< by the band brake; positive against paying out
    double stopper = 0;
    double shaft_brake = 0;    ///< by the motor's own brake
    double brake_capacity = 0; ///< that the band brake could hold against paying out
    double brake_power = 0;    ///< W into the lining
};

/// Length limits of the cable, m from lip to shackle.
struct CableLimits {
    double home = 0;       ///< anchor hard up in its seat
    double bitter_end = 0; ///< all out
};

/// The machine itself: parameters const, state a value, causes set from outside.
class Windlass {
public:
    Windlass(const WindlassDef& def, const ChainDef& chain, const CableLimits& limits, double cable_out);

    /// Levers and causes to loads on deck for the next step of dt (s).
    DeckLoads prepare(double dt, const WindlassLevers& levers, const WindlassCauses& causes);
    /// Takes the result of the step: speeds, heat, trips; books into the ledger.
    void settle(double dt, const DeckResult& result, EnergyLedger* ledger);

    const WindlassDef& def() const { return def_; }
    const WindlassState& state() const { return state_; }
    WindlassState& state() { return state_; }
    const WindlassLoads& loads() const { return loads_; }

    /// Largest brake force against paying out at a hand-wheel position (0..1) and lining temperature (K), N.
    double brake_capacity(double position, double lining_temperature, double lining_faded) const;
    /// Share of the lining used up, 0..1.
    double brake_wear() const;
    /// Motor winding, K: rises with the overload count (see overload) up to the trip.
    double motor_temperature() const;
    /// Largest motor pull at a chain speed (m/s), N.
    double motor_limit(double speed) const;
    /// kg at the pitch line: gypsy; motor and gear as felt there.
    double gypsy_mass() const;
    double motor_mass() const;
    /// Kinetic energy of what turns and runs on deck, J.
    double kinetic_energy() const;

private:
    void move_levers(double dt, const WindlassLevers& levers, const WindlassCauses& causes);

    WindlassDef def_;
    double chain_mass_; ///< kg/m
    CableLimits limits_;
    WindlassState state_;
    WindlassLoads loads_;
    double brake_out_ = 0, brake_in_ = 0, stopper_ = 0, shaft_brake_ = 0; ///< N, capacities of this step
    bool powered_ = true;
};

} // namespace windlass::physics
