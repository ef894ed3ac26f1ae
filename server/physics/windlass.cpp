#include "server/physics/windlass.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kStandstill = 0.05;  ///< m/s, chain as good as stopped: a stopper bar can be dropped
constexpr double kLooseShare = 0.05;  ///< share of rated pull below which teeth slide apart and a bar lifts
constexpr double kOverloadTrip = 180; ///< s: twice the rated pull for a minute, 1.5 times for 2.4 min (UR
                                      ///< A3 3.1.3 wants 2 min)
constexpr double kDroopSpeed = 0.02;  ///< m/s, slip of the drive at its full pull; tuned
constexpr double kEmergencyBrakeTime = 0.5; ///< s, spring-applied band brake from open to hard on; tuned
constexpr double kLiningLife = 4e9; ///< J a lining takes before it is used up; tuned: some hundred anchorings

double toward(double value, double target, double most) {
    return value + std::clamp(target - value, -most, most);
}

} // namespace

Windlass::Windlass(const WindlassDef& def, const ChainDef& chain, const CableLimits& limits, double cable_out)
    : def_(def), chain_mass_(chain.mass_per_metre), limits_(limits) {
    state_.cable_out = cable_out;
    state_.lining_temperature = state_.drum_temperature = def.air_temperature;
}

double Windlass::gypsy_mass() const {
    return def_.gypsy_inertia / (def_.gypsy_radius * def_.gypsy_radius);
}

double Windlass::motor_mass() const {
    const double ratio = def_.gear_ratio / def_.gypsy_radius;
    return def_.motor_inertia * ratio * ratio;
}

double Windlass::kinetic_energy() const {
    const double mass = gypsy_mass() + (state_.clutch == Clutch::in ? motor_mass() : 0) +
                        chain_mass_ * (def_.hawse_pipe_length + def_.locker_lift);
    return 0.5 * mass * state_.cable_speed * state_.cable_speed;
}

double Windlass::motor_temperature() const {
    constexpr double kRiseToTrip = 100; // K above the air when the I2t count trips: class F winding; tuned
    return def_.air_temperature + kRiseToTrip * std::min(1.0, state_.overload / kOverloadTrip);
}

double Windlass::brake_wear() const {
    return std::min(1.0, state_.brake_energy / kLiningLife);
}

double Windlass::brake_capacity(double position, double lining_temperature, double lining_faded) const {
    // Band brake: T1 / T2 = e^(mu theta); the force is the tight side less the slack side, and the hand-wheel
    // sets the slack side. The rating is that of a cold, dry, sound lining.
    const double heat = std::clamp((lining_temperature - def_.brake_fade_start) /
                                       (def_.brake_fade_end - def_.brake_fade_start),
                                   0.0, 1.0);
    const double friction =
        def_.brake_friction * (1 - heat * (1 - def_.brake_fade_residual)) * (1 - lining_faded);
    const auto grip = [&](double mu) { return std::expm1(mu * def_.brake_wrap); };
    return position * def_.brake_rating * grip(friction) / grip(def_.brake_friction);
}

double Windlass::motor_limit(double speed) const {
    // Constant power above the rated speed, falling from stall to rated pull below it.
    const double v = std::abs(speed);
    if (v > def_.rated_speed) return def_.rated_pull * def_.rated_speed / v;
    return def_.stall_pull + (def_.rated_pull - def_.stall_pull) * v / def_.rated_speed;
}

void Windlass::move_levers(double dt, const WindlassLevers& levers, const WindlassCauses& causes) {
    const double brake_time = levers.emergency_stop ? kEmergencyBrakeTime : def_.brake_travel_time;
    state_.brake_position =
        toward(state_.brake_position, levers.emergency_stop ? 1 : levers.brake, dt / brake_time);

    const bool still = std::abs(state_.cable_speed) < kStandstill;
    const double loose = kLooseShare * def_.rated_pull;
    state_.stopper_refused = false;
    if (levers.stopper_closed != state_.stopper_closed) {
        const bool free = levers.stopper_closed ? still : std::abs(loads_.stopper) < loose;
        if (free) state_.stopper_closed = levers.stopper_closed;
        state_.stopper_refused = !free;
    }

    const double through_clutch = std::abs(loads_.deck.motor + loads_.shaft_brake);
    state_.clutch_refused = false;
    if (levers.clutch_in && state_.clutch != Clutch::in) {
        const bool in_step = std::abs(state_.cable_speed - state_.motor_speed) < def_.clutch_engage_speed;
        state_.clutch = in_step ? Clutch::in : Clutch::engaging;
        state_.clutch_refused = !in_step;
    } else if (!levers.clutch_in && state_.clutch == Clutch::in) {
        if (through_clutch < loose) state_.clutch = Clutch::out; // loaded teeth cannot be drawn
        state_.clutch_refused = state_.clutch == Clutch::in;
    } else if (!levers.clutch_in) {
        state_.clutch = Clutch::out;
    }
    if (causes.clutch_worn > 0 && state_.clutch == Clutch::in &&
        through_clutch >= (1 - causes.clutch_worn) * def_.rated_pull) {
        state_.clutch = Clutch::engaging; // jumped out; goes in again when the chain stands
    }

    if (state_.tripped && levers.speed == 0) state_.tripped = false, state_.overload = 0;
    powered_ = causes.power_lost < 1 && !state_.tripped && !levers.emergency_stop;
    const double aim = powered_ ? -levers.speed * def_.light_line_speed : 0;
    state_.motor_target =
        toward(state_.motor_target, aim, dt * def_.light_line_speed / def_.motor_power_time);
}

DeckLoads Windlass::prepare(double dt, const WindlassLevers& levers, const WindlassCauses& causes) {
    move_levers(dt, levers, causes);

    loads_.brake_capacity =
        brake_capacity(state_.brake_position, state_.lining_temperature, causes.lining_faded);
    brake_out_ = loads_.brake_capacity;
    // The band winds itself on while paying out; heaving in it has only the slack side's share.
    brake_in_ = brake_out_ * std::exp(-def_.brake_friction * def_.brake_wrap);
    stopper_ = state_.stopper_closed ? def_.stopper_rating : 0;
    const bool driving = powered_ && state_.motor_target != 0;
    const bool engaged = state_.clutch == Clutch::in;
    shaft_brake_ = engaged && !driving ? def_.shaft_brake_rating : 0;

    DeckLoads deck;
    deck.speed = state_.cable_speed;
    deck.gypsy_mass = gypsy_mass() + chain_mass_ * def_.locker_lift + (engaged ? motor_mass() : 0);
    deck.pipe_mass = chain_mass_ * def_.hawse_pipe_length;
    deck.pipe_weight = chain_mass_ * kGravity * def_.hawse_pipe_height;
    deck.locker_weight = chain_mass_ * kGravity * def_.locker_lift;
    deck.pick_up = chain_mass_ * std::max(0.0, state_.cable_speed);
    deck.hawse_efficiency = def_.hawse_efficiency;
    deck.holding_out = brake_out_ + stopper_ + shaft_brake_;
    deck.holding_in = brake_in_ + stopper_ + shaft_brake_;
    deck.least_speed = (limits_.home - state_.cable_out) / dt;
    deck.most_speed = (limits_.bitter_end - state_.cable_out) / dt;
    deck.pipe_length = def_.hawse_pipe_length;
    deck.last_direction = state_.last_direction;
    if (engaged && driving) {
        deck.motor.target_speed = state_.motor_target;
        deck.motor.droop = def_.stall_pull / kDroopSpeed;
        deck.motor.limit = motor_limit(state_.cable_speed) * (1 - causes.power_lost);
    }
    return deck;
}

void Windlass::settle(double dt, const DeckResult& deck, EnergyLedger* ledger) {
    const double speed_before = state_.cable_speed;
    // Force times mean speed of the step: what a force takes from leapfrog's kinetic energy.
    const double moved = 0.5 * (deck.speed + speed_before) * dt;
    loads_.deck = deck;

    // The band brake takes the load first, the stopper what it does not hold, the shaft brake the rest: so a
    // stopper dropped behind a set brake is loose until the brake gives, as on board.
    const bool out = deck.held >= 0;
    const double held = std::abs(deck.held), sign = out ? 1 : -1;
    const double brake = std::min(held, out ? brake_out_ : brake_in_);
    const double stopper = std::min(held - brake, stopper_);
    loads_.brake = sign * brake;
    loads_.stopper = sign * stopper;
    loads_.shaft_brake = sign * std::min(held - brake - stopper, shaft_brake_);
    loads_.brake_power = std::max(0.0, loads_.brake * moved / dt);

    // Two thermal nodes: the lining's skin, and the drum behind it.
    const double heat = loads_.brake_power * dt;
    const double inward =
        def_.lining_conductance * (state_.lining_temperature - state_.drum_temperature) * dt;
    const double outward = def_.drum_cooling * (state_.drum_temperature - def_.air_temperature) * dt;
    state_.lining_temperature += (heat - inward) / def_.lining_heat_capacity;
    state_.drum_temperature += (inward - outward) / def_.drum_heat_capacity;
    state_.brake_energy += heat;

    state_.cable_speed = deck.speed;
    state_.cable_out += deck.speed * dt;
    if (deck.speed != 0) state_.last_direction = deck.speed > 0 ? 1 : -1;
    // Out of gear the motor runs light at what it is told.
    state_.motor_speed = state_.clutch == Clutch::in ? deck.speed : state_.motor_target;
    const double share = deck.motor / def_.rated_pull;
    state_.overload = std::max(0.0, state_.overload + (share * share - 1) * dt);
    if (state_.overload > kOverloadTrip) state_.tripped = true;

    if (ledger == nullptr) return;
    ledger->brake += heat;
    ledger->stopper += loads_.stopper * moved;
    ledger->shaft_brake += loads_.shaft_brake * moved;
    ledger->motor += deck.motor * moved;
    ledger->hawse += (deck.pipe_pull - deck.gypsy_load) * moved;
    ledger->end_stop += deck.end_stop * moved;
    // Half of what the chain takes to be jerked from rest becomes its motion, half is lost (inelastic).
    ledger->pick_up += 0.5 * chain_mass_ * std::max(0.0, speed_before) * std::max(0.0, deck.speed) * moved;
}

} // namespace windlass::physics
