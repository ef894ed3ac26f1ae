#pragma once
// Key moments of an attempt: where a debriefing looks.

#include "recorder/debrief/attempt.hpp"

namespace windlass::debrief {

struct Moment {
    double time = 0; ///< s of exercise
    std::string what;
    int side = -1; ///< 0 port, 1 starboard, -1 neither
};

/// By time, at most 30: criteria that were not met, where they first went wrong; orders that were not carried
/// out; reports that were wrong; the largest tension and the fastest cable of each side worked; what the
/// anchor did; warnings and alarms, a fault with the time to the next lever moved by hand; bookmarks.
std::vector<Moment> moments_of(const Attempt& attempt);

} // namespace windlass::debrief
