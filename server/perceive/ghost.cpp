// What a seat that practises is shown of the model's hands: levers and its own gauges, and nothing else that
// its views have. It is their exercise that is perceived, by the rules of the seat.

#include "server/perceive/perceive.hpp"

namespace windlass::perceive {

void perceive_forecastle_ghost(const exercise::Snapshot& hands, const exercise::TackleView& tackle,
                               const SeatShip& ship, const SeatAids& aids, ForecastleView& to) {
    ForecastleView seen;
    perceive_forecastle(hands, tackle, ship, aids, seen);
    to = ForecastleView();
    to.side(seen.side());
    to.tick(seen.tick());
    to.time(seen.time());
    to.brake_position(seen.brake_position());
    to.speed_lever(seen.speed_lever());
    to.clutch(seen.clutch());
    to.stopper_closed(seen.stopper_closed());
    to.counter_fitted(seen.counter_fitted());
    to.cable_out_indicated(seen.cable_out_indicated());
    to.cable_speed_indicated(seen.cable_speed_indicated());
    to.load_cell_fitted(seen.load_cell_fitted());
    to.gypsy_load_indicated(seen.gypsy_load_indicated());
    to.cable_speed_seen(seen.cable_speed_seen());
}

void perceive_bridge_ghost(const exercise::Snapshot& hands, const SeatShip& ship, BridgeView& to) {
    BridgeView seen;
    perceive_bridge(hands, ship, seen);
    to = BridgeView();
    to.tick(seen.tick());
    to.time(seen.time());
    to.engine(seen.engine());
    to.rudder(seen.rudder());
    to.bow_thruster(seen.bow_thruster());
    to.stern_thruster(seen.stern_thruster());
    to.gps_works(seen.gps_works());
    to.speed_over_ground(seen.speed_over_ground());
}

} // namespace windlass::perceive
