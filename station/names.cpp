#include "station/names.hpp"

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
constexpr std::array<std::string_view, 10> kAnchorPhases{"housed",     "acockbill", "hanging",  "on_bottom",
                                                         "digging_in", "holding",   "dragging", "aweigh",
                                                         "fouled",     "lost"};
constexpr std::array<std::string_view, 7> kSoils{"mud", "sand", "clay", "gravel", "rock", "coral", "mixed"};
constexpr std::array<std::string_view, 4> kStays{"up_and_down", "short", "medium", "long"};
constexpr std::array<std::string_view, 3> kClutchStates{"out", "engaging", "in"};
constexpr std::array<std::string_view, 4> kSeverities{"info", "caution", "warning", "alarm"};
constexpr std::array<std::string_view, 3> kFaultPhases{"armed", "active", "cleared"};
constexpr std::array<std::string_view, 4> kFaultTriggers{"now", "at_time", "at_cable_out", "at_load"};
constexpr std::array<std::string_view, 3> kModelLevels{"dynamic", "dynamic_with_sleep", "catenary"};
constexpr std::array<std::string_view, 4> kAlertPriorities{"caution", "warning", "alarm", "emergency"};
constexpr std::array<std::string_view, 5> kAlertConditions{
    "active_unacknowledged", "active_silenced", "active_acknowledged", "rectified_unacknowledged", "normal"};
constexpr std::array<std::string_view, 17> kReportCodes{
    "text",         "standing_by", "anchor_ready", "let_go",     "shackles_on_deck", "shackles_in_water",
    "lead",         "brought_up",  "heaving",      "short_stay", "up_and_down",      "anchor_aweigh",
    "clear_anchor", "foul_anchor", "anchor_home",  "dragging",   "order_repeated"};

constexpr std::array<FaultText, 27> kFaults{{
    {"brake-lining-faded", "the lining has lost friction: the brake holds less at the same lever"},
    {"motor-power-lost", "the windlass motor loses power: it can neither heave nor lower"},
    {"clutch-jumps-out", "the dog clutch jumps out of its teeth: the gypsy is on the brake alone"},
    {"load-cell-dead", "the load indicator shows nothing; the load itself is unchanged"},
    {"brake-lining-worn", "the lining is worn thin: the brake holds less and its hand-wheel goes further"},
    {"brake-wet", "water on the lining: less friction until it has dried"},
    {"stopper-pin-out", "the chain stopper's pin works out: it no longer holds"},
    {"hydraulic-pump-lost",
     "pumps fail (0.5: one of two): less flow, and a leaking motor gets less pressure"},
    {"hydraulic-hose-burst", "a hose bursts: pressure is lost, heaving stops"},
    {"drive-trip", "the motor's drive trips; reset it with the speed lever at zero"},
    {"blackout", "the ship has no power"},
    {"clutch-shaft-damaged", "shaft or claw coupling damaged: it shears under load"},
    {"gypsy-pockets-worn", "worn pockets: the cable jumps on the gypsy under load"},
    {"spurling-pipe-jammed",
     "the cable jams below the gypsy: it does not run out, and heaps up when it is hove in"},
    {"chain-link-weak", "a link breaks below its certificate"},
    {"joining-shackle-open", "a joining shackle opens and the cable parts"},
    {"bitter-end-weak", "the bitter end does not hold when all cable has run out"},
    {"chain-counter-drift", "the chain counter shows a wrong length"},
    {"anchor-fouled", "an old cable lies where the flukes dig in, and comes up with them"},
    {"soil-poor", "the ground holds less than the chart promises"},
    {"cctv-lost", "no picture from the forecastle camera"},
    {"vhf-lost", "no talk between bridge and forecastle"},
    {"brake-lining-glazed", "the lining was burnt and is glazed: less friction for good"},
    {"overspeed-protection-lost", "nothing cuts in when the cable drives the motor too fast"},
    {"counterbalance-stuck-open", "the counterbalance valve lets oil by: the cable can drive the motor"},
    {"relief-valve-low", "the relief valve opens too early: less pull"},
    {"cable-twisted", "turns in the cable crowd together as it is hove in and wedge it in the hawse pipe"},
}};

std::string_view at(Names names, std::size_t index) {
    return index < names.size() ? names[index] : std::string_view{"unknown"};
}

template <class Enum>
std::optional<Enum> find(Names names, std::string_view wanted) {
    const auto found = std::ranges::find(names, wanted);
    if (found == names.end()) return std::nullopt;
    return static_cast<Enum>(found - names.begin());
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
    return at(kAnchorPhases, phase);
}
std::string_view name(Soil soil) {
    return at(kSoils, soil);
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
    return at(kReportCodes, code);
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
    return code < kFaults.size() ? kFaults[code].name : std::string_view{"unknown"};
}

std::string_view side_name(int side) {
    if (side == SIDE_PORT) return "port";
    if (side == SIDE_STARBOARD) return "starboard";
    return "neither";
}

std::optional<AnchorPhase> anchor_phase(std::string_view name) {
    return find<AnchorPhase>(kAnchorPhases, name);
}

std::optional<ReportCode> report_code(std::string_view name) {
    return find<ReportCode>(kReportCodes, name);
}

std::optional<FaultCode> fault_code(std::string_view name) {
    const auto found = std::ranges::find(kFaults, name, &FaultText::name);
    if (found == kFaults.end()) return std::nullopt;
    return static_cast<FaultCode>(found - kFaults.begin());
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

std::string lead_and_stay(const ChainState& chain) {
    if (chain.stay() == STAY_UP_AND_DOWN) return words(chain.stay());
    return lead(chain.lead_clock()) + ", " + words(chain.stay());
}

std::string words(ReportCode code, double value) {
    if (code == REPORT_SHACKLES_ON_DECK || code == REPORT_SHACKLES_IN_WATER)
        return fmt::format("{:g} {}", value, spaced(name(code)));
    if (code == REPORT_LEAD) return fmt::format("cable leads {}", lead(value));
    return spaced(name(code));
}

std::span<const FaultText> fault_texts() {
    return kFaults;
}

} // namespace windlass::station
