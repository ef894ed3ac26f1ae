#pragma once
// An attempt at a lesson as it went: whole states now and then, and every order.

#include "server/run/session.hpp"

#include <functional>

namespace windlass::whatif {

/// One run of an exercise with a lesson, from its first checkpoint on.
struct Attempt {
    std::vector<run::CheckpointView> checkpoints; ///< by tick
    std::vector<run::OrderView> orders;           ///< by number, every one since the first checkpoint
    std::uint64_t last_tick = 0;                  ///< of the attempt
    /// Throws std::exception when a definition is none that a file could give: of states from anywhere.
    std::function<void(const exercise::ExerciseDef&)> check;
};

/// Puts down what the session tells of itself after a tick, before its news are cleared.
void put_down(Attempt& attempt, const run::Session& session);

} // namespace windlass::whatif
