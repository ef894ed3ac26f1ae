#include "server/physics/windlass/windlass.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/chain/cable_twist.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace windlass::physics {

Windlass::Windlass(const WindlassDef& def, const ChainDef& chain, const CableLimits& limits, double cable_out)
    : def_(def),
      chain_diameter_(chain.diameter),
      chain_mass_(chain.mass_per_metre),
      chain_stiffness_(chain.stiffness),
      breaking_load_(breaking_load(chain)),
      min_outboard_(home_length(chain)),
      limits_(limits) {
    state_.cable_out = cable_out;
    state_.counter.zero = cable_out + def.counter_offset;
    state_.brake.skin = state_.brake.shell = state_.brake.drum = kAirTemperature;
}

double Windlass::gypsy_mass() const {
    return def_.gypsy_inertia / (def_.gypsy_radius * def_.gypsy_radius);
}

double Windlass::motor_mass() const {
    const double ratio = kGearRatio / def_.gypsy_radius;
    return def_.motor_inertia * ratio * ratio;
}

double Windlass::hanging_in_locker() const {
    return std::clamp(limits_.bitter_end + def_.locker_lift - state_.cable_out, 0.0, def_.locker_lift);
}

double Windlass::locker_weight() const {
    const double hanging = hanging_in_locker();
    return chain_mass_ * kGravity * (hanging - hanging_on_jam(state_.pipe, hanging));
}

double Windlass::turning_mass() const {
    if (state_.gypsy.jumping) return 0; // links jump over a gypsy that stands
    const bool engaged = state_.clutch.position == Clutch::in && !state_.motor.burst;
    return gypsy_mass() + (engaged ? motor_mass() : 0);
}

double Windlass::inboard_potential() const {
    const double hanging = hanging_in_locker(), gypsy = def_.hawse_pipe_height;
    const double heaped = std::max(0.0, limits_.bitter_end - state_.cable_out);
    return chain_mass_ * kGravity *
           (heaped * (gypsy - def_.locker_lift) + hanging * (gypsy - 0.5 * hanging) +
            (def_.hawse_pipe_length - drawn_in()) * 0.5 * (gypsy + drawn_up()));
}

/// The pipe is as steep as its length and height make it.
double Windlass::drawn_up() const {
    return drawn_in() * def_.hawse_pipe_height / def_.hawse_pipe_length;
}

/// Moves what the levers move. Whether the drive has power.
bool Windlass::move_levers(double dt, const WindlassLevers& levers, const EquipmentFaults& causes) {
    if (const double free = 1 - causes.brake_seized; free > 0)
        turn_hand_wheel(def_, free * dt, levers.brake, levers.emergency_stop, state_.brake);
    // What has seized is left as it is, whatever is wanted of it.
    const bool jammed = causes.stopper_jammed > 0, stuck = causes.clutch_seized > 0;
    work_stopper(def_, jammed ? state_.stopper.closed : levers.stopper_closed, state_.cable_speed,
                 loads_.stopper, causes, state_.stopper);
    if (jammed) state_.stopper.refused = levers.stopper_closed != state_.stopper.closed;
    work_clutch(def_, dt, stuck ? state_.clutch.position == Clutch::in : levers.clutch_in,
                state_.cable_speed - state_.motor.speed,
                loads_.deck.motor + loads_.deck.gear + loads_.shaft_brake, causes, state_.clutch);
    if (stuck) state_.clutch.refused = levers.clutch_in != (state_.clutch.position == Clutch::in);

    const bool off = levers.emergency_stop || causes.power_lost >= 1;
    guard_restart(off, levers.speed == 0, state_.motor);
    const bool powered = has_power(def_, state_.motor, causes);
    // While the claws seek their gaps, the drive turns the shaft over slowly: with three windings in jerks.
    const bool seeking = state_.clutch.position == Clutch::engaging && levers.speed == 0;
    const double wanted = seeking ? -kInchingSpeed : lever_speed(def_, levers.speed);
    follow_lever(def_, dt, wanted, powered, state_.motor);
    return powered;
}

DeckLoads Windlass::prepare(double dt, const WindlassLevers& levers, const EquipmentFaults& causes,
                            const CableInHawse& cable) {
    assert(dt > 0 && "a step takes time");
    assert(levers.brake >= 0 && levers.brake <= 1 && "the hand-wheel has stops");
    assert(levers.speed >= -1 && levers.speed <= 1 && "the lever has stops");
    const bool powered = move_levers(dt, levers, causes);

    const bool engaged = state_.clutch.position == Clutch::in && !state_.motor.burst;
    const bool driving = powered && state_.motor.target != 0;
    Capacities& holds = capacities_;
    holds = {.brake = brake_grip(def_, state_.brake, causes),
             .stopper_out = stopper_holds_out(def_, state_.stopper),
             .stopper_in = stopper_holds_in(def_, stopper_play(chain_diameter_), state_.stopper),
             .shaft_brake = engaged && !driving ? def_.shaft_brake_rating : 0};
    loads_.brake_capacity = holds.brake.out;
    if (state_.gypsy.jumping) { // neither brake nor shaft reach the chain
        holds.pockets = jumping_drag(def_, causes);
        holds.brake = {};
        holds.shaft_brake = 0;
    }

    const double hanging = hanging_in_locker();

    DeckLoads deck;
    deck.speed = state_.cable_speed;
    deck.gypsy_mass = turning_mass() + chain_mass_ * hanging;
    deck.pipe_mass = chain_mass_ * (def_.hawse_pipe_length - drawn_in());
    deck.pipe_weight = chain_mass_ * kGravity * (def_.hawse_pipe_height - drawn_up());
    deck.pick_up = hanging < def_.locker_lift ? 0 : chain_mass_ * std::max(0.0, state_.cable_speed);
    deck.hawse_efficiency = hawse_efficiency(cable.bend) * twisted_efficiency(cable.twist);
    const PipeLoads pipe =
        work_spurling_pipe(state_.chain_gone ? 0 : causes.pipe_jammed * breaking_load_,
                           {.out = state_.cable_out,
                            .stiffness = chain_stiffness_,
                            .mass = deck.gypsy_mass,
                            .below = chain_mass_ * kGravity * std::max(0.0, hanging - kToJam)},
                           dt, state_.pipe);
    deck.locker_weight = locker_weight();
    deck.jam = pipe.jam;
    holds.heap = pipe.heap;
    deck.holding_out = holds.brake.out + holds.stopper_out + holds.shaft_brake + holds.pockets;
    deck.holding_in = holds.brake.in + holds.stopper_in + holds.shaft_brake + holds.pockets + holds.heap;
    deck.min_speed = (limits_.home - state_.cable_out) / dt;
    deck.max_speed = (limits_.bitter_end + def_.locker_lift - state_.cable_out) / dt;
    if (state_.chain_gone) deck.min_speed = deck.max_speed = 0;
    if (!state_.bitter_end_parted && !state_.chain_gone) {
        // Above its strength it parts, but not before the step is over.
        deck.bitter_end = tie({.stiffness = chain_stiffness_,
                               .length = def_.locker_lift,
                               .stretch = state_.cable_out - limits_.bitter_end,
                               .mass = deck.gypsy_mass,
                               .holds = std::numeric_limits<double>::infinity()},
                              dt);
    }
    deck.pipe_length = def_.hawse_pipe_length;
    deck.pipe_stiffness = chain_stiffness_ / def_.hawse_pipe_length;
    deck.standing_pull = loads_.deck.standing_pull;
    if (engaged && driving && !state_.gypsy.jumping) {
        deck.motor = prime_mover_pull(def_, state_.motor, causes);
        deck.gear = {kGearEfficiency, kGearEfficiencyBack};
    }
    return deck;
}

void Windlass::share_out(const DeckResult& deck) {
    // The band brake takes the load first, the stopper what it does not hold, the shaft brake the rest: so a
    // stopper dropped behind a set brake is loose until the brake gives, as on board.
    const Capacities& holds = capacities_;
    const bool out = deck.held >= 0;
    const double held = std::abs(deck.held), sign = out ? 1 : -1;
    const double pockets = std::min(held, holds.pockets);
    const double heap = std::min(held - pockets, out ? 0 : holds.heap), apart = pockets + heap;
    const double brake = std::min(held - apart, out ? holds.brake.out : holds.brake.in);
    const double stopper = std::min(held - apart - brake, out ? holds.stopper_out : holds.stopper_in);
    loads_.deck = deck;
    loads_.pockets = sign * pockets;
    loads_.jam = deck.jam - heap;
    loads_.brake = sign * brake;
    loads_.stopper = sign * stopper;
    loads_.shaft_brake = sign * std::min(held - apart - brake - stopper, holds.shaft_brake);
}

void Windlass::settle(double dt, const DeckResult& deck, const EquipmentFaults& causes, EnergyLedger* ledger,
                      double stretch) {
    assert(dt > 0 && "a step takes time");
    assert(!(stretch < 0) && "chain grows longer only");
    const double speed_before = state_.cable_speed;
    // Force times mean speed of the step: what a force takes from leapfrog's kinetic energy.
    const double moved = 0.5 * (deck.speed + speed_before) * dt;
    share_out(deck);
    const double heat = std::max(0.0, loads_.brake * moved);
    const double turning = turning_mass();
    loads_.brake_power = heat / dt;
    heat_brake(def_, dt, heat, causes, state_.brake);

    state_.cable_speed = deck.speed;
    state_.cable_out += deck.speed * dt;
    count_chain(chain_diameter_, deck.speed * dt / (1 + stretch), state_.gypsy.jumping, causes,
                state_.counter);
    turn_gypsy(chain_diameter_, dt, deck.speed * dt, state_.gypsy);
    follow_chain(deck.speed * dt, stopper_play(chain_diameter_), state_.stopper);
    // Out of gear the motor runs light at what it is told.
    const bool engaged = state_.clutch.position == Clutch::in;
    state_.motor.speed = state_.motor.burst ? 0 : engaged ? deck.speed : state_.motor.target;
    strain_prime_mover(def_, dt, deck.motor, engaged && !state_.gypsy.jumping, causes, state_.motor);
    if (deck.bitter_end > def_.bitter_end_strength * (1 - causes.bitter_end_weak))
        state_.bitter_end_parted = true;
    if (causes.cable_slipped > 0 || state_.cable_out >= limits_.bitter_end + def_.locker_lift - 1e-6) {
        state_.chain_gone = true;
        state_.cable_speed = 0;
    }
    watch_pockets(def_, deck.speed,
                  deck.gypsy_load - loads_.stopper - deck.end_stop - deck.bitter_end - loads_.jam, causes,
                  state_.gypsy);

    const double turned = std::exchange(turned_, turning);
    if (ledger == nullptr) return;
    ledger->coupling += 0.5 * (turned - turning) * speed_before * speed_before;
    ledger->brake += heat;
    ledger->stopper += loads_.stopper * moved;
    ledger->shaft_brake += loads_.shaft_brake * moved;
    ledger->pockets += loads_.pockets * moved;
    // Potential energy has the whole chain move with the gypsy; the jam keeps what hangs below it.
    const double hanging = hanging_in_locker();
    ledger->jam += (loads_.jam - chain_mass_ * kGravity * hanging_on_jam(state_.pipe, hanging)) * moved;
    ledger->motor += deck.motor * moved;
    ledger->gear += deck.gear * moved;
    ledger->hawse += (deck.pipe_pull - deck.gypsy_load) * moved;
    ledger->end_stop += (deck.end_stop + deck.bitter_end) * moved;
    // Half of what the chain takes to be jerked from rest becomes its motion, half is lost (inelastic).
    ledger->pick_up += 0.5 * chain_mass_ * std::max(0.0, speed_before) * std::max(0.0, deck.speed) * moved;
}

template <class Visitor, StateOf<Windlass> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.state_, self.loads_, self.limits_);
}
WINDLASS_STATE_LISTED(Windlass);

template <class Visitor, StateOf<CableLimits> State>
void visit_state(Visitor& v, State& limits) {
    auto& [home, bitter_end] = limits;
    WINDLASS_STATE(v, home, bitter_end);
    WINDLASS_WITHIN(v, -kFarthest, kFarthest, home, bitter_end);
}
WINDLASS_STATE_LISTED(CableLimits);

template <class Visitor, StateOf<WindlassLevers> State>
void visit_state(Visitor& v, State& levers) {
    auto& [brake, speed, clutch_in, stopper_closed, emergency_stop] = levers;
    WINDLASS_STATE(v, brake, speed, clutch_in, stopper_closed, emergency_stop);
    v.within({"brake"}, brake, 0, 1);
    v.within({"speed"}, speed, -1, 1);
}
WINDLASS_STATE_LISTED(WindlassLevers);

template <class Visitor, StateOf<WindlassState> State>
void visit_state(Visitor& v, State& state) {
    auto& [cable_speed, cable_out, brake, clutch, stopper, motor, gypsy, counter, pipe, bitter_end_parted,
           chain_gone] = state;
    WINDLASS_STATE(v, cable_speed, cable_out, brake, clutch, stopper, motor, gypsy, counter, pipe,
                   bitter_end_parted, chain_gone);
    WINDLASS_WITHIN(v, -kFastest, kFastest, cable_speed);
}
WINDLASS_STATE_LISTED(WindlassState);

template <class Visitor, StateOf<WindlassLoads> State>
void visit_state(Visitor& v, State& loads) {
    auto& [deck, brake, stopper, shaft_brake, jam, pockets, brake_capacity, brake_power] = loads;
    WINDLASS_STATE(v, deck, brake, stopper, shaft_brake, jam, pockets, brake_capacity, brake_power);
    WINDLASS_WITHIN(v, -kStrongest, kStrongest, brake, stopper, shaft_brake, jam, pockets, brake_capacity,
                    brake_power);
}
WINDLASS_STATE_LISTED(WindlassLoads);

} // namespace windlass::physics
