#pragma once
// The instructor's own hand on a trainee's levers.

#include "station/client.hpp"

#include <functional>
#include <optional>

namespace windlass::console {

/// Where the levers shall be; what is not given stays as the trainee left it. Units as in WindlassCommand.
struct LeverWish {
    std::optional<double> brake, speed_lever;
    std::optional<bool> clutch_in, stopper_closed, emergency_stop;
};

/// Takes the levers of a side over from whoever has them, and hands them back after so many seconds (0: when
/// the program is told to stop). told hears what happens, one line at a time. Returns why this station does
/// not have them, and who has: within timeout seconds, or later when they are taken from it.
std::optional<std::string> hold_levers(station::Client& client, int side, const LeverWish& wish,
                                       double duration, double timeout,
                                       const std::function<void(const std::string&)>& told);

} // namespace windlass::console
