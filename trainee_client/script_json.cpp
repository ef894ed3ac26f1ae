#include "trainee_client/script.hpp"

#include "common/json_file.hpp"
#include "common/json_schema.hpp"
#include "embedded/script_schema.hpp"
#include "station/names.hpp"

#include <nlohmann/json.hpp>

#include <numbers>

namespace windlass::trainee {

using nlohmann::json;

namespace {

// The schema has been checked before: every value below has the type, range and name that it asks for.

template <class T>
void read(const json& object, const char* name, std::optional<T>& value) {
    if (object.contains(name)) value = object.at(name).get<T>();
}

/// A field with two words, as true for the first of them.
void read_word(const json& object, const char* name, const char* if_true, std::optional<bool>& value) {
    if (object.contains(name)) value = object.at(name).get<std::string>() == if_true;
}

Bounds read_bounds(const Quantity& quantity, const json& value) {
    Bounds bounds{.quantity = &quantity, .at_least = {}, .above = {}, .below = {}};
    if (value.is_number()) {
        bounds.at_least = value.get<double>();
    } else {
        read(value, "above", bounds.above);
        read(value, "below", bounds.below);
    }
    return bounds;
}

Condition read_condition(const json& object) {
    Condition when;
    read(object, "after", when.after);
    for (const Quantity& quantity : quantities())
        if (object.contains(quantity.name))
            when.bounds.push_back(read_bounds(quantity, object.at(quantity.name)));
    read(object, "anchor_on_bottom", when.anchor_on_bottom);
    if (object.contains("anchor_phase"))
        when.anchor_phase = station::anchor_phase(object.at("anchor_phase").get<std::string>());
    read_word(object, "clutch", "in", when.clutch_in);
    read_word(object, "stopper", "on", when.stopper_closed);
    read(object, "event", when.event);
    return when;
}

Orders read_orders(const json& object) {
    Orders orders;
    read(object, "brake", orders.brake);
    read(object, "speed_lever", orders.speed_lever);
    read_word(object, "clutch", "in", orders.clutch_in);
    read_word(object, "stopper", "on", orders.stopper_closed);
    read(object, "emergency_stop", orders.emergency_stop);
    read(object, "engine", orders.engine);
    read(object, "rudder_deg", orders.rudder);
    if (orders.rudder) *orders.rudder *= std::numbers::pi / 180;
    read(object, "bow_thruster", orders.bow_thruster);
    read(object, "stern_thruster", orders.stern_thruster);
    return orders;
}

ReportOrder read_report(const json& object) {
    return {.code = station::report_code(object.at("code").get<std::string>()).value(),
            .value = object.value("value", 0.0),
            .text = object.value("text", "")};
}

Step read_step(const json& object, double default_timeout) {
    Step step;
    step.when = read_condition(object.value("when", json::object()));
    step.orders = read_orders(object.value("do", json::object()));
    if (object.contains("report")) step.report = read_report(object.at("report"));
    step.say = object.value("say", "");
    step.timeout = object.value("timeout", default_timeout);
    return step;
}

} // namespace

Script load_script(const std::filesystem::path& file) {
    const json document = exercise::read_json(file);
    const exercise::JsonSchema schema{embedded::script_schema};
    schema.check(document, file.string());

    const auto default_timeout = schema.json().at("properties").at("timeout").at("default").get<double>();
    const double timeout = document.value("timeout", default_timeout);
    Script script;
    script.title = document.value("title", file.stem().string());
    script.side = document.value("side", "port") == "starboard" ? SIDE_STARBOARD : SIDE_PORT;
    for (const json& step : document.at("steps"))
        script.steps.push_back(read_step(step, timeout));
    return script;
}

} // namespace windlass::trainee
