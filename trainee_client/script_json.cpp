#include "trainee_client/script.hpp"

#include "common/json_file.hpp"
#include "common/json_schema.hpp"
#include "embedded/script_schema.hpp"
#include "station/names.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::trainee {

using nlohmann::json;

namespace {

constexpr double kRepeatsAfter = 2; // s, a mate each order

// The schema has been checked before: every value below has the type, range and name that it asks for.

template <class T>
void read(const json& object, const char* name, std::optional<T>& value) {
    if (object.contains(name)) value = object.at(name).get<T>();
}

/// A field with two words, as true for the first of them.
void read_word(const json& object, const char* name, const char* if_true, std::optional<bool>& value) {
    if (object.contains(name)) value = object.at(name).get<std::string>() == if_true;
}

bool needs_coach(std::string_view condition) {
    const auto found = std::ranges::find(quantities(), condition, &Quantity::name);
    if (found != quantities().end()) return found->eyes == Eyes::coach;
    return condition == "anchor_on_bottom" || condition == "anchor_phase" || condition == "event";
}

/// What a trainee goes by in place of a truth.
std::string_view seen_instead(std::string_view truth) {
    if (truth == "cable_out") return "counter";
    if (truth == "shackles") return "counter_shackles";
    if (truth == "tension" || truth == "brake_load") return "load_cell";
    if (truth == "cable_speed") return "counter_speed, cable_speed_seen";
    if (truth == "ship_speed") return "speed_by_gps";
    if (truth == "surge") return "speed_by_log";
    return "seat_event, counter, counter_speed, load_cell";
}

/// quantity: null for the figure of a report.
Bounds read_bounds(const Quantity* quantity, const json& value) {
    Bounds bounds{.quantity = quantity, .at_least = {}, .above = {}, .below = {}};
    if (value.is_number()) {
        bounds.at_least = value.get<double>();
    } else {
        read(value, "above", bounds.above);
        read(value, "below", bounds.below);
    }
    return bounds;
}

int side_of(const std::string& name) {
    if (name == "both") return -1;
    return name == "starboard" ? SIDE_STARBOARD : SIDE_PORT;
}

Condition read_condition(const json& object) {
    Condition when;
    read(object, "after", when.after);
    for (const Quantity& quantity : quantities())
        if (object.contains(quantity.name))
            when.bounds.push_back(read_bounds(&quantity, object.at(quantity.name)));
    read(object, "anchor_on_bottom", when.anchor_on_bottom);
    if (object.contains("anchor_phase"))
        when.anchor_phase = station::anchor_phase(object.at("anchor_phase").get<std::string>());
    read_word(object, "clutch", "in", when.clutch_in);
    read_word(object, "stopper", "on", when.stopper_closed);
    read(object, "event", when.event);
    read(object, "seat_event", when.seat_event);
    if (object.contains("order"))
        when.order = station::bridge_order_code(object.at("order").get<std::string>());
    if (object.contains("ordered"))
        when.ordered = station::bridge_order_code(object.at("ordered").get<std::string>());
    read(object, "ordered_value", when.ordered_value);
    if (object.contains("reported"))
        when.reported = station::report_code(object.at("reported").get<std::string>());
    if (object.contains("reported_side"))
        when.reported_side = side_of(object.at("reported_side").get<std::string>());
    if (object.contains("reported_value"))
        when.reported_value = read_bounds(nullptr, object.at("reported_value"));
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
    if (orders.rudder) *orders.rudder *= words::units::degree;
    read(object, "bow_thruster", orders.bow_thruster);
    read(object, "stern_thruster", orders.stern_thruster);
    return orders;
}

ReportOrder read_report(const json& object) {
    const auto text = [&object](const char* name) { return object.value(name, ""); };
    ReportOrder report{.code = station::report_code(text("code")).value(),
                       .value = object.value("value", 0.0),
                       .lead = object.value("lead", 0),
                       .stay = station::stay_given(text("stay")).value_or(STAY_NOT_GIVEN),
                       .growing = station::growing(text("growing")).value_or(GROWING_NOT_GIVEN),
                       .weight = station::cable_weight(text("weight")).value_or(WEIGHT_NOT_GIVEN),
                       .side = {},
                       .order = station::bridge_order_code(text("order")),
                       .text = text("text")};
    if (object.contains("side")) report.side = side_of(text("side"));
    return report;
}

BridgesOrder read_bridges_order(const json& object) {
    BridgesOrder order{.code = station::bridge_order_code(object.at("code").get<std::string>()).value(),
                       .value = object.value("value", 0.0),
                       .side = {},
                       .text = object.value("text", "")};
    if (object.contains("side")) order.side = side_of(object.at("side").get<std::string>());
    return order;
}

Step read_step(const json& object, double default_timeout) {
    Step step;
    step.when = read_condition(object.value("when", json::object()));
    step.orders = read_orders(object.value("do", json::object()));
    if (object.contains("show"))
        step.show = {.anchor_ball = object.at("show").at("anchor_ball").get<bool>(),
                     .anchor_lights = object.at("show").at("anchor_lights").get<bool>()};
    if (object.contains("circle"))
        step.circle = {.x = object.at("circle").at("x").get<double>(),
                       .y = object.at("circle").at("y").get<double>(),
                       .radius = object.at("circle").at("radius").get<double>()};
    if (object.contains("deck_work"))
        step.deck_work = station::deck_work(object.at("deck_work").get<std::string>());
    if (object.contains("report")) step.report = read_report(object.at("report"));
    if (object.contains("order")) step.order = read_bridges_order(object.at("order"));
    step.say = object.value("say", "");
    step.timeout = object.value("timeout", default_timeout);
    return step;
}

/// Every condition that looks at the truth, one line each.
std::string truths_looked_at(const json& document, const std::string& file) {
    std::string faults;
    const json& steps = document.at("steps");
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const json when = steps[i].value("when", json::object());
        for (const auto& [name, wanted] : when.items())
            if (needs_coach(name))
                faults +=
                    fmt::format("{}{}: /steps/{}/when/{}: this is the truth, which no seat is given: play "
                                "the script with --coach, or wait for what is seen ({})",
                                faults.empty() ? "" : "\n", file, i, name, seen_instead(name));
    }
    return faults;
}

/// Figures and sides of a report that is not named, one line each.
std::string reports_not_named(const json& document, const std::string& file) {
    std::string faults;
    const json& steps = document.at("steps");
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const json when = steps[i].value("when", json::object());
        for (const char* name : {"reported_side", "reported_value"})
            if (when.contains(name) && !when.contains("reported"))
                faults +=
                    fmt::format("{}{}: /steps/{}/when/{}: {} is not allowed alone: say in \"reported\" of "
                                "which report",
                                faults.empty() ? "" : "\n", file, i, name, when.at(name).dump());
    }
    return faults;
}

} // namespace

Script load_script(const std::filesystem::path& file, Eyes eyes) {
    const json document = read_json(file);
    const JsonSchema schema{embedded::script_schema, [](const std::string&) { return words::json_text(); }};
    schema.check(document, file.string());
    if (const auto faults = reports_not_named(document, file.string()); !faults.empty())
        throw ConfigError(faults);
    if (eyes == Eyes::seat)
        if (const auto faults = truths_looked_at(document, file.string()); !faults.empty())
            throw ConfigError(faults);

    const auto default_timeout = schema.json().at("properties").at("timeout").at("default").get<double>();
    const double timeout = document.value("timeout", default_timeout);
    Script script;
    script.title = document.value("title", file.stem().string());
    script.side = document.value("side", "port") == "starboard" ? SIDE_STARBOARD : SIDE_PORT;
    read(document, "repeats_orders", script.repeats_orders);
    script.mate = document.value("mate", false);
    if (script.mate != document.at("steps").empty())
        throw ConfigError(
            fmt::format("{}: /steps: {} of them are not allowed: none for a mate, who goes by orders, and "
                        "one at least for anybody else",
                        file.string(), document.at("steps").size()));
    if (script.mate && !script.repeats_orders) script.repeats_orders = kRepeatsAfter;
    for (const json& step : document.at("steps"))
        script.steps.push_back(read_step(step, timeout));
    if (document.contains("answers"))
        for (const auto& [id, answer] : document.at("answers").items()) {
            if (answer.is_string())
                script.answers[id] = answer.get<std::string>();
            else
                script.answers[id] = answer.get<double>();
        }
    script.conns = std::ranges::any_of(script.steps, [](const Step& step) { return step.order.has_value(); });
    return script;
}

} // namespace windlass::trainee
