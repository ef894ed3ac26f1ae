#pragma once
// The band brake on the gypsy: free play and stiffness of its band, capstan equation, and a lining whose
// friction falls with heat, water, glaze and wear. Forces in N at the gypsy's pitch line.

#include "server/physics/base/equipment_faults.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/windlass/windlass_def.hpp"

namespace windlass::physics {

inline constexpr double kBandWrap = 5.236;      ///< rad, band on drum: 300 degrees
inline constexpr double kLiningFriction = 0.35; ///< -, lining cold and dry: 0.30 to 0.40
inline constexpr double kFadeStart = 523.15;    ///< K, of the skin, at which friction begins to fall: 250 C
inline constexpr double kFadeEnd = 773.15;      ///< K, where kFadeResidual of it is left: 500 C; tuned
inline constexpr double kFadeResidual = 0.4;    ///< -, of the cold friction; tuned

/// What changes of a band brake.
struct BandBrakeState {
    double position = 1; ///< 0 open .. 1 hard on: where the hand-wheel is
    bool held = false;   ///< by the emergency stop's spring, until the hand-wheel has been hard on
    bool waits = false;  ///< for that: the button is out again, the spring is not compressed yet
    double skin = 0;     ///< K, the drum's skin under the lining, and so the lining's face
    double shell = 0;    ///< K, the steel next to it
    double drum = 0;     ///< K, the rim behind that
    double water = 0;    ///< 0..1, film on the lining
    double glaze = 0;    ///< 0..1, burnt resin on the lining; does not go away
    // Since the start, J
    double heat = 0;   ///< put into the lining
    double cooled = 0; ///< given to the air
    double dried = 0;  ///< spent on boiling water off
};
template <class Visitor, StateOf<BandBrakeState> State>
void visit_state(Visitor& v, State& state);

/// What warms of a brake, J/K: skin and shell are layers of its track, which together follow heat that
/// diffuses into thick steel (band_brake.cpp).
struct BrakeHeatCapacity {
    double skin = 0, shell = 0, drum = 0;
};
BrakeHeatCapacity brake_heat_capacity(const WindlassDef& def);

/// J in skin, shell and drum above the air's temperature.
double stored_heat(const WindlassDef& def, const BandBrakeState& state);

/// Share of its grip that the band has with the hand-wheel at a position (0 open .. 1 hard on): none while
/// the lining is clear of the drum, then ((p - p0) / (1 - p0))^n, all of it hard on.
double grip_share(const WindlassDef& def, double position);

/// Where the hand-wheel has the given share (0..1) of the grip: the other way round. 0: where the lining
/// touches.
double position_of_grip(const WindlassDef& def, double share);

/// Most that the band holds, N.
struct BrakeGrip {
    double out = 0; ///< against paying out: the band winds itself on
    double in = 0;  ///< against heaving in: only e^(-mu theta) of that
};

/// Friction of the lining as it is now.
double lining_friction(const BandBrakeState& state, const EquipmentFaults& causes);

/// Share of the lining used up, 0..1: work done so far and wear that was there before.
double lining_wear(const BandBrakeState& state, const EquipmentFaults& causes);

/// What the band holds with the hand-wheel where it is.
BrakeGrip brake_grip(const WindlassDef& def, const BandBrakeState& state, const EquipmentFaults& causes);

/// Turns the hand-wheel towards the given position (0..1) for dt (s). The emergency stop's spring is quicker,
/// and does not let go when the button is released (ISO 13850 4.1.4).
void turn_hand_wheel(const WindlassDef& def, double dt, double wanted, bool emergency, BandBrakeState& state);

/// dt (s) of slipping with the given heat (J): warms skin, shell and drum, dries, glazes.
void heat_brake(const WindlassDef& def, double dt, double heat, const EquipmentFaults& causes,
                BandBrakeState& state);

} // namespace windlass::physics
