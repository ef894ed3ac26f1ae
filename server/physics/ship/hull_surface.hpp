#pragma once
// The ship's hull as the chain meets it: side, bow with flare and raked stem, bottom.

#include "server/physics/contact/obstacle_contact.hpp"
#include "server/physics/ship/hawse_pipe.hpp"
#include "server/physics/ship/ship.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::physics {

/// A hull of a ship's main dimensions: parallel to the entrance, then drawn in to a raked stem, with flare
/// between waterline and deck. Frame: x forward of midships, y to port, z up from the waterline, m. The side
/// passes inside the hawse pipe lip by the given clearance (m), so that chain hanging from it is clear.
ObstacleMesh hull_mesh(const ShipDef& def, double clearance);

/// m from the centre line to the side of that hull abreast of the lip; 0 where the lip is ahead of the stem.
/// Less than hawse_outboard, or the bow cannot be drawn inside the lip.
double side_at_lip(const ShipDef& def, double clearance);

/// The hull's place and motion, between two states of the ship a tick of dt (s) apart; share 0..1.
BodyMotion hull_motion(const ShipState& before, const ShipState& after, double share, double dt);

/// Hull, place and material for one step of a cable and its anchor.
struct HullSurface {
    const ObstacleMesh* mesh = nullptr; ///< none: nothing to touch
    BodyMotion motion;
    ContactMaterial material;
    const HawsePipe* pipe = nullptr; ///< that the anchor's shank fits; none: it stays outside
};

} // namespace windlass::physics
