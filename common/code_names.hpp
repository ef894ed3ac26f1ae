#pragma once
// Codes as files, scripts, lessons and people at a terminal name them. But for the events, each list stands
// in the order of the enumerators in windlass.idl and in server/exercise, which are counted from 0.

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

/// Events that a fault or a lesson may wait for, sorted: those that the exercise itself calls, but for
/// what is told of arming a fault. What a session
/// calls beside it (who has the levers, start and stop, refusals) is no part of what a replay goes through
/// again.
inline constexpr std::array<std::string_view, 60> kEventNames{"anchor.acockbill",
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
                                                              "own_ship.foreign",
                                                              "own_ship.handed_back",
                                                              "own_ship.jumped",
                                                              "own_ship.late",
                                                              "own_ship.lost",
                                                              "report.bell",
                                                              "report.made",
                                                              "report.not_heard",
                                                              "ship.afloat",
                                                              "ship.aground",
                                                              "signals.anchor_ball",
                                                              "signals.anchor_lights",
                                                              "spurling_pipe.fast",
                                                              "spurling_pipe.heaping",
                                                              "stopper.refused",
                                                              "stopper.sprung",
                                                              "watch.circle",
                                                              "watch.dragging",
                                                              "watch.ended",
                                                              "watch.kept"};

} // namespace windlass
