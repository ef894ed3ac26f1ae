#include "station/names.hpp"

#include "common/code_names.hpp"
#include "station/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace windlass::station {

namespace {

using Names = std::span<const std::string_view>;

// Each table stands in the order of the enumerators in windlass.idl, which are counted from 0 on the wire.
constexpr std::array<std::string_view, 6> kRunStates{"ready",    "running",          "paused",
                                                     "finished", "stopped_by_fault", "replay"};
constexpr std::array<std::string_view, 4> kStays{"up_and_down", "short", "medium", "long"};
constexpr std::array<std::string_view, 3> kClutchStates{"out", "engaging", "in"};
constexpr std::array<std::string_view, 4> kSeverities{"info", "caution", "warning", "alarm"};
constexpr std::array<std::string_view, 3> kFaultPhases{"armed", "active", "cleared"};
constexpr std::array<std::string_view, 9> kFaultTriggers{
    "now",      "at_time",  "at_cable_out", "at_load", "at_cable_out_at_most", "at_load_at_most",
    "at_event", "at_order", "at_chance"};
constexpr std::array<std::string_view, 3> kModelLevels{"dynamic", "dynamic_with_sleep", "catenary"};
constexpr std::array<std::string_view, 4> kAlertPriorities{"caution", "warning", "alarm", "emergency"};
constexpr std::array<std::string_view, 5> kAlertConditions{
    "active_unacknowledged", "active_silenced", "active_acknowledged", "rectified_unacknowledged", "normal"};
constexpr std::array<std::string_view, 5> kStaysGiven{"not_given", "up_and_down", "short", "medium", "long"};
constexpr std::array<std::string_view, 4> kGrowing{"not_given", "slack", "growing", "tight"};
constexpr std::array<std::string_view, 5> kWeights{"not_given", "none", "moderate", "much", "too_much"};
constexpr std::array<std::string_view, 5> kLinings{"cool", "warm", "smells", "smokes", "burns"};
constexpr std::array<std::string_view, 5> kAnchorsSeen{"home", "acockbill", "under_water", "clear", "foul"};
constexpr std::array<std::string_view, 5> kOrderStates{"given", "repeated", "misrepeated", "not_repeated",
                                                       "cancelled"};

/// An order of the bridge: what is said, and the unit of its number.
struct OrderWords {
    std::string_view said;
    std::string_view unit = "";         ///< empty: no number
    std::string_view before_value = ""; ///< "at", "to"
    bool bare_too = false;              ///< also said without a number
};
constexpr std::array<OrderWords, kBridgeOrderNames.size()> kOrders{{{""},
                                                                    {"stand by"},
                                                                    {"clear away"},
                                                                    {"walk out", "m", "to"},
                                                                    {"let go"},
                                                                    {"pay out", "shackles", "to"},
                                                                    {"veer", "shackles", "to"},
                                                                    {"check"},
                                                                    {"hold on", "shackles", "at", true},
                                                                    {"walk back", "shackles", "to", true},
                                                                    {"put in gear"},
                                                                    {"gear out"},
                                                                    {"heave up"},
                                                                    {"heave", "shackles", "to"},
                                                                    {"stop heaving"},
                                                                    {"secure"},
                                                                    {"how much is out?"},
                                                                    {"how does the cable lead?"},
                                                                    {"how does the cable grow?"},
                                                                    {"how much weight is on it?"},
                                                                    {"brought up?"},
                                                                    {"stand clear"},
                                                                    {"belay the last order"}}};

// In the order of FaultCode; a test holds them against those of server/exercise.
constexpr std::array<std::string_view, 36> kFaults{"brake-lining-faded",
                                                   "motor-power-lost",
                                                   "clutch-jumps-out",
                                                   "load-cell-dead",
                                                   "brake-lining-worn",
                                                   "brake-wet",
                                                   "stopper-pin-out",
                                                   "hydraulic-pump-lost",
                                                   "hydraulic-hose-burst",
                                                   "drive-trip",
                                                   "blackout",
                                                   "clutch-shaft-damaged",
                                                   "gypsy-pockets-worn",
                                                   "spurling-pipe-jammed",
                                                   "chain-link-weak",
                                                   "joining-shackle-open",
                                                   "bitter-end-weak",
                                                   "chain-counter-drift",
                                                   "anchor-fouled",
                                                   "soil-poor",
                                                   "cctv-lost",
                                                   "vhf-lost",
                                                   "brake-lining-glazed",
                                                   "overspeed-protection-lost",
                                                   "counterbalance-stuck-open",
                                                   "relief-valve-low",
                                                   "cable-twisted",
                                                   "brake-seized",
                                                   "clutch-seized",
                                                   "stopper-jammed",
                                                   "overload-relay-misset",
                                                   "phase-lost",
                                                   "flukes-seized",
                                                   "load-cell-bias",
                                                   "telegraph-failed",
                                                   "ship-blackout"};

std::string_view at(Names names, std::size_t index) {
    return index < names.size() ? names[index] : std::string_view{"unknown"};
}

template <class Enum>
std::optional<Enum> find(Names names, std::string_view wanted) {
    const auto found = std::ranges::find(names, wanted);
    if (found == names.end()) return std::nullopt;
    return static_cast<Enum>(found - names.begin());
}

/// Not the first: it stands for what was left open.
template <class Enum>
std::optional<Enum> find_given(Names names, std::string_view wanted) {
    const auto found = find<Enum>(names, wanted);
    return found && *found != 0 ? found : std::nullopt;
}

std::string spaced(std::string_view name) {
    std::string text{name};
    std::ranges::replace(text, '_', ' ');
    return text;
}

} // namespace

std::string_view name(RunState state) {
    return at(kRunStates, state);
}
std::string_view name(AnchorPhase phase) {
    return at(kAnchorPhaseNames, phase);
}
std::string_view name(Soil soil) {
    return at(kSoilNames, soil);
}
std::string_view name(Stay stay) {
    return at(kStays, stay);
}
std::string_view name(ClutchState clutch) {
    return at(kClutchStates, clutch);
}
std::string_view name(EventSeverity severity) {
    return at(kSeverities, severity);
}
std::string_view name(FaultPhase phase) {
    return at(kFaultPhases, phase);
}
std::string_view name(FaultTrigger trigger) {
    return at(kFaultTriggers, trigger);
}
std::string_view name(ReportCode code) {
    return at(kReportNames, code);
}
std::string_view name(ModelLevel level) {
    return at(kModelLevels, level);
}
std::string_view name(AlertPriority priority) {
    return at(kAlertPriorities, priority);
}
std::string_view name(AlertCondition condition) {
    return at(kAlertConditions, condition);
}

std::string_view name(FaultCode code) {
    return at(kFaults, code);
}
std::string_view name(BridgeOrderState state) {
    return at(kOrderStates, state);
}
std::string_view name(LiningSeen lining) {
    return at(kLinings, lining);
}
std::string_view name(AnchorSeen anchor) {
    return at(kAnchorsSeen, anchor);
}
std::string_view name(BridgeOrderCode code) {
    return at(kBridgeOrderNames, code);
}

std::string_view side_name(int side) {
    if (side == SIDE_PORT) return "port";
    if (side == SIDE_STARBOARD) return "starboard";
    return "neither";
}

std::optional<AnchorPhase> anchor_phase(std::string_view name) {
    return find<AnchorPhase>(kAnchorPhaseNames, name);
}

std::optional<ReportCode> report_code(std::string_view name) {
    return find<ReportCode>(kReportNames, name);
}

std::optional<FaultCode> fault_code(std::string_view name) {
    return find<FaultCode>(kFaults, name);
}

std::optional<StayGiven> stay_given(std::string_view name) {
    return find_given<StayGiven>(kStaysGiven, name);
}
std::optional<Growing> growing(std::string_view name) {
    return find_given<Growing>(kGrowing, name);
}
std::optional<CableWeight> cable_weight(std::string_view name) {
    return find_given<CableWeight>(kWeights, name);
}

std::optional<BridgeOrderCode> bridge_order_code(std::string_view name) {
    std::string wanted{name};
    std::ranges::replace(wanted, '-', '_');
    return find<BridgeOrderCode>(kBridgeOrderNames, wanted);
}

std::string words(AnchorPhase phase) {
    if (phase == ANCHOR_ACOCKBILL) return "a'cockbill";
    if (phase == ANCHOR_ON_BOTTOM) return "on the bottom";
    return spaced(name(phase));
}

std::string words(Stay stay) {
    if (stay == STAY_UP_AND_DOWN) return "up and down";
    return std::string{name(stay)} + " stay";
}

std::string_view value_unit(BridgeOrderCode code) {
    return code < kOrders.size() ? kOrders[code].unit : "";
}

bool value_may_be_left_out(BridgeOrderCode code) {
    return code >= kOrders.size() || kOrders[code].unit.empty() || kOrders[code].bare_too;
}

std::string words(BridgeOrderCode code, int side, double value) {
    if (code >= kOrders.size()) return "unknown order";
    const OrderWords& order = kOrders[code];
    const bool of_one = side == SIDE_PORT || side == SIDE_STARBOARD;
    std::string text =
        fmt::format("{}: {}", of_one ? std::string{side_name(side)} : std::string{"both"}, order.said);
    if (order.unit.empty() || (order.bare_too && value == 0)) return text;
    text += fmt::format(" {} {:g} ", order.before_value, value);
    if (order.unit == "m") return text + "m";
    return text + (value == 1 ? "shackle" : "shackles") + " in the pipe";
}

std::string words(const BridgeOrder& order) {
    const std::string text = order.text().to_string();
    if (order.code() == BRIDGE_ORDER_TEXT) return text;
    return words(order.code(), order.side(), order.value()) + (text.empty() ? "" : " (" + text + ")");
}

std::string words(const Report& report) {
    if (const std::string text = report.text().to_string(); !text.empty()) return text;
    const ReportCode code = report.code();
    if (code == REPORT_ORDER_REPEATED)
        return "repeats: " + words(report.order_code(), report.side(), report.value());
    std::string text = spaced(name(code));
    if (code == REPORT_SHACKLES_ON_DECK || code == REPORT_SHACKLES_IN_WATER ||
        code == REPORT_SHACKLES_IN_PIPE)
        text = fmt::format("{:g} {}", report.value(), text);
    else if (report.value() != 0)
        text += fmt::format(" {:g}", report.value());
    const auto given = [&text](std::string_view what) { text += (text.empty() ? "" : ", ") + spaced(what); };
    if (report.lead() != 0) given(lead(static_cast<double>(report.lead())));
    if (report.stay() == STAY_GIVEN_UP_AND_DOWN)
        given("up and down");
    else if (report.stay() != STAY_NOT_GIVEN)
        given(std::string{at(kStaysGiven, report.stay())} + " stay");
    if (report.growing() != GROWING_NOT_GIVEN) given(at(kGrowing, report.growing()));
    if (report.weight() != WEIGHT_NOT_GIVEN) given(at(kWeights, report.weight()));
    return text;
}

} // namespace windlass::station
