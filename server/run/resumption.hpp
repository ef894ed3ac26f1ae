#pragma once
// How an exercise begins that was kept when its server was lost.

#include "server/exercise/picture/snapshot.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace windlass::run {

/// Which files of what is kept of an exercise are of one course, by their numbers.
struct KeptCourse {
    std::uint64_t first = 0;   ///< 0: nothing is kept of it yet
    std::uint64_t settled = 0; ///< from which on it counts how often the server is lost
};

/// What has come of the kept state, for the session that begins.
struct Resumption {
    std::vector<std::uint8_t> checkpoint; ///< to go on from; empty: the exercise begins from its definition
    /// Of one that is taken up: ready, running or paused.
    exercise::RunState state = exercise::RunState::paused;
    double time_scale = 1; ///< of one that is taken up
    /// Of one that begins from its definition: why it is not taken up, told in an event. Empty: nothing was
    /// kept.
    std::string refused;
    /// The state that was kept last ended the server again and again and is not gone on from: told in an
    /// alarm, and nothing runs until somebody starts it. Empty: it did not.
    std::string set_back;
    KeptCourse course{}; ///< of one that is taken up
};

/// "M:SS", for people.
std::string clock_text(double seconds);

} // namespace windlass::run
