#include "server/exercise/talk/talk.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace windlass::exercise {

namespace {

/// m, from the bridge aft to the forecastle of the longest ships.
constexpr double kSignsSeen = 300;

/// Orders with a hand signal, by agreement on board: those of a winchman (heave, walk back, stop, stand
/// clear), and for letting go and for the brake.
constexpr std::array kSigns{
    BridgeOrderCode::let_go,      BridgeOrderCode::check, BridgeOrderCode::hold_on,
    BridgeOrderCode::walk_back,   BridgeOrderCode::heave, BridgeOrderCode::stop_heaving,
    BridgeOrderCode::stand_clear,
};

bool is_sign(BridgeOrderCode code, double value) {
    return value == 0 && std::ranges::find(kSigns, code) != kSigns.end();
}

} // namespace

Talk talk_of(const std::vector<FaultView>& faults, double visibility) {
    const bool lost = std::ranges::any_of(faults, [](const FaultView& fault) {
        return fault.order.code == FaultCode::vhf_lost && fault.phase == FaultPhase::active &&
               fault.severity_now >= kSetDead;
    });
    return {.vhf = !lost, .in_sight = visibility >= kSignsSeen};
}

bool gets_through(const BridgeOrderGiven& order, const Talk& talk) {
    return talk.vhf || (talk.in_sight && is_sign(order.code, order.value));
}

bool gets_through(const ReportMade& report, const Talk& talk) {
    return talk.vhf || (talk.in_sight && report.code == ReportCode::order_repeated &&
                        is_sign(report.order_code, report.value));
}

std::string bell(const ReportMade& report) {
    switch (report.code) {
    case ReportCode::shackles_on_deck:
    case ReportCode::shackles_in_water:
    case ReportCode::shackles_in_pipe: {
        const auto strokes = std::lround(report.value);
        if (strokes < 1) return {};
        return "bell: " + std::to_string(strokes) + (strokes == 1 ? " stroke" : " strokes");
    }
    case ReportCode::anchor_aweigh:
        return "bell: rung rapidly";
    default:
        return {};
    }
}

} // namespace windlass::exercise
