#pragma once
// The model's hands as the seats are shown them, ready to be written.

#include "server/perceive/perceive.hpp"

#include <vector>

namespace windlass::dds {

struct Ghost {
    std::vector<ForecastleView> forecastle; ///< by windlass
    BridgeView bridge;
};

/// Of one exercise.
class GhostMaker {
public:
    explicit GhostMaker(const exercise::ExerciseDef& def)
        : ship_(perceive::seat_ship(def)), aids_(perceive::seat_aids(def)) {}

    void make(const exercise::Snapshot& hands, Ghost& to) const {
        to.forecastle.resize(hands.tackle.size());
        for (std::size_t k = 0; k < hands.tackle.size(); ++k)
            perceive::perceive_forecastle_ghost(hands, hands.tackle[k], ship_, aids_, to.forecastle[k]);
        perceive::perceive_bridge_ghost(hands, ship_, to.bridge);
    }

private:
    perceive::SeatShip ship_;
    perceive::SeatAids aids_;
};

} // namespace windlass::dds
