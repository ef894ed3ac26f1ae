#pragma once
// The keyboard as the levers of a trainee.

#include "station/lever_sender.hpp"
#include "trainee_client/script.hpp"

#include <array>
#include <optional>
#include <string>

namespace windlass::trainee {

/// One line: which keys do what. The help key `?` says the rest.
inline constexpr const char* kKeys =
    " brake Up Dn 0 b lever Lt Rt x c clutch t stopper e stop r report o order ? help";

/// What `?` shows, line by line.
inline constexpr std::array kHelp{
    "Up Down brake on, off; 0 open, b hard on; Right Left heave, lower; x lever at zero",
    "c clutch, t stopper, e emergency stop; w s engine, a d rudder, , . bow thruster",
    "r report (lead 11 short, growing tight, 3 shackles in water, brought up, ...)",
    "o repeat the bridge's order back; F2 acknowledge the topmost alert, F3 silence all",
    "Tab the other side; q quit"};

/// Moves the levers as that key does. False when the key moves none.
bool apply_key(int key, station::LeverSet& set);

/// A typed report: "brought up", "shackles in water 3", "lead 11 short", "lead up and down", "growing tight",
/// "weight too much"; anything else in the trainee's own words. What is not typed stays open.
ReportOrder parse_report(const std::string& typed);

/// What the report still lacks, as a question: "how many?"; empty: nothing. It may be sent all the same.
std::string left_open(const ReportOrder& report);

/// An order as repeated back: "port", "p 6", "both 3.5". Nothing when no side was typed, or what is typed is
/// neither side nor number.
std::optional<ReportOrder> parse_repeat(const std::string& typed, const BridgeOrder& order);

} // namespace windlass::trainee
