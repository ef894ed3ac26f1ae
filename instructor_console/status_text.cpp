#include "instructor_console/status_text.hpp"

#include "station/format.hpp"
#include "station/json_view.hpp"
#include "station/names.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>

namespace windlass::console {

using namespace station;

namespace {

std::string trigger_text(const FaultStatus& fault) {
    switch (fault.trigger()) {
    case TRIGGER_NOW:
        return "";
    case TRIGGER_AT_TIME:
        return " at " + clock(fault.trigger_value());
    case TRIGGER_AT_CABLE_OUT:
        return " at " + cable(fault.trigger_value()) + " of cable out";
    case TRIGGER_AT_CABLE_OUT_AT_MOST:
        return " at " + cable(fault.trigger_value()) + " of cable out or less";
    case TRIGGER_AT_LOAD:
        return " at " + load(fault.trigger_value());
    case TRIGGER_AT_LOAD_AT_MOST:
        return " at " + load(fault.trigger_value()) + " or less";
    case TRIGGER_AT_EVENT:
        return fmt::format(" at event {}", fault.trigger_event().c_str());
    case TRIGGER_AT_ORDER:
        return fmt::format(" at order {}", name(static_cast<BridgeOrderCode>(fault.trigger_order())));
    case TRIGGER_AT_CHANCE:
        return fmt::format(" between {} and {}", clock(fault.trigger_value()), clock(fault.trigger_until()));
    }
    return "";
}

std::string fault_text(const FaultStatus& fault) {
    std::string text = fmt::format("{} {}: {}, severity {:g}", side_name(fault.side()), name(fault.code()),
                                   name(fault.phase()), fault.severity());
    if (fault.phase() == FAULT_PHASE_ACTIVE && fault.severity_now() != fault.severity())
        text += fmt::format(" (now {:.2f})", fault.severity_now());
    if (fault.ramp() > 0) text += fmt::format(" within {:g} s", fault.ramp());
    if (fault.target() > 0) text += fmt::format(", number {}", fault.target());
    return text + trigger_text(fault);
}

std::string sea_text(double height, double period, double from) {
    return height > 0 ? fmt::format("{:.1f} m, {:.1f} s from {}", height, period, bearing(from))
                      : std::string{"none"};
}

using Row = std::function<void(std::string_view, const std::string&)>;

void weather_rows(const Weather& weather, const Row& row) {
    std::string wind = fmt::format("{} from {}", knots(weather.wind_speed()), bearing(weather.wind_from()));
    if (weather.gust_factor() > 1) wind += fmt::format(", gusts {:.2f} of it", weather.gust_factor());
    if (weather.veering() != 0)
        wind += fmt::format(", {} {:.1f} deg a minute", weather.veering() > 0 ? "veers" : "backs",
                            std::abs(weather.veering()) * 60 / words::units::degree);
    row("wind", wind);
    row("waves", sea_text(weather.wave_height(), weather.wave_period(), weather.wave_from()));
    row("swell", sea_text(weather.swell_height(), weather.swell_period(), weather.swell_from()));
    std::string current =
        fmt::format("{} towards {}", knots(weather.current_speed()), bearing(weather.current_towards()));
    if (!weather.current_profile().empty())
        current += fmt::format(", {} depths", weather.current_profile().size());
    row("current", current);
    row("tide", fmt::format("{:.1f} m", weather.tide_height()));
    const auto minute = static_cast<long>(weather.time_of_day() / 60);
    row("light", fmt::format("{:02}:{:02}, visibility {:.1f} nm", minute / 60 % 24, minute % 60,
                             weather.visibility() / words::units::nautical_mile));
}

} // namespace

std::string status_text(const Picture& picture) {
    const ExerciseStatus& status = *picture.status;
    const bool truth = bool(picture.truth);
    std::string text =
        fmt::format("{} ({})\n", truth ? picture.truth->title().c_str() : status.title().c_str(),
                    status.exercise().c_str());
    const Row row = [&text](std::string_view label, const std::string& value) {
        text += fmt::format("  {:<12} {}\n", label, value);
    };
    row("state", std::string{name(status.state())});
    row("time", fmt::format("{}  (tick {})", clock(status.time()), status.tick()));
    row("time scale", fmt::format("{}, achieved {:.2f}",
                                  status.time_scale() > 0 ? fmt::format("{:g}", status.time_scale())
                                                          : std::string{"as fast as possible"},
                                  status.time_scale_achieved()));
    if (truth) row("depth", fmt::format("{:.1f} m", picture.truth->depth()));
    if (picture.environment) {
        weather_rows(picture.environment->now(), row);
        if (picture.environment->ramp_left() > 0)
            row("changes",
                fmt::format("for {:.0f} s more, wind to {} from {}", picture.environment->ramp_left(),
                            knots(picture.environment->after().wind_speed()),
                            bearing(picture.environment->after().wind_from())));
    }
    if (!truth) return text;
    const ExerciseTruth& known = *picture.truth;
    row("model", fmt::format("{}, {} nodes, {} substeps", name(known.model_level()), known.model_nodes(),
                             known.model_substeps()));
    row("overruns", fmt::format("{}", known.overruns()));
    row("refused", fmt::format("{} commands", known.commands_refused()));
    row("dropped", fmt::format("{} snapshots", known.samples_dropped()));
    for (const auto& fault : known.faults())
        row("fault", fault_text(fault));
    return text;
}

nlohmann::json status_json(const Picture& picture) {
    nlohmann::json object = to_json(*picture.status);
    if (picture.truth) {
        nlohmann::json truth = to_json(*picture.truth);
        object["instructor_title"] = truth["title"];
        for (auto& [name, value] : truth.items())
            if (!object.contains(name)) object[name] = std::move(value);
    }
    if (picture.environment) object["environment"] = to_json(*picture.environment);
    return object;
}

std::string fault_list() {
    std::string text;
    for (const words::Fault& fault : words::kFaultCode)
        text += fmt::format("{:<26} {}\n", fault.name, words::fault_text(fault));
    return text;
}

nlohmann::json fault_json() {
    nlohmann::json list = nlohmann::json::array();
    const nlohmann::json all = nlohmann::json::parse(words::json_text());
    for (const nlohmann::json& row : all.at("/enumerations/FaultCode/oneOf"_json_pointer))
        list.push_back({{"code", row.at("const")},
                        {"wire_name", row.at("enumerator")},
                        {"explanation", words::fault_text(words::kFaultCode.at(list.size()))},
                        {"symptom", row.at("symptom")},
                        {"reason", row.at("reason")},
                        {"way_out", row.at("way_out")},
                        {"severity", row.at("severity")},
                        {"both_sides", row.value("both_sides", false)},
                        {"targets", row.value("targets", "")}});
    return list;
}

} // namespace windlass::console
