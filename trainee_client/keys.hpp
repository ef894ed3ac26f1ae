#pragma once
// The keyboard as the levers of a trainee.

#include "station/lever_sender.hpp"
#include "trainee_client/script.hpp"

#include <string>

namespace windlass::trainee {

/// One line: which keys do what.
inline constexpr const char* kKeys =
    " brake Up Dn 0 b  lever Lt Rt x  c clutch t stopper e stop wasd helm r report q";

/// Moves the levers as that key does. False when the key moves none.
bool apply_key(int key, station::LeverSet& set);

/// A typed report: "brought up", "shackles in water 3", anything else in the trainee's own words.
ReportOrder parse_report(const std::string& typed);

} // namespace windlass::trainee
