#pragma once
// What a station has heard of a ship at anchor.

#include "station/picture.hpp"

namespace windlass::station {

inline constexpr auto kNow = Clock::time_point{} + std::chrono::seconds{1000};

inline Picture anchored() {
    Picture picture;
    ExerciseStatus status;
    status.title() = "Let go the port anchor";
    status.time(125);
    status.tick(37500);
    status.state(RUN_RUNNING);
    status.time_scale(8);
    status.depth(25);
    picture.take(status, kNow);
    ChainState chain;
    chain.cable_out(165);
    chain.cable_out_shackles(6);
    chain.lead_clock(11);
    chain.stay(STAY_MEDIUM);
    chain.on_bottom(90);
    chain.turns(-2.5);
    picture.take(chain, kNow);
    AnchorState anchor;
    anchor.phase(ANCHOR_HOLDING);
    anchor.position().z(-25);
    picture.take(anchor, kNow);
    WindlassLoad load;
    load.tick(37500);
    load.time(125);
    load.hawse_tension(443000);
    load.breaking_load(4505000);
    load.utilisation(443.0 / 4505);
    load.brake_load(300000);
    load.brake_capacity(1500000);
    load.brake_rating(2050000);
    load.brake_energy(3.1e6);
    load.brake_position(0.85);
    load.lining_temperature(453.15);
    load.power(true);
    load.clutch(CLUTCH_OUT);
    picture.take(load, kNow);
    WindlassCommand levers;
    levers.origin().source() = "trainee-1";
    levers.brake(1);
    picture.take(levers, kNow);
    ShipState ship;
    ship.speed_over_ground(0.3);
    picture.take(ship, kNow);
    return picture;
}

inline Event event(std::uint64_t number, const std::string& code, const std::string& text,
                   EventSeverity severity = EVENT_INFO) {
    Event sample;
    sample.number(number);
    sample.time(125);
    sample.code() = code;
    sample.text() = text;
    sample.severity(severity);
    return sample;
}

} // namespace windlass::station
