#pragma once
// Names of the wire's enumerators: one for machines (JSON, options, scripts) and one for people.

#include "idl/types.hpp"

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
std::string_view name(BridgeOrderCode code); ///< "let_go"
std::string_view name(BridgeOrderState state);
std::string_view name(LiningSeen lining);
std::string_view name(AnchorSeen anchor);
std::string_view name(CriterionKind kind);
std::string_view name(CriterionState state);
std::string_view side_name(int side); ///< "port", "starboard", "neither"

/// The enumerator of that machine name, or nothing.
std::optional<AnchorPhase> anchor_phase(std::string_view name);
std::optional<FaultCode> fault_code(std::string_view name);
std::optional<ReportCode> report_code(std::string_view name);
std::optional<BridgeOrderCode> bridge_order_code(std::string_view name); ///< "let_go", or "let-go" as typed
std::optional<StayGiven> stay_given(std::string_view name);              ///< "short", "up_and_down"
std::optional<Growing> growing(std::string_view name);                   ///< "slack", "growing", "tight"
std::optional<DeckWork> deck_work(std::string_view name);                ///< "break_cable"
std::optional<CableWeight> cable_weight(std::string_view name);          ///< "moderate", "too_much"

/// What a seaman says for it: "on the bottom", "medium stay", "brought up".
std::string words(AnchorPhase phase);
std::string words(Stay stay);
std::string_view words(BridgeOrderState state); ///< "not yet repeated"
std::string_view words(AnchorSeen anchor);      ///< "in sight, clear"
std::string_view words(CriterionKind kind);     ///< "order of steps"
/// "not met"; of one that an assessor judges and has not, "not judged".
std::string_view words(CriterionState state, CriterionKind kind);
/// What a report says: "3 shackles in the water", "port cable is leading 11 o'clock, short stay", "repeats:
/// hold on port cable at 6 shackles in the pipe"; its own text behind it.
std::string words(const Report& report);
/// As spoken: "hold on port cable at 6 shackles in the pipe"; what is said beside it behind it.
std::string words(const BridgeOrder& order);
/// The same of code, side and value.
std::string words(BridgeOrderCode code, int side, double value);
/// Unit of the number that goes with an order: "shackles", or "m" for WALK_OUT; empty: none goes with it.
std::string_view value_unit(BridgeOrderCode code);
/// An order that is said without a number too: "hold on", "walk back".
bool value_may_be_left_out(BridgeOrderCode code);

} // namespace windlass::station
