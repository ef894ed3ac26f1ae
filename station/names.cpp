#include "station/names.hpp"

#include "words/words.hpp"

#include <algorithm>
#include <array>

namespace windlass::station {

namespace {

/// What a table has for an enumerator; a station may meet one that it does not know.
template <class Row, std::size_t N>
std::string_view name_in(const std::array<Row, N>& rows, std::size_t index) {
    return index < N ? rows[index].name : std::string_view{"unknown"};
}
template <class Row, std::size_t N>
std::string_view said_in(const std::array<Row, N>& rows, std::size_t index) {
    return index < N ? rows[index].said : std::string_view{"unknown"};
}

template <class Enum, class Row, std::size_t N>
std::optional<Enum> find(const std::array<Row, N>& rows, std::string_view wanted) {
    const int place = words::place_of(rows, wanted);
    if (place < 0) return std::nullopt;
    return static_cast<Enum>(place);
}

/// Not the first: it stands for what was left open.
template <class Enum, class Row, std::size_t N>
std::optional<Enum> find_given(const std::array<Row, N>& rows, std::string_view wanted) {
    const auto found = find<Enum>(rows, wanted);
    return found && *found != 0 ? found : std::nullopt;
}

} // namespace

std::string_view name(RunState state) {
    return name_in(words::kRunState, state);
}
std::string_view name(AnchorPhase phase) {
    return name_in(words::kAnchorPhase, phase);
}
std::string_view name(Soil soil) {
    return name_in(words::kSoil, soil);
}
std::string_view name(Stay stay) {
    return name_in(words::kStay, stay);
}
std::string_view name(ClutchState clutch) {
    return name_in(words::kClutchState, clutch);
}
std::string_view name(EventSeverity severity) {
    return name_in(words::kEventSeverity, severity);
}
std::string_view name(FaultPhase phase) {
    return name_in(words::kFaultPhase, phase);
}
std::string_view name(FaultTrigger trigger) {
    return name_in(words::kFaultTrigger, trigger);
}
std::string_view name(ReportCode code) {
    return name_in(words::kReportCode, code);
}
std::string_view name(ModelLevel level) {
    return name_in(words::kModelLevel, level);
}
std::string_view name(AlertPriority priority) {
    return name_in(words::kAlertPriority, priority);
}
std::string_view name(AlertCondition condition) {
    return name_in(words::kAlertCondition, condition);
}

std::string_view name(FaultCode code) {
    return name_in(words::kFaultCode, code);
}
std::string_view name(BridgeOrderState state) {
    return name_in(words::kBridgeOrderState, state);
}
std::string_view name(LiningSeen lining) {
    return name_in(words::kLiningSeen, lining);
}
std::string_view name(AnchorSeen anchor) {
    return name_in(words::kAnchorSeen, anchor);
}
std::string_view name(BridgeOrderCode code) {
    return name_in(words::kBridgeOrderCode, code);
}

std::string_view name(CriterionKind kind) {
    return name_in(words::kCriterionKind, kind);
}
std::string_view name(CriterionState state) {
    return name_in(words::kCriterionState, state);
}

std::string_view side_name(int side) {
    if (side == SIDE_PORT) return "port";
    if (side == SIDE_STARBOARD) return "starboard";
    return "neither";
}

std::optional<AnchorPhase> anchor_phase(std::string_view name) {
    return find<AnchorPhase>(words::kAnchorPhase, name);
}

std::optional<ReportCode> report_code(std::string_view name) {
    return find<ReportCode>(words::kReportCode, name);
}

std::optional<FaultCode> fault_code(std::string_view name) {
    return find<FaultCode>(words::kFaultCode, name);
}

std::optional<StayGiven> stay_given(std::string_view name) {
    return find_given<StayGiven>(words::kStayGiven, name);
}
std::optional<Growing> growing(std::string_view name) {
    return find_given<Growing>(words::kGrowing, name);
}
std::optional<CableWeight> cable_weight(std::string_view name) {
    return find_given<CableWeight>(words::kCableWeight, name);
}

std::optional<DeckWork> deck_work(std::string_view name) {
    return find<DeckWork>(words::kDeckWork, std::string{name});
}

std::optional<BridgeOrderCode> bridge_order_code(std::string_view name) {
    std::string wanted{name};
    std::ranges::replace(wanted, '-', '_');
    return find<BridgeOrderCode>(words::kBridgeOrderCode, wanted);
}

std::string words(AnchorPhase phase) {
    return std::string{said_in(words::kAnchorPhase, phase)};
}

std::string words(Stay stay) {
    return std::string{said_in(words::kStay, stay)};
}
std::string_view words(BridgeOrderState state) {
    return said_in(words::kBridgeOrderState, state);
}
std::string_view words(AnchorSeen anchor) {
    return said_in(words::kAnchorSeen, anchor);
}
std::string_view words(CriterionKind kind) {
    return said_in(words::kCriterionKind, kind);
}
std::string_view words(CriterionState state, CriterionKind kind) {
    const std::string_view unjudged = words::kCriterionKind.at(static_cast<std::size_t>(kind)).unjudged;
    if (state == CRITERION_NOT_IN_PLAY && !unjudged.empty()) return unjudged;
    return said_in(words::kCriterionState, state);
}

std::string_view value_unit(BridgeOrderCode code) {
    if (code >= words::kBridgeOrderCode.size()) return "";
    const words::Unit unit = words::kBridgeOrderCode[code].unit;
    return unit == words::Unit::none ? "" : words::words_of(unit).written;
}

bool value_may_be_left_out(BridgeOrderCode code) {
    return value_unit(code).empty() || !words::kBridgeOrderCode[code].said_bare.empty();
}

std::string words(BridgeOrderCode code, int side, double value) {
    return code < words::kBridgeOrderCode.size() ? words::order_text(code, side, value) : "unknown order";
}

std::string words(const BridgeOrder& order) {
    const std::string text = order.text().to_string();
    if (order.code() == BRIDGE_ORDER_TEXT) return text;
    return words::order_with(words(order.code(), order.side(), order.value()), text);
}

std::string words(const Report& report) {
    return words::report_text({.code = report.code(),
                               .side = report.side(),
                               .value = report.value(),
                               .lead = report.lead(),
                               .stay = report.stay(),
                               .growing = report.growing(),
                               .weight = report.weight(),
                               .order_code = report.order_code(),
                               .text = report.text().to_string()});
}

} // namespace windlass::station
