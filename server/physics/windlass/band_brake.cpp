#include "server/physics/windlass/band_brake.hpp"

#include "server/physics/base/state_limits.hpp"
#include "server/physics/base/units.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace windlass::physics {

namespace {

constexpr double kEmergencyTime = 0.5; ///< s, spring-applied band from open to hard on; tuned
constexpr double kWetLoss = 0.45;  ///< of the friction, under a full film: 0.15-0.25 wet for 0.30-0.40 dry
constexpr double kGlazeLoss = 0.3; ///< of the friction, fully glazed; tuned
constexpr double kGlazeTime = 60;  ///< s at the end of fading that glaze a lining fully; tuned
constexpr double kBoiling = kelvin_from_celsius(100);
constexpr double kFilmHeat = 1.1e6;    ///< J to boil off a full film: half a litre at 2.26 MJ/kg; tuned
constexpr double kDryingRate = 2e3;    ///< W/K, skin above boiling point to a full film; tuned
constexpr double kWettingTime = 5;     ///< s, spray to a full film; tuned
constexpr double kThreadRunsOut = 0.5; ///< wear that the hand-wheel's thread can still take up; tuned
constexpr double kLiningLife = 4e9; ///< J a lining takes before it is used up; tuned: some hundred anchorings
constexpr double kTensionOnRivets = .3; ///< of the band's tension, lining gone; tuned

// Steel of the drum, and the layers of its track: so thick, and heat goes so far from the middle of one to
// the next, that under a steady heat the skin follows 2 q sqrt(t / (pi k rho c)) (Carslaw and Jaeger, heat
// into thick steel) within 6 % from 0.5 to 100 s. Fitted to that; a stop lasts a second or two, a cable is
// ridden for minutes.
constexpr double kSteelConductivity = 50;                        ///< W/(m K)
constexpr double kSteelHeat = 3.6e6;                             ///< J/(m3 K)
constexpr double kSkinDepth = 1.85e-3, kShellDepth = 13.6e-3;    ///< m
constexpr double kSkinToShell = 5.94e-3, kShellToDrum = 34.8e-3; ///< m

} // namespace

BrakeHeatCapacity brake_heat_capacity(const WindlassDef& def) {
    return {.skin = kSteelHeat * kSkinDepth * def.brake_track_area,
            .shell = kSteelHeat * kShellDepth * def.brake_track_area,
            .drum = def.drum_heat_capacity};
}

double stored_heat(const WindlassDef& def, const BandBrakeState& state) {
    const BrakeHeatCapacity capacity = brake_heat_capacity(def);
    return capacity.skin * (state.skin - kAirTemperature) + capacity.shell * (state.shell - kAirTemperature) +
           capacity.drum * (state.drum - kAirTemperature);
}

double grip_share(const WindlassDef& def, double position) {
    const double closed = (position - def.brake_free_play) / (1 - def.brake_free_play);
    return closed > 0 ? std::pow(closed, def.brake_stiffening) : 0;
}

double position_of_grip(const WindlassDef& def, double share) {
    return def.brake_free_play + (1 - def.brake_free_play) * std::pow(share, 1 / def.brake_stiffening);
}

double lining_friction(const BandBrakeState& state, const EquipmentFaults& causes) {
    const double glaze = std::max(state.glaze, causes.lining_glazed);
    const double fading = std::clamp((state.skin - kFadeStart) / (kFadeEnd - kFadeStart), 0.0, 1.0);
    return kLiningFriction * (1 - fading * (1 - kFadeResidual)) * (1 - kWetLoss * state.water) *
           (1 - kGlazeLoss * glaze) * (1 - causes.lining_faded);
}

double lining_wear(const BandBrakeState& state, const EquipmentFaults& causes) {
    return std::min(1.0, state.heat / kLiningLife + causes.lining_worn);
}

BrakeGrip brake_grip(const WindlassDef& def, const BandBrakeState& state, const EquipmentFaults& causes) {
    // T1 / T2 = e^(mu theta). The hand-wheel sets the slack side while paying out, T2; the drum takes T1 -
    // T2. Heaving in, the hand-wheel's side is the tight one: the drum takes T2 (1 - e^(-mu theta)).
    const double wear = lining_wear(state, causes);
    const double worn_out = std::clamp((wear - kThreadRunsOut) / (1 - kThreadRunsOut), 0.0, 1.0);
    const double tension = 1 - worn_out * (1 - kTensionOnRivets);
    const double mu = lining_friction(state, causes);
    const double slack_side = def.brake_rating / std::expm1(kLiningFriction * kBandWrap);
    const double out = grip_share(def, state.position) * tension * slack_side * std::expm1(mu * kBandWrap);
    return {out, out * std::exp(-mu * kBandWrap)};
}

void turn_hand_wheel(const WindlassDef& def, double dt, double wanted, bool emergency,
                     BandBrakeState& state) {
    assert(dt > 0 && wanted >= 0 && wanted <= 1 && "the hand-wheel has stops");
    constexpr double kHardOn = 0.99;
    state.held = emergency || (state.held && wanted < kHardOn);
    state.waits = state.held && !emergency;
    const double max =
        dt / (state.held ? std::min(kEmergencyTime, def.brake_travel_time) : def.brake_travel_time);
    state.position += std::clamp((state.held ? 1 : wanted) - state.position, -max, max);
}

void heat_brake(const WindlassDef& def, double dt, double heat, const EquipmentFaults& causes,
                BandBrakeState& state) {
    assert(dt > 0 && "a step takes time");
    const BrakeHeatCapacity capacity = brake_heat_capacity(def);
    const double conductance = kSteelConductivity * def.brake_track_area; // W m/K
    const double inward = conductance / kSkinToShell * (state.skin - state.shell) * dt;
    const double onward = conductance / kShellToDrum * (state.shell - state.drum) * dt;
    const double outward = def.drum_cooling * (state.drum - kAirTemperature) * dt;
    const double drying =
        std::min(kDryingRate * std::max(0.0, state.skin - kBoiling) * dt, kFilmHeat) * state.water;
    state.skin += (heat - inward - drying) / capacity.skin;
    state.shell += (inward - onward) / capacity.shell;
    state.drum += (onward - outward) / capacity.drum;
    state.heat += heat;
    state.cooled += outward;
    state.dried += drying;

    const double wetting = std::max(0.0, causes.lining_wet - state.water) * std::min(1.0, dt / kWettingTime);
    state.water += wetting - drying / kFilmHeat;
    state.glaze = std::min(1.0, state.glaze + dt / kGlazeTime * (state.skin > kFadeEnd ? 1 : 0));
}

template <class Visitor, StateOf<BandBrakeState> State>
void visit_state(Visitor& v, State& state) {
    auto& [position, held, waits, skin, shell, drum, water, glaze, heat, cooled, dried] = state;
    WINDLASS_STATE(v, position, held, waits, skin, shell, drum, water, glaze, heat, cooled, dried);
    WINDLASS_WITHIN(v, 0, 1, position, water, glaze);
    WINDLASS_WITHIN(v, -kHottest, kHottest, skin, shell, drum);
    WINDLASS_WITHIN(v, -kMostEnergy, kMostEnergy, heat, cooled, dried);
}
WINDLASS_STATE_LISTED(BandBrakeState);

} // namespace windlass::physics
