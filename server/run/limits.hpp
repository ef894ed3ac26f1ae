#pragma once
// What the running exercise allows of an order, beyond what holds for all.

#include <array>
#include <string>

namespace windlass::run {

/// Exercise seconds per wall second, as the IDL has it; 0 beside these: as fast as possible.
inline constexpr double kTimeScaleMin = 0.1, kTimeScaleMax = 20;

/// What the running exercise allows beyond the fixed ranges.
struct Limits {
    std::array<bool, 2> side_present{true, false}; ///< port, starboard
    double rudder_max = 0.61;                      ///< rad
    double time_scale = 1;                         ///< asked for
    bool unpaced =
        true; ///< time scale 0 is allowed; not with real-time priority, where it would starve the host
};

/// Under this name the server itself works the levers that nobody has; no client may use it.
inline constexpr const char* kServerName = "server";

/// A file name that a client gives leads nowhere but into the folder that it is looked for in.
bool stays_in_folder(const std::string& name);

} // namespace windlass::run
