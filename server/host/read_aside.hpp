#pragma once
// Files are read on threads of their own: a disk or a network that hangs holds up no exercise.

#include "server/run/reading.hpp"

#include <functional>

namespace windlass::host {

/// What read() returns, its prelude played (exercise/prelude.hpp), or what it throws; returns at once.
/// Whoever does not wait for it leaves it behind: a read that never ends lasts as long as the program, and of
/// these there are a few at most. When as many have not come back, the next one is an error.
run::Reading read_aside(std::function<exercise::ExerciseDef()> read);

} // namespace windlass::host
