#pragma once
// Whether the ship is aground, and when that is told.

#include "server/exercise/faults/faults.hpp"
#include "server/physics/sea/environment.hpp"
#include "server/physics/ship/ship.hpp"
#include "server/physics/ship/ship_def.hpp"

namespace windlass::exercise {

/// Tells when her keel comes to the ground ("ship.aground") and clear of it ("ship.afloat"): by 0.1 m for 20
/// s, longer than any wave (both tuned), so that a ship that works on the ground is called once.
class GroundWatch {
public:
    void look(const physics::ShipDef& def, const physics::EnvironmentDef& environment,
              const physics::ShipState& ship, double dt, const EventLog& log);

    template <class Visitor, physics::StateOf<GroundWatch> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    bool aground_ = false;
    double clear_for_ = 0; ///< s, aground and yet clear of it
};

} // namespace windlass::exercise
