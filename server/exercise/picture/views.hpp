#pragma once
// From the physics to what is seen from outside: copies and plain geometry, no decisions.

#include "server/exercise/picture/snapshot.hpp"
#include "server/physics/ship/ship.hpp"
#include "server/physics/tackle/ground_tackle.hpp"

namespace windlass::exercise {

/// ordered: her helm as it stands; answers: what of it she hears.
void view_ship(const physics::ShipState& ship, const physics::Helm& ordered, const physics::Helm& answers,
               ShipView& view);
void view_anchor(const physics::GroundTackle& tackle, AnchorPhase phase,
                 const physics::EnvironmentDef& environment, AnchorView& view);
/// heading: ship's, rad; the cable's lead is counted from her bow.
void view_chain(const physics::GroundTackle& tackle, double heading,
                const physics::EnvironmentDef& environment, ChainView& view);
void view_windlass(const physics::GroundTackle& tackle, const physics::WindlassLevers& levers,
                   const physics::EquipmentFaults& causes, WindlassView& view);

/// From the world of the model into that of what is seen from outside, whose z = 0 is the still water's
/// surface; level: m, of that surface in the model's world.
void over_water(double level, Snapshot& snapshot);

} // namespace windlass::exercise
