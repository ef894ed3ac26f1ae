#include "server/assess/names.hpp"

#include "common/json_schema.hpp"

#include <algorithm>
#include <array>

namespace windlass::assess {

namespace {

constexpr std::array kOrders{"text",       "stand_by",    "clear_away",  "walk_out",    "let_go",
                             "pay_out",    "veer",        "check",       "hold_on",     "walk_back",
                             "gear_in",    "gear_out",    "heave",       "heave_to",    "stop_heaving",
                             "secure",     "how_much",    "how_leading", "how_growing", "how_much_weight",
                             "brought_up", "stand_clear", "cancel"};
static_assert(kOrders.size() == static_cast<std::size_t>(exercise::BridgeOrderCode::cancel) + 1);

constexpr std::array kReports{"text",
                              "standing_by",
                              "anchor_ready",
                              "let_go",
                              "shackles_on_deck",
                              "shackles_in_water",
                              "lead",
                              "brought_up",
                              "heaving",
                              "short_stay",
                              "up_and_down",
                              "anchor_aweigh",
                              "clear_anchor",
                              "foul_anchor",
                              "anchor_home",
                              "dragging",
                              "order_repeated",
                              "on_the_bottom",
                              "shackles_in_pipe",
                              "growing",
                              "weight",
                              "turns",
                              "secured",
                              "does_not_run",
                              "brake_does_not_hold",
                              "no_power",
                              "stand_clear",
                              "defect"};
static_assert(kReports.size() == static_cast<std::size_t>(exercise::ReportCode::defect) + 1);

constexpr std::array kPhases{"housed",  "acockbill", "hanging", "on_bottom", "digging_in",
                             "holding", "dragging",  "aweigh",  "fouled",    "lost"};
static_assert(kPhases.size() == static_cast<std::size_t>(exercise::AnchorPhase::lost) + 1);

constexpr std::array kKinds{"limit",  "sequence",   "state_at", "order",
                            "report", "prohibited", "final",    "rubric"};

constexpr std::array kEvents{"anchor.acockbill",
                             "anchor.aweigh",
                             "anchor.brought_up",
                             "anchor.digging_in",
                             "anchor.dragging",
                             "anchor.flukes_inboard",
                             "anchor.fouled",
                             "anchor.holding",
                             "anchor.housed",
                             "anchor.let_go",
                             "anchor.on_bottom",
                             "brake.glazed",
                             "brake.hot",
                             "brake.slipping",
                             "brake.waits",
                             "cable.bitter_end",
                             "cable.bitter_end_parted",
                             "cable.lost",
                             "cable.overload",
                             "cable.overstrained",
                             "cable.parted",
                             "cable.shackle",
                             "cable.turns",
                             "cable.wedged",
                             "clutch.refused",
                             "clutch.sheared",
                             "environment.changed",
                             "fault.active",
                             "fault.cleared",
                             "gypsy.jumping",
                             "motor.burst",
                             "motor.overload_trip",
                             "motor.overspeed",
                             "motor.overspeed_trip",
                             "order.cancelled",
                             "order.given",
                             "order.misrepeated",
                             "order.not_heard",
                             "order.not_repeated",
                             "order.repeated",
                             "report.bell",
                             "report.made",
                             "report.not_heard",
                             "ship.afloat",
                             "ship.aground",
                             "spurling_pipe.fast",
                             "spurling_pipe.heaping",
                             "stopper.refused",
                             "stopper.sprung",
                             "watch.circle"};

} // namespace

std::span<const char* const> order_names() {
    return kOrders;
}
std::span<const char* const> report_names() {
    return kReports;
}
std::span<const char* const> phase_names() {
    return kPhases;
}
std::span<const char* const> kind_names() {
    return kKinds;
}
std::span<const char* const> event_names() {
    return kEvents;
}

int place_of(std::span<const char* const> names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::string unknown(const std::string& name, const std::vector<std::string>& known) {
    std::string text = '"' + name + "\" is not known; ";
    if (const std::string near = exercise::nearest_name(name, known); !near.empty())
        return text + "the nearest is \"" + near + '"';
    if (known.empty()) return text + "there are none";
    text += "there are: ";
    for (std::size_t k = 0; k < known.size(); ++k)
        text += (k > 0 ? ", " : "") + known[k];
    return text;
}

} // namespace windlass::assess
