#pragma once
// What a station has heard of a ship at anchor: the truth, what a seat is given, or both.

#include "station/picture.hpp"

#include <numbers>

namespace windlass::station {

inline constexpr auto kNow = Clock::time_point{} + std::chrono::seconds{1000};
inline constexpr double kDegree = std::numbers::pi / 180;

inline CableMark mark(int shackle, double outboard, double height, bool last = false) {
    CableMark sample;
    sample.shackle(shackle);
    sample.outboard(static_cast<float>(outboard));
    sample.white_links(shackle);
    sample.last(last);
    sample.position().z(static_cast<float>(height));
    return sample;
}

/// What everybody hears.
inline Picture exercise_heard() {
    Picture picture;
    ExerciseStatus status;
    status.title() = "Let go the port anchor";
    status.time(125);
    status.tick(37500);
    status.state(RUN_RUNNING);
    status.time_scale(8);
    picture.receive(status, kNow);
    WindlassCommand levers;
    levers.origin().source() = "trainee-1";
    levers.brake(1);
    picture.receive(levers, kNow);
    return picture;
}

/// The truth in it.
inline void give_truth(Picture& picture) {
    ExerciseTruth truth;
    truth.title() = "Let go the port anchor; the lining will fade";
    truth.depth(25);
    picture.receive(truth, kNow);
    EnvironmentState environment;
    environment.now().wind_speed(8);
    environment.now().current_speed(0.3);
    environment.after(environment.now());
    picture.receive(environment, kNow);
    ChainState chain;
    chain.cable_out(165);
    chain.cable_out_shackles(6);
    chain.lead_clock(11);
    chain.stay(STAY_MEDIUM);
    chain.on_bottom(90);
    chain.turns(-2.5);
    picture.receive(chain, kNow);
    AnchorState anchor;
    anchor.phase(ANCHOR_HOLDING);
    anchor.position().z(-25);
    picture.receive(anchor, kNow);
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
    picture.receive(load, kNow);
    ShipState ship;
    ship.speed_over_ground(0.3);
    picture.receive(ship, kNow);
}

/// What a seat is given of the same, by a counter that has missed pulses and a load cell that is dead.
inline void give_views(Picture& picture) {
    ForecastleView view;
    view.tick(37500);
    view.time(125);
    view.counter_fitted(true);
    view.cable_out_indicated(140.2);
    view.load_cell_fitted(true);
    view.breaking_load(4505000);
    view.brake_rating(2050000);
    view.brake_position(0.85);
    view.clutch(CLUTCH_OUT);
    view.power(true);
    view.leads(true);
    view.lead_clock(11);
    view.top_angle(40 * kDegree);
    view.marks({mark(3, 3, 2.5), mark(4, -2, 6)});
    view.anchor(ANCHOR_SEEN_UNDER_WATER);
    view.lining(LINING_SMELLS);
    picture.receive(view, kNow);
    BridgeView bridge;
    bridge.heading(90 * kDegree);
    bridge.speed_over_ground(0.3);
    bridge.speed_through_water(-0.3);
    bridge.depth_below_keel(12.3);
    bridge.wind_speed_apparent(8);
    bridge.wind_from_apparent(315 * kDegree);
    bridge.visibility(18520);
    bridge.time_of_day(12 * 3600);
    bridge.gps_works(true);
    bridge.gyro_works(true);
    bridge.log_works(true);
    bridge.anemometer_works(true);
    bridge.echo_sounder_works(true);
    picture.receive(bridge, kNow);
}

/// As an instructor hears it.
inline Picture anchored() {
    Picture picture = exercise_heard();
    give_truth(picture);
    return picture;
}

/// As a trainee does.
inline Picture anchored_seen() {
    Picture picture = exercise_heard();
    give_views(picture);
    return picture;
}

template <class T = Event>
T event(std::uint64_t number, const std::string& code, const std::string& text,
        EventSeverity severity = EVENT_INFO) {
    T sample;
    sample.number(number);
    sample.time(125);
    sample.code() = code;
    sample.text() = text;
    sample.severity(severity);
    return sample;
}

inline BridgeOrder order(int number, BridgeOrderCode code, double value,
                         BridgeOrderState state = ORDER_GIVEN) {
    BridgeOrder sample;
    sample.number(number);
    sample.code(code);
    sample.value(value);
    sample.time(120);
    sample.state(state);
    return sample;
}

} // namespace windlass::station
