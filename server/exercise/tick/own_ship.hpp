#pragma once
// The ship in a tick: under her helm, in the waves, on her cables; or as another simulator moves her.

#include "server/exercise/definition/orders.hpp"
#include "server/exercise/faults/faults.hpp"
#include "server/exercise/weather/surroundings.hpp"
#include "server/physics/ship/foreign_ship.hpp"
#include "server/physics/ship/ship_dynamics.hpp"
#include "server/physics/ship/ship_in_waves.hpp"

namespace windlass::exercise {

class OwnShip {
public:
    /// start: without what the sea's waves do to her, which is laid over her; depth: m, of the level bed
    /// below the exercise's water.
    OwnShip(const physics::ShipDef& def, const physics::ShipState& start, const physics::SeaSurface& sea,
            double depth);

    /// dt (s) on, to the time (s): under what her cables did to her (pulled_by) since the last step, their
    /// hawse pipes with her; rise: m/s, of the water. False when she ceased to be finite.
    bool step(const Surroundings& surroundings, double rise, const FaultBook& faults, double dt, double time,
              const EventLog& log);
    void pulled_by(const physics::CablePull& pull);

    /// The helm is moved: who moves it has her, where no foreign model is heard.
    void steer(const physics::Helm& ordered, const physics::SeaSurface& sea, double time);
    /// Another simulator says where she is.
    void follow(const OwnShipSample& sample, double time, const EventLog& log);
    /// Waves that act on her anew, in water of that depth (m).
    void meet_sea(double depth) { in_waves_ = physics::ShipInWaves(def_, depth); }

    const physics::ShipState& state() const { return ship_; }
    const physics::Helm& helm() const { return helm_; }       ///< as ordered
    const physics::Helm& answers() const { return answers_; } ///< what of it the ship hears
    const physics::CablePull& pull() const {
        return pull_;
    } ///< of the last tick, which moves her in the next
    /// N, world: what all but her cables asks of her at rest, looked at twice a second.
    const physics::Vec3& force_at_rest() const { return at_rest_; }
    /// Whether another simulator moves her, as last told.
    bool foreign() const { return foreign_drive_ != physics::ForeignShip::Drive::none; }
    /// Whether nothing is heard of it any more, so that she lies still, as last told.
    bool foreign_lost() const { return foreign_drive_ == physics::ForeignShip::Drive::held; }

    /// As she will be if nothing but the sea changes, of a state that is brought back.
    physics::ShipState expected(const physics::SeaSurface& sea, double time);
    /// Throws physics::StateError where levers of a state that was brought back are beyond their stops.
    void hold(const physics::StateVisitor& v, double level) const;

    template <class Visitor, physics::StateOf<OwnShip> Self>
    friend void visit_state(Visitor& v, Self& self);

private:
    physics::WaveMotion wave_motion(const physics::SeaSurface& sea, double time);
    void answer_helm(const physics::Machinery& machinery, const FaultBook& faults, double time);
    void tell_who_sails_her(double time, const EventLog& log);

    physics::ShipDef def_;
    physics::ShipInWaves in_waves_;  ///< keeps nothing that the rest does not say
    physics::ShipDynamics dynamics_; ///< nor does this
    physics::ShipState ship_;
    physics::ForeignShip foreign_ship_;
    physics::ForeignShip::Drive foreign_drive_ = physics::ForeignShip::Drive::none; ///< as last told
    bool foreign_jumped_ = false; ///< its last sample was not followed, and that was said
    physics::Helm helm_, answers_;
    physics::CablePull pull_;
    physics::Vec3 at_rest_{0, 0, 0};
};

} // namespace windlass::exercise
