#pragma once
// The gypsy (cable lifter): five pockets, 40 d of chain a revolution. Sound pockets hold more than chain can
// pull; worn ones let it jump.

#include "server/physics/base/equipment_faults.hpp"
#include "server/physics/base/state_visitor.hpp"
#include "server/physics/chain/chain_def.hpp"
#include "server/physics/windlass/windlass_def.hpp"

namespace windlass::physics {

inline constexpr int kGypsyPockets = 5;

/// m of chain in one revolution: each pocket takes two links, one flat and one on edge.
inline double gypsy_revolution(double chain_diameter) {
    return 2 * kGypsyPockets * kLinksInDiameters * chain_diameter;
}

/// What changes of a gypsy.
struct GypsyState {
    bool jumping = false; ///< links ride over the pockets: chain runs, whatever brake and clutch do
    int jumps = 0;        ///< times that it began to
    double behind = 0; ///< rad, by which it stands behind the links that jumped over it, within a half turn
};
template <class Visitor, StateOf<GypsyState> State>
void visit_state(Visitor& v, State& state);

/// Pull at which links leave the pockets, N.
double gypsy_grip(const WindlassDef& def, const EquipmentFaults& causes);

/// What jumping links still drag, N.
double jumping_drag(const WindlassDef& def, const EquipmentFaults& causes);

/// After a step. speed: m/s of the chain; through: N that the pockets carried, stopper not counted.
void watch_pockets(const WindlassDef& def, double speed, double through, const EquipmentFaults& causes,
                   GypsyState& state);

/// After a step of dt (s) in which so many metres of chain passed, paying out positive. A gypsy that links
/// jump over stands; once they seat again it turns on into the nearest pocket. That is to be seen, and
/// nothing else: the pockets that were missed are in no load.
void turn_gypsy(double chain_diameter, double dt, double passed, GypsyState& state);

/// rad, 0..2 pi, in step with the links in its pockets; m of cable out.
double gypsy_turn(double chain_diameter, double cable_out, const GypsyState& state);
/// rad/s, of the gypsy itself, paying out positive; speed: m/s of the chain.
double gypsy_speed(double chain_diameter, double speed, const GypsyState& state);

} // namespace windlass::physics
