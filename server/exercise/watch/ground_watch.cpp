#include "server/exercise/watch/ground_watch.hpp"

#include "server/physics/ship/grounding.hpp"

namespace windlass::exercise {

void GroundWatch::look(const physics::ShipDef& def, const physics::EnvironmentDef& environment,
                       const physics::ShipState& ship, double dt, const EventLog& log) {
    const double clearance = physics::keel_and_ground(def, environment, ship, dt).clearance;
    constexpr double kAfloat = 0.1, kFor = 20; // m, s
    clear_for_ = clearance > kAfloat ? clear_for_ + dt : 0;
    if (!aground_ && clearance < 0) {
        aground_ = true;
        const physics::Vec3 velocity = physics::ship_velocity(ship);
        log("ship.aground", -1, velocity.norm());
    } else if (aground_ && clear_for_ > kFor) {
        aground_ = false;
        log("ship.afloat", -1, clearance);
    }
}

template <class Visitor, physics::StateOf<GroundWatch> Self>
void visit_state(Visitor& v, Self& self) {
    WINDLASS_STATE(v, self.aground_, self.clear_for_);
}
WINDLASS_STATE_LISTED(GroundWatch);

} // namespace windlass::exercise
