#pragma once
// The exercise of a centre that is given none.

#include "server/exercise/definition/exercise_def.hpp"

#include <cstdint>

namespace windlass::sim {

/// In four of five seeds the cable hangs on a brake that grips wherever a hand leaves it, at 100 ticks a
/// second: what a server, its disk and its stations do is the same, and a second costs a third. In the fifth
/// it is a let-go, at 300.
exercise::ExerciseDef drawn_exercise(std::uint64_t seed);

/// Whether its lesson asks something at a freeze, as in one seed of three.
bool draws_questions(std::uint64_t seed);

/// The exercise with a lesson that holds it for questions to both seats, one at a time and together.
exercise::ExerciseDef with_questions(exercise::ExerciseDef def);

} // namespace windlass::sim
