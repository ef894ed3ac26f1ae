#pragma once
// Codes as files, scripts, lessons and people at a terminal name them. Each list stands in the order of the
// enumerators in windlass.idl and in server/exercise, which are counted from 0.

#include <array>
#include <string_view>

namespace windlass {

/// BridgeOrderCode.
inline constexpr std::array<std::string_view, 23> kBridgeOrderNames{
    "text",        "stand_by",        "clear_away",   "walk_out",    "let_go",   "pay_out",
    "veer",        "check",           "hold_on",      "walk_back",   "gear_in",  "gear_out",
    "heave",       "heave_to",        "stop_heaving", "secure",      "how_much", "how_leading",
    "how_growing", "how_much_weight", "brought_up",   "stand_clear", "cancel"};

/// ReportCode.
inline constexpr std::array<std::string_view, 28> kReportNames{"text",
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

/// AnchorPhase.
inline constexpr std::array<std::string_view, 10> kAnchorPhaseNames{
    "housed",  "acockbill", "hanging", "on_bottom", "digging_in",
    "holding", "dragging",  "aweigh",  "fouled",    "lost"};

/// Soil.
inline constexpr std::array<std::string_view, 7> kSoilNames{"mud",  "sand",  "clay", "gravel",
                                                            "rock", "coral", "mixed"};

} // namespace windlass
