#pragma once
// The fields of every plain struct that changes while an exercise runs; see state_visitor.hpp.

#include "server/physics/bight.hpp"
#include "server/physics/cable_twist.hpp"
#include "server/physics/chain.hpp"
#include "server/physics/chain_strain.hpp"
#include "server/physics/holding.hpp"
#include "server/physics/quiet_cable.hpp"
#include "server/physics/ship.hpp"
#include "server/physics/sleep.hpp"
#include "server/physics/state_visitor.hpp"
#include "server/physics/windlass.hpp"

namespace windlass::physics {

void visit_state(StateVisitor& v, ShipState& state);
void visit_state(StateVisitor& v, Helm& helm);
void visit_state(StateVisitor& v, CablePull& pull);
void visit_state(StateVisitor& v, EnvironmentDef& environment);
void visit_state(StateVisitor& v, ChainState& state); ///< of the links in use
void visit_state(StateVisitor& v, ChainStrain& strain);
void visit_state(StateVisitor& v, CableTwistState& twist);
void visit_state(StateVisitor& v, CableLimits& limits);
void visit_state(StateVisitor& v, WindlassLevers& levers);
void visit_state(StateVisitor& v, WindlassState& state);
void visit_state(StateVisitor& v, BandBrakeState& state);
void visit_state(StateVisitor& v, DogClutchState& state);
void visit_state(StateVisitor& v, ChainStopperState& state);
void visit_state(StateVisitor& v, PrimeMoverState& state);
void visit_state(StateVisitor& v, GypsyState& state);
void visit_state(StateVisitor& v, SpurlingPipeState& state);
void visit_state(StateVisitor& v, WindlassLoads& loads);
void visit_state(StateVisitor& v, DeckResult& result);
void visit_state(StateVisitor& v, HoldingState& state);
void visit_state(StateVisitor& v, BightState& state);
void visit_state(StateVisitor& v, SleepState& state);
void visit_state(StateVisitor& v, QuietState& state);
void visit_state(StateVisitor& v, ModelError& error);

} // namespace windlass::physics
