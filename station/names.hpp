#pragma once
// Names of the wire's enumerators: one for machines (JSON, options, scripts) and one for people.

#include <windlass.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace windlass::station {

/// Machine name of an enumerator, e.g. "on_bottom", "brake-lining-faded"; "unknown" when out of range.
std::string_view name(RunState state);
std::string_view name(AnchorPhase phase);
std::string_view name(Soil soil);
std::string_view name(Stay stay);
std::string_view name(ClutchState clutch);
std::string_view name(EventSeverity severity);
std::string_view name(FaultCode code);
std::string_view name(FaultPhase phase);
std::string_view name(FaultTrigger trigger);
std::string_view name(ReportCode code);
std::string_view name(ModelLevel level);
std::string_view name(AlertPriority priority);
std::string_view name(AlertCondition condition);
std::string_view side_name(int side); ///< "port", "starboard", "neither"

/// The enumerator of that machine name, or nothing.
std::optional<AnchorPhase> anchor_phase(std::string_view name);
std::optional<FaultCode> fault_code(std::string_view name);
std::optional<ReportCode> report_code(std::string_view name);

/// What a seaman says for it: "on the bottom", "medium stay", "brought up".
std::string words(AnchorPhase phase);
std::string words(Stay stay);
/// "11 o'clock, medium stay"; a cable up and down leads nowhere: "up and down".
std::string lead_and_stay(const ChainState& chain);
std::string words(ReportCode code,
                  double value = 0); ///< value where the report has one: "3 shackles in water"

/// Every fault code of the wire, in the order of its enumerators.
struct FaultText {
    std::string_view name;
    std::string_view explanation; ///< one line: cause, and what the trainee sees
};
std::span<const FaultText> fault_texts();

} // namespace windlass::station
