#include "server/assess/names.hpp"

#include "common/code_names.hpp"
#include "common/json_schema.hpp"

#include <algorithm>
#include <array>

namespace windlass::assess {

namespace {

static_assert(kBridgeOrderNames.size() == static_cast<std::size_t>(exercise::BridgeOrderCode::cancel) + 1);
static_assert(kReportNames.size() == static_cast<std::size_t>(exercise::ReportCode::defect) + 1);
static_assert(kAnchorPhaseNames.size() == static_cast<std::size_t>(exercise::AnchorPhase::lost) + 1);

constexpr std::array<std::string_view, 8> kKinds{"limit",  "sequence",   "state_at", "order",
                                                 "report", "prohibited", "final",    "rubric"};

constexpr std::array<std::string_view, 50> kEvents{"anchor.acockbill",
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

std::span<const std::string_view> kind_names() {
    return kKinds;
}
std::span<const std::string_view> event_names() {
    return kEvents;
}

int place_of(std::span<const std::string_view> names, const std::string& name) {
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
