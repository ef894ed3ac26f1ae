#pragma once
// Two ships as exercises show them, one riding to her anchor, one with it clear of the water; and the bytes
// of views.

#include "server/perceive/perceive.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <string>

namespace windlass::perceive {

inline SeatShip some_ship() {
    return {.draught = 12.5, .draught_at_sounder = 12.5, .motor_full_speed = {80, 80}};
}

/// 6 shackles on deck, cable leading ahead; the lip is 6 m above the water, nodes are 1 m apart.
inline exercise::Snapshot riding() {
    exercise::Snapshot s;
    s.tick = 300;
    s.time = 1;
    s.state_hash = 17;
    s.environment.depth = 25.04;
    s.environment.now.wind_speed = 9;
    s.environment.now.wind_from = 0.3;
    s.environment.now.current_speed = 0.5;
    s.ship.position = {10.04, -20.06, 0};
    s.ship.attitude = Eigen::AngleAxisd(std::numbers::pi / 2 - 0.2, Eigen::Vector3d::UnitZ());
    s.ship.heading = 0.2;
    s.ship.velocity = {0.4, 0.9, 0};
    s.ship.surge = 0.98;
    s.tackle.resize(1);
    exercise::TackleView& tackle = s.tackle[0];
    tackle.anchor.phase = exercise::AnchorPhase::holding;
    tackle.anchor.position = {40, 220, -24.5};
    tackle.anchor.weight = 8.6e4;
    tackle.anchor.carried = 0;
    tackle.chain.cable_out = 163.2;
    tackle.chain.lead_clock = 11.6;
    tackle.chain.top_angle = 0.6;
    const Eigen::Vector3f lip(30, 82, 6), down = Eigen::Vector3f(0, 0.8F, -0.6F);
    for (int i = 0; i <= 40; ++i)
        tackle.chain.nodes.emplace_back(lip + static_cast<float>(i) * down);
    tackle.chain.tension.assign(40, 2e5F);
    for (int shackle = 1; shackle < 12; ++shackle) {
        const double outboard = tackle.chain.cable_out - 27.5 * shackle;
        tackle.chain.marks.push_back({shackle, outboard, shackle, shackle > 9,
                                      outboard > 0 ? lip + static_cast<float>(outboard) * down : lip});
    }
    exercise::WindlassView& windlass = tackle.windlass;
    windlass.hawse_tension = 3e5;
    windlass.gypsy_load = windlass.gypsy_load_indicated = 2.5e5;
    windlass.breaking_load = 4.5e6;
    windlass.brake_rating = 2.05e6;
    windlass.cable_out = 163.2;
    windlass.cable_out_indicated = 164.5;
    windlass.brake_position = 1;
    windlass.lining_temperature = windlass.drum_temperature = 300;
    return s;
}

/// The same with the anchor hove up, clay on it.
inline exercise::Snapshot weighing() {
    exercise::Snapshot s = riding();
    exercise::TackleView& tackle = s.tackle[0];
    tackle.anchor.phase = exercise::AnchorPhase::aweigh;
    tackle.anchor.position = {30, 82, 2};
    tackle.anchor.carried = 1e4;
    tackle.anchor.fluke_angle = 0.5;
    tackle.chain.nodes = {{30, 82, 6}, {30, 82, 5}, {30, 82, 4}};
    tackle.chain.tension = {1e5F, 1e5F};
    return s;
}

/// As on the wire. Bytes that only fill up to the next member's place are zero: the serialiser leaves there
/// what was in its memory.
template <class View>
std::string bytes(const View& view) {
    std::string memory(std::size_t{1} << 16, '\0');
    eprosima::fastcdr::FastBuffer buffer(memory.data(), memory.size());
    eprosima::fastcdr::Cdr cdr(buffer);
    view.serialize(cdr);
    memory.resize(cdr.getSerializedDataLength());
    return memory;
}

inline ForecastleView forecastle(const exercise::Snapshot& s, const SeatAids& aids = {}) {
    ForecastleView view;
    perceive_forecastle(s, s.tackle.at(0), some_ship(), aids, view);
    return view;
}

/// Of a camera that works.
inline ForecastleView camera(const exercise::Snapshot& s) {
    ForecastleView view;
    perceive_camera(s, s.tackle.at(0), view);
    return view;
}

inline BridgeView bridge(const exercise::Snapshot& s) {
    BridgeView view;
    perceive_bridge(s, some_ship(), view);
    return view;
}

} // namespace windlass::perceive
