#include "server/run/fault_dump.hpp"

#include <nlohmann/json.hpp>

#include <cctype>
#include <fstream>
#include <stdexcept>

namespace windlass::server {

namespace {

using nlohmann::json;

constexpr std::size_t kCommandsKept = 256; // over ten seconds of two clients at 10 Hz

json to_json(const physics::Vec3& v) {
    return {v.x(), v.y(), v.z()};
}
json to_json(const Eigen::Quaterniond& q) {
    return {q.w(), q.x(), q.y(), q.z()};
}

json to_json(const exercise::WindlassOrder& o) {
    return {{"order", "windlass"},
            {"side", static_cast<int>(o.side)},
            {"brake", o.brake},
            {"speed_lever", o.speed_lever},
            {"clutch_in", o.clutch_in},
            {"stopper_closed", o.stopper_closed},
            {"emergency_stop", o.emergency_stop}};
}

json to_json(const exercise::HelmOrder& o) {
    return {{"order", "helm"},
            {"engine", o.engine},
            {"rudder", o.rudder},
            {"bow_thruster", o.bow_thruster},
            {"stern_thruster", o.stern_thruster}};
}

json to_json(const exercise::FaultOrder& o) {
    return {{"order", "fault"},
            {"code", static_cast<int>(o.code)},
            {"side", static_cast<int>(o.side)},
            {"severity", o.severity},
            {"ramp", o.ramp},
            {"trigger", static_cast<int>(o.trigger)},
            {"trigger_value", o.trigger_value},
            {"trigger_until", o.trigger_until},
            {"trigger_event", o.trigger_event},
            {"trigger_order", static_cast<int>(o.trigger_order)},
            {"target", o.target},
            {"clear", o.clear}};
}

json to_json(const exercise::Weather& w) {
    return {{"wind_speed", w.wind_speed},
            {"wind_from", w.wind_from},
            {"veering", w.veering},
            {"current_speed", w.current_speed},
            {"current_towards", w.current_towards}};
}

json to_json(const exercise::EnvironmentOrder& o) {
    return {{"order", "environment"}, {"weather", to_json(o.weather)}, {"ramp", o.ramp}};
}

json to_json(const exercise::ReportMade& o) {
    return {{"order", "report"}, {"code", static_cast<int>(o.code)}, {"side", o.side},
            {"value", o.value},  {"order_number", o.order_number},   {"text", o.text}};
}

json to_json(const exercise::BridgeOrderGiven& o) {
    return {{"order", "bridge"}, {"code", static_cast<int>(o.code)},
            {"side", o.side},    {"value", o.value},
            {"by", o.by},        {"text", o.text}};
}

json to_json(const exercise::WatchCircleOrder& o) {
    return {{"order", "watch_circle"}, {"kept", o.kept}, {"x", o.x}, {"y", o.y}, {"radius", o.radius}};
}

json to_json(const exercise::LightsAndShapes& o) {
    return {
        {"order", "lights_and_shapes"}, {"anchor_ball", o.anchor_ball}, {"anchor_lights", o.anchor_lights}};
}

json to_json(const exercise::ChanceDrawn& o) {
    return {{"order", "chance"}, {"share", o.share}};
}

json to_json(const exercise::OwnShipSample& o) {
    return {{"order", "own_ship"},
            {"position", to_json(o.position)},
            {"attitude_wxyz", to_json(o.attitude)},
            {"velocity", to_json(o.velocity)},
            {"spin", to_json(o.spin)},
            {"time", o.time}};
}

json to_json(const exercise::AssessorsWord& o) {
    return {{"order", "assessor's word"}, {"criterion", o.criterion}, {"note", o.note}};
}

json to_json(const exercise::ShipView& ship) {
    return {{"position", to_json(ship.position)},
            {"attitude_wxyz", to_json(ship.attitude)},
            {"heading", ship.heading},
            {"velocity", to_json(ship.velocity)},
            {"yaw_rate", ship.yaw_rate},
            {"engine", ship.engine},
            {"rudder", ship.rudder}};
}

json to_json(const exercise::TackleView& tackle) {
    json nodes = json::array();
    for (const auto& node : tackle.chain.nodes)
        nodes.push_back({node.x(), node.y(), node.z()});
    const auto& anchor = tackle.anchor;
    const auto& windlass = tackle.windlass;
    return {{"side", static_cast<int>(tackle.side)},
            {"anchor",
             {{"phase", static_cast<int>(anchor.phase)},
              {"position", to_json(anchor.position)},
              {"attitude_wxyz", to_json(anchor.attitude)},
              {"velocity", to_json(anchor.velocity)}}},
            {"chain",
             {{"cable_out", tackle.chain.cable_out}, {"nodes", nodes}, {"tension", tackle.chain.tension}}},
            {"windlass",
             {{"hawse_tension", windlass.hawse_tension},
              {"gypsy_load", windlass.gypsy_load},
              {"brake_load", windlass.brake_load},
              {"cable_speed", windlass.cable_speed},
              {"brake_position", windlass.brake_position},
              {"lining_temperature", windlass.lining_temperature},
              {"speed_lever", windlass.speed_lever},
              {"clutch", static_cast<int>(windlass.clutch)},
              {"stopper_closed", windlass.stopper_closed}}}};
}

/// A file name from a name that people chose.
std::string file_safe(std::string name) {
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '_';
    }
    return name;
}

} // namespace

void CommandHistory::add(std::uint64_t tick, const exercise::Order& command) {
    if (entries_.size() == kCommandsKept) entries_.pop_front();
    entries_.push_back({tick, command});
}

std::filesystem::path write_fault_dump(const std::filesystem::path& folder, const std::string& exercise,
                                       const exercise::Snapshot& last_good, const CommandHistory& history) {
    json commands = json::array();
    for (const auto& entry : history.entries()) {
        json command = std::visit([](const auto& order) { return to_json(order); }, entry.command);
        command["tick"] = entry.tick;
        commands.push_back(std::move(command));
    }
    json tackle = json::array();
    for (const auto& one : last_good.tackle)
        tackle.push_back(to_json(one));
    const json dump{{"exercise", exercise},
                    {"last_good_tick", last_good.tick},
                    {"last_good_time", last_good.time},
                    {"state_hash", last_good.state_hash},
                    {"depth", last_good.environment.depth},
                    {"environment", to_json(last_good.environment.now)},
                    {"ship", to_json(last_good.ship)},
                    {"tackle", tackle},
                    {"commands", commands}};
    auto path =
        folder / ("windlass-fault-" + file_safe(exercise) + "-" + std::to_string(last_good.tick) + ".json");
    std::ofstream file(path);
    file << dump.dump(1) << '\n';
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path.string());
    return path;
}

} // namespace windlass::server
