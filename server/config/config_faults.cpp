#include "server/config/config_faults.hpp"

#include "server/exercise/definition/def_fields.hpp"
#include "words/words.hpp"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace windlass::config {
namespace {

using Json = nlohmann::json;

/// A value from above or below: the trigger for each.
struct Threshold {
    const char* name;
    exercise::FaultTrigger above, below;
};
constexpr std::array kThresholds{
    Threshold{"cable_out", exercise::FaultTrigger::at_cable_out,
              exercise::FaultTrigger::at_cable_out_at_most},
    Threshold{"gypsy_load", exercise::FaultTrigger::at_load, exercise::FaultTrigger::at_load_at_most}};

template <class Enum, class Names>
Enum named(const Names& names, const std::string& name) {
    return static_cast<Enum>(std::find(names.begin(), names.end(), name) - names.begin());
}

void read_when(const Json& when, exercise::FaultOrder& fault) {
    for (const Threshold& threshold : kThresholds) {
        if (!when.contains(threshold.name)) continue;
        const Json& limit = when.at(threshold.name);
        const bool above = limit.contains("above");
        fault.trigger = above ? threshold.above : threshold.below;
        fault.trigger_value = limit.at(above ? "above" : "below");
    }
    if (when.contains("time")) {
        fault.trigger = exercise::FaultTrigger::at_time;
        fault.trigger_value = when.at("time");
    } else if (when.contains("event")) {
        fault.trigger = exercise::FaultTrigger::at_event;
        fault.trigger_event = when.at("event");
    } else if (when.contains("order")) {
        fault.trigger = exercise::FaultTrigger::at_order;
        fault.trigger_order = named<exercise::BridgeOrderCode>(words::kBridgeOrderNames, when.at("order"));
    } else if (when.contains("chance")) {
        fault.trigger = exercise::FaultTrigger::at_chance;
        fault.trigger_value = when.at("chance").at(0);
        fault.trigger_until = when.at("chance").at(1);
    }
}

Json when_to_json(const exercise::FaultOrder& fault) {
    for (const Threshold& threshold : kThresholds) {
        if (fault.trigger == threshold.above) return {{threshold.name, {{"above", fault.trigger_value}}}};
        if (fault.trigger == threshold.below) return {{threshold.name, {{"below", fault.trigger_value}}}};
    }
    switch (fault.trigger) {
    case exercise::FaultTrigger::at_time:
        return {{"time", fault.trigger_value}};
    case exercise::FaultTrigger::at_event:
        return {{"event", fault.trigger_event}};
    case exercise::FaultTrigger::at_order:
        return {{"order", words::row_of(fault.trigger_order).name}};
    case exercise::FaultTrigger::at_chance:
        return {{"chance", {fault.trigger_value, fault.trigger_until}}};
    default:
        return {};
    }
}

} // namespace

std::vector<exercise::FaultOrder> faults_from_json(const Json& document) {
    std::vector<exercise::FaultOrder> faults;
    for (const Json& entry : document.value("faults", Json::array())) {
        exercise::FaultOrder& fault = faults.emplace_back();
        fault.code = named<exercise::FaultCode>(words::kFaultNames, entry.at("code"));
        if (entry.contains("side"))
            fault.side = named<exercise::Side>(exercise::kSideNames, entry.at("side"));
        fault.severity = entry.value("severity", fault.severity);
        fault.ramp = entry.value("ramp", fault.ramp);
        fault.lasts = entry.value("lasts", fault.lasts);
        fault.target = entry.value("target", fault.target);
        if (entry.contains("when")) read_when(entry.at("when"), fault);
    }
    return faults;
}

Json faults_to_json(const std::vector<exercise::FaultOrder>& faults) {
    Json list = Json::array();
    for (const exercise::FaultOrder& fault : faults) {
        Json& entry =
            list.emplace_back(Json{{"code", words::row_of(fault.code).name},
                                   {"side", exercise::kSideNames.at(static_cast<std::size_t>(fault.side))},
                                   {"severity", fault.severity},
                                   {"ramp", fault.ramp},
                                   {"lasts", fault.lasts},
                                   {"target", fault.target}});
        if (Json when = when_to_json(fault); !when.is_null()) entry["when"] = std::move(when);
    }
    return list;
}

std::vector<std::string> order_faults(const exercise::ExerciseDef& def) {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < def.faults.size(); ++k) {
        const exercise::FaultOrder& fault = def.faults[k];
        const std::string at = fmt::format("/faults/{}", k);
        const auto require = [&](bool holds, const char* field, const auto& value,
                                 const std::string& allowed) {
            if (!holds)
                lines.push_back(fmt::format("{}/{}: {} is not allowed: {}", at, field, value, allowed));
        };
        const bool fitted =
            std::any_of(def.tackle.begin(), def.tackle.end(),
                        [&](const exercise::GroundTackleDef& tackle) { return tackle.side == fault.side; });
        require(fitted, "side", exercise::kSideNames.at(static_cast<std::size_t>(fault.side)),
                "a side that tackle has");
        const bool window = fault.trigger == exercise::FaultTrigger::at_chance;
        require(!window || fault.trigger_until >= fault.trigger_value, "when/chance/1", fault.trigger_until,
                fmt::format("at least {} s, where the window begins", fault.trigger_value));
        for (std::size_t other = 0; other < k; ++other)
            require(def.faults[other].code != fault.code || def.faults[other].side != fault.side, "code",
                    words::row_of(fault.code).name,
                    "each fault once a side: the later one would take its place");
    }
    return lines;
}

} // namespace windlass::config
