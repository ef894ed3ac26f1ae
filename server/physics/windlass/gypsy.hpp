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
};
void visit_state(StateVisitor& v, GypsyState& state);

/// Pull at which links leave the pockets, N.
double gypsy_grip(const WindlassDef& def, const EquipmentFaults& causes);

/// What jumping links still drag, N.
double jumping_drag(const WindlassDef& def, const EquipmentFaults& causes);

/// After a step. speed: m/s of the chain; through: N that the pockets carried, stopper not counted.
void watch_pockets(const WindlassDef& def, double speed, double through, const EquipmentFaults& causes,
                   GypsyState& state);

} // namespace windlass::physics
