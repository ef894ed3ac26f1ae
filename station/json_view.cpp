#include "station/json_view.hpp"

#include "station/names.hpp"

#include <nlohmann/json.hpp>

namespace windlass::station {

using nlohmann::json;

namespace {

json anchor_json(const AnchorState& anchor) {
    return {{"phase", name(anchor.phase())},
            {"height_above_bottom", anchor.height_above_bottom()},
            {"holding_capacity", anchor.holding_capacity()},
            {"holding_used", anchor.holding_used()},
            {"uplift", anchor.uplift()},
            {"embedment", anchor.embedment()},
            {"dragged", anchor.dragged()},
            {"soil", name(anchor.soil())},
            {"fluke_angle", anchor.fluke_angle()},
            {"weight", anchor.weight()},
            {"carried", anchor.carried()},
            {"breakout", anchor.breakout()},
            {"bent", anchor.bent()},
            {"fouled", anchor.fouled()}};
}

json mark_json(const CableMark& mark) {
    return {{"shackle", mark.shackle()},
            {"outboard", mark.outboard()},
            {"white_links", mark.white_links()},
            {"last", mark.last()}};
}

json chain_json(const ChainState& chain) {
    json marks = json::array();
    for (const CableMark& mark : chain.marks())
        marks.push_back(mark_json(mark));
    return {{"cable_out", chain.cable_out()},
            {"cable_out_shackles", chain.cable_out_shackles()},
            {"lead_clock", chain.lead_clock()},
            {"stay", name(chain.stay())},
            {"top_angle", chain.top_angle()},
            {"on_bottom", chain.on_bottom()},
            {"turns", chain.turns()},
            {"largest_tension", chain.largest_tension()},
            {"stretched", chain.stretched()},
            {"stretch", chain.stretch()},
            {"marks", marks}};
}

json load_json(const WindlassLoad& load) {
    return {{"hawse_tension", load.hawse_tension()},
            {"gypsy_load", load.gypsy_load()},
            {"gypsy_load_indicated", load.gypsy_load_indicated()},
            {"cable_out_indicated", load.cable_out_indicated()},
            {"brake_load", load.brake_load()},
            {"stopper_load", load.stopper_load()},
            {"motor_load", load.motor_load()},
            {"shaft_brake_load", load.shaft_brake_load()},
            {"bitter_end_load", load.bitter_end_load()},
            {"spurling_pipe_load", load.spurling_pipe_load()},
            {"locker_load", load.locker_load()},
            {"breaking_load", load.breaking_load()},
            {"utilisation", load.utilisation()},
            {"brake_capacity", load.brake_capacity()},
            {"brake_rating", load.brake_rating()},
            {"lining_friction", load.lining_friction()},
            {"cable_speed", load.cable_speed()},
            {"brake_position", load.brake_position()},
            {"brake_power", load.brake_power()},
            {"brake_energy", load.brake_energy()},
            {"brake_wear", load.brake_wear()},
            {"lining_temperature", load.lining_temperature()},
            {"drum_temperature", load.drum_temperature()},
            {"motor_torque", load.motor_torque()},
            {"motor_speed", load.motor_speed()},
            {"motor_current", load.motor_current()},
            {"motor_pressure", load.motor_pressure()},
            {"motor_temperature", load.motor_temperature()},
            {"speed_lever", load.speed_lever()},
            {"power", load.power()},
            {"tripped", load.tripped()},
            {"emergency_stop", load.emergency_stop()},
            {"stopper_closed", load.stopper_closed()},
            {"clutch", name(load.clutch())},
            {"clutch_sheared", load.clutch_sheared()},
            {"gypsy_jumping", load.gypsy_jumping()},
            {"stopper_sprung", load.stopper_sprung()},
            {"motor_burst", load.motor_burst()}};
}

json levers_json(const WindlassCommand& levers) {
    return {{"source", levers.origin().source().to_string()},
            {"brake", levers.brake()},
            {"speed_lever", levers.speed_lever()},
            {"clutch_in", levers.clutch_in()},
            {"stopper_closed", levers.stopper_closed()},
            {"emergency_stop", levers.emergency_stop()}};
}

json ship_json(const ShipState& ship) {
    return {{"x", ship.position().x()},
            {"y", ship.position().y()},
            {"heading", ship.heading()},
            {"surge", ship.surge()},
            {"sway", ship.sway()},
            {"yaw_rate", ship.yaw_rate()},
            {"speed_over_ground", ship.speed_over_ground()},
            {"course_over_ground", ship.course_over_ground()},
            {"engine", ship.engine()},
            {"rudder", ship.rudder()},
            {"bow_thruster", ship.bow_thruster()},
            {"stern_thruster", ship.stern_thruster()}};
}

json tackle_json(const TacklePicture& tackle) {
    json object = json::object();
    if (tackle.anchor) object["anchor"] = anchor_json(*tackle.anchor);
    if (tackle.chain) object["chain"] = chain_json(*tackle.chain);
    if (tackle.load) object["windlass"] = load_json(*tackle.load);
    if (tackle.levers) object["levers"] = levers_json(*tackle.levers);
    return object;
}

} // namespace

json to_json(const FaultStatus& fault) {
    return {{"code", name(fault.code())},       {"side", side_name(fault.side())},
            {"phase", name(fault.phase())},     {"severity", fault.severity()},
            {"trigger", name(fault.trigger())}, {"trigger_value", fault.trigger_value()}};
}

json to_json(const ExerciseStatus& status) {
    json faults = json::array();
    for (const auto& fault : status.faults())
        faults.push_back(to_json(fault));
    return {{"tick", status.tick()},
            {"time", status.time()},
            {"state", name(status.state())},
            {"time_scale", status.time_scale()},
            {"time_scale_achieved", status.time_scale_achieved()},
            {"exercise", status.exercise().to_string()},
            {"title", status.title().to_string()},
            // As text: a reader that keeps numbers as doubles would lose the last bits.
            {"state_hash", std::to_string(status.state_hash())},
            {"lateness", status.lateness()},
            {"overruns", status.overruns()},
            {"commands_refused", status.commands_refused()},
            {"samples_dropped", status.samples_dropped()},
            {"model_level", name(status.model_level())},
            {"model_nodes", status.model_nodes()},
            {"model_substeps", status.model_substeps()},
            {"model_error_load", status.model_error_load()},
            {"model_error_shape", status.model_error_shape()},
            {"depth", status.depth()},
            {"wind_speed", status.wind_speed()},
            {"wind_from", status.wind_from()},
            {"current_speed", status.current_speed()},
            {"current_towards", status.current_towards()},
            {"faults", faults}};
}

json to_json(const Event& event) {
    return {{"event", event.code().to_string()},  {"number", event.number()},        {"time", event.time()},
            {"severity", name(event.severity())}, {"side", side_name(event.side())}, {"value", event.value()},
            {"text", event.text().to_string()}};
}

json to_json(const Picture& picture, Clock::time_point now) {
    json object = json::object();
    if (picture.status) object["status"] = to_json(*picture.status);
    if (const auto silent = picture.silence(now)) object["silence"] = *silent;
    if (picture.ship) object["ship"] = ship_json(*picture.ship);
    for (const int side : {SIDE_PORT, SIDE_STARBOARD}) {
        json tackle = tackle_json(picture.tackle[static_cast<std::size_t>(side)]);
        if (!tackle.empty()) object[std::string{side_name(side)}] = std::move(tackle);
    }
    return object;
}

} // namespace windlass::station
