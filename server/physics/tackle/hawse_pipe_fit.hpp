#pragma once
// Fitting an anchor into its hawse pipe: where the pipe leads, and where the anchor seats.

#include "server/physics/anchor/anchor_def.hpp"
#include "server/physics/chain/chain_def.hpp"
#include "server/physics/contact/obstacle_mesh.hpp"
#include "server/physics/ship/hawse_pipe.hpp"
#include "server/physics/ship/ship_def.hpp"
#include "server/physics/windlass/windlass_def.hpp"

#include <Eigen/Geometry>

namespace windlass::physics {

/// The pipe that fits a windlass, its chain and its anchor: as steep as its length and height make it, square
/// to the plating as seen from above. Its seat is where crown and flukes, turned away from the ship, bear on
/// the plating. side: -1 port, 1 starboard.
HawsePipe fit_hawse_pipe(const ShipDef& ship, const WindlassDef& windlass, const ChainDef& chain,
                         const AnchorDef& anchor, const ObstacleMesh& hull, double side);

/// Axes of an anchor as columns: its shank along the given unit vector, the axis of its flukes level and a
/// quarter turn anticlockwise, seen from above, from the other; both in one frame with z up.
Eigen::Matrix3d anchor_axes(const Vec3& shank, const Vec3& across);

} // namespace windlass::physics
