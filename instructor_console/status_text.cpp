#include "instructor_console/status_text.hpp"

#include "server/exercise/orders.hpp"
#include "station/format.hpp"
#include "station/names.hpp"

#include <fmt/format.h>

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
    case TRIGGER_AT_LOAD:
        return " at " + load(fault.trigger_value());
    }
    return "";
}

} // namespace

std::string status_text(const ExerciseStatus& status) {
    std::string text = fmt::format("{} ({})\n", status.title().c_str(), status.exercise().c_str());
    const auto row = [&text](std::string_view label, const std::string& value) {
        text += fmt::format("  {:<12} {}\n", label, value);
    };
    row("state", std::string{name(status.state())});
    row("time", fmt::format("{}  (tick {})", clock(status.time()), status.tick()));
    row("time scale", fmt::format("{}, achieved {:.2f}",
                                  status.time_scale() > 0 ? fmt::format("{:g}", status.time_scale())
                                                          : std::string{"as fast as possible"},
                                  status.time_scale_achieved()));
    row("depth", fmt::format("{:.1f} m", status.depth()));
    row("wind", fmt::format("{} from {}", knots(status.wind_speed()), bearing(status.wind_from())));
    row("current",
        fmt::format("{} towards {}", knots(status.current_speed()), bearing(status.current_towards())));
    row("model", fmt::format("{}, {} nodes, {} substeps", name(status.model_level()), status.model_nodes(),
                             status.model_substeps()));
    row("overruns", fmt::format("{}", status.overruns()));
    row("refused", fmt::format("{} commands", status.commands_refused()));
    row("dropped", fmt::format("{} snapshots", status.samples_dropped()));
    for (const auto& fault : status.faults())
        row("fault", fmt::format("{} {}: {}, severity {:g}{}", side_name(fault.side()), name(fault.code()),
                                 name(fault.phase()), fault.severity(), trigger_text(fault)));
    return text;
}

std::string fault_list() {
    std::string text;
    int number = 0;
    for (const FaultText& fault : fault_texts())
        text += fmt::format(
            "{:<26} {}{}\n", fault.name, fault.explanation,
            exercise::modelled(static_cast<exercise::FaultCode>(number++)) ? "" : " [not modelled yet]");
    return text;
}

} // namespace windlass::console
