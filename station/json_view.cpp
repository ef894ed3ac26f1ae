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

json marks_json(const std::vector<CableMark>& marks) {
    json list = json::array();
    for (const CableMark& mark : marks)
        list.push_back(mark_json(mark));
    return list;
}

json chain_json(const ChainState& chain) {
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
            {"marks", marks_json(chain.marks())}};
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
            {"gypsy_speed", load.gypsy_speed()},
            {"gypsy_turn", load.gypsy_turn()},
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
            {"clutch_offset", load.clutch_offset()},
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

json forecastle_json(const ForecastleView& view) {
    return {{"ship_heading", view.ship_heading()},
            {"ship_roll", view.ship_roll()},
            {"ship_pitch", view.ship_pitch()},
            {"wind_felt", view.wind_felt()},
            {"wind_from_bow", view.wind_from_bow()},
            {"brake_position", view.brake_position()},
            {"speed_lever", view.speed_lever()},
            {"clutch", name(view.clutch())},
            {"clutch_offset", view.clutch_offset()},
            {"stopper_closed", view.stopper_closed()},
            {"stopper_sprung", view.stopper_sprung()},
            {"emergency_stop", view.emergency_stop()},
            {"counter_fitted", view.counter_fitted()},
            {"cable_out_indicated", view.cable_out_indicated()},
            {"cable_speed_indicated", view.cable_speed_indicated()},
            {"load_cell_fitted", view.load_cell_fitted()},
            {"gypsy_load_indicated", view.gypsy_load_indicated()},
            {"breaking_load", view.breaking_load()},
            {"brake_rating", view.brake_rating()},
            {"motor_current", view.motor_current()},
            {"motor_pressure", view.motor_pressure()},
            {"power", view.power()},
            {"tripped", view.tripped()},
            {"cable_speed_seen", view.cable_speed_seen()},
            {"gypsy_turn", view.gypsy_turn()},
            {"gypsy_jumping", view.gypsy_jumping()},
            {"leads", view.leads()},
            {"lead_clock", view.lead_clock()},
            {"top_angle", view.top_angle()},
            {"marks", marks_json(view.marks())},
            {"anchor", name(view.anchor())},
            {"fluke_angle", view.fluke_angle()},
            {"mud", view.mud()},
            {"lining", name(view.lining())},
            {"motor_speed_heard", view.motor_speed_heard()},
            {"motor_burst", view.motor_burst()},
            {"brake_noise", view.brake_noise()},
            {"vibration", view.vibration()},
            {"lining_temperature_shown", view.lining_temperature_shown()},
            {"lining_temperature", view.lining_temperature()}};
}

json bridge_json(const BridgeView& view) {
    return {{"x", view.position().x()},
            {"y", view.position().y()},
            {"heading", view.heading()},
            {"rate_of_turn", view.rate_of_turn()},
            {"speed_over_ground", view.speed_over_ground()},
            {"course_over_ground", view.course_over_ground()},
            {"speed_through_water", view.speed_through_water()},
            {"roll", view.roll()},
            {"pitch", view.pitch()},
            {"engine", view.engine()},
            {"rudder", view.rudder()},
            {"bow_thruster", view.bow_thruster()},
            {"stern_thruster", view.stern_thruster()},
            {"wind_speed_apparent", view.wind_speed_apparent()},
            {"wind_from_apparent", view.wind_from_apparent()},
            {"depth_below_keel", view.depth_below_keel()},
            {"visibility", view.visibility()},
            {"time_of_day", view.time_of_day()},
            {"gps_works", view.gps_works()},
            {"gyro_works", view.gyro_works()},
            {"log_works", view.log_works()},
            {"anemometer_works", view.anemometer_works()},
            {"echo_sounder_works", view.echo_sounder_works()},
            {"vhf_works", view.vhf_works()},
            {"cctv_works", view.cctv_works()}};
}

json tackle_json(const TacklePicture& tackle) {
    json object = json::object();
    if (tackle.view) object["forecastle"] = forecastle_json(*tackle.view);
    if (tackle.anchor) object["anchor"] = anchor_json(*tackle.anchor);
    if (tackle.chain) object["chain"] = chain_json(*tackle.chain);
    if (tackle.load) object["windlass"] = load_json(*tackle.load);
    if (tackle.levers_in_force()) object["levers"] = levers_json(*tackle.levers_in_force());
    return object;
}

json weather_json(const Weather& weather) {
    json profile = json::array();
    for (const CurrentLayer& layer : weather.current_profile())
        profile.push_back({{"depth", layer.depth()}, {"share", layer.share()}, {"turn", layer.turn()}});
    return {{"wind_speed", weather.wind_speed()},
            {"wind_from", weather.wind_from()},
            {"gust_factor", weather.gust_factor()},
            {"gust_period", weather.gust_period()},
            {"veering", weather.veering()},
            {"wave_height", weather.wave_height()},
            {"wave_period", weather.wave_period()},
            {"wave_from", weather.wave_from()},
            {"swell_height", weather.swell_height()},
            {"swell_period", weather.swell_period()},
            {"swell_from", weather.swell_from()},
            {"wave_seed", weather.wave_seed()},
            {"current_speed", weather.current_speed()},
            {"current_towards", weather.current_towards()},
            {"current_profile", profile},
            {"tide_height", weather.tide_height()},
            {"visibility", weather.visibility()},
            {"time_of_day", weather.time_of_day()}};
}

/// Event and SeatEvent name these alike.
template <class T>
json event_json(const char* kind, const T& event) {
    return {{kind, event.code().to_string()},     {"number", event.number()},        {"time", event.time()},
            {"severity", name(event.severity())}, {"side", side_name(event.side())}, {"value", event.value()},
            {"text", event.text().to_string()}};
}

} // namespace

json to_json(const FaultStatus& fault) {
    return {{"code", name(fault.code())},
            {"side", side_name(fault.side())},
            {"phase", name(fault.phase())},
            {"severity", fault.severity()},
            {"severity_now", fault.severity_now()},
            {"ramp", fault.ramp()},
            {"trigger", name(fault.trigger())},
            {"trigger_value", fault.trigger_value()},
            {"trigger_until", fault.trigger_until()},
            {"trigger_event", fault.trigger_event().to_string()},
            {"trigger_order", name(static_cast<BridgeOrderCode>(fault.trigger_order()))},
            {"target", fault.target()}};
}

json to_json(const ExerciseStatus& status) {
    return {{"tick", status.tick()},
            {"time", status.time()},
            {"state", name(status.state())},
            {"time_scale", status.time_scale()},
            {"time_scale_achieved", status.time_scale_achieved()},
            {"exercise", status.exercise().to_string()},
            {"title", status.title().to_string()},
            {"run", status.run()}};
}

json to_json(const ExerciseTruth& truth) {
    json faults = json::array();
    for (const auto& fault : truth.faults())
        faults.push_back(to_json(fault));
    return {{"tick", truth.tick()},
            {"time", truth.time()},
            {"title", truth.title().to_string()},
            // As text: a reader that keeps numbers as doubles would lose the last bits.
            {"state_hash", std::to_string(truth.state_hash())},
            {"definition_hash", std::to_string(truth.definition_hash())},
            {"run", truth.run()},
            {"orders_taken", truth.orders_taken()},
            {"lateness", truth.lateness()},
            {"overruns", truth.overruns()},
            {"commands_refused", truth.commands_refused()},
            {"samples_dropped", truth.samples_dropped()},
            {"model_level", name(truth.model_level())},
            {"model_nodes", truth.model_nodes()},
            {"model_substeps", truth.model_substeps()},
            {"model_error_load", truth.model_error_load()},
            {"model_error_shape", truth.model_error_shape()},
            {"depth", truth.depth()},
            {"faults", faults}};
}

json to_json(const EnvironmentState& environment) {
    return {{"now", weather_json(environment.now())},
            {"after", weather_json(environment.after())},
            {"ramp_left", environment.ramp_left()}};
}

json to_json(const Alert& alert) {
    return {{"code", alert.code().to_string()},
            {"side", side_name(alert.side())},
            {"raised_time", alert.raised_time()},
            {"priority", name(alert.priority())},
            {"condition", name(alert.condition())},
            {"silenced_left", alert.silenced_left()},
            {"value", alert.value()},
            {"text", alert.text().to_string()},
            {"explanation", alert.explanation().to_string()},
            {"deck_panel", alert.deck_panel()},
            {"bridge_panel", alert.bridge_panel()}};
}

json to_json(const BridgeOrder& order) {
    return {{"number", order.number()},     {"time", order.time()},
            {"code", name(order.code())},   {"side", order.side() == -1 ? "both" : side_name(order.side())},
            {"value", order.value()},       {"text", order.text().to_string()},
            {"by", order.by().to_string()}, {"repeat_by", order.repeat_by()},
            {"do_by", order.do_by()},       {"state", name(order.state())}};
}

json to_json(const Event& event) {
    return event_json("event", event);
}

json to_json(const SeatEvent& event) {
    json object = event_json("seat_event", event);
    object["forecastle"] = event.forecastle();
    object["bridge"] = event.bridge();
    return object;
}

json to_json(const Picture& picture, Clock::time_point now) {
    json object = json::object();
    if (picture.status) object["status"] = to_json(*picture.status);
    if (const auto silent = picture.silence(now)) object["silence"] = *silent;
    if (picture.truth) object["truth"] = to_json(*picture.truth);
    if (picture.environment) object["environment"] = to_json(*picture.environment);
    if (picture.ship) object["ship"] = ship_json(*picture.ship);
    if (picture.bridge) object["bridge"] = bridge_json(*picture.bridge);
    for (const Alert& alert : picture.alerts)
        object["alerts"].push_back(to_json(alert));
    for (const BridgeOrder& order : picture.orders)
        object["orders"].push_back(to_json(order));
    for (const int side : {SIDE_PORT, SIDE_STARBOARD}) {
        json tackle = tackle_json(picture.tackle[static_cast<std::size_t>(side)]);
        if (!tackle.empty()) object[std::string{side_name(side)}] = std::move(tackle);
    }
    return object;
}

} // namespace windlass::station
