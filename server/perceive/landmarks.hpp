#pragma once
// What stands round the anchorage, as everybody sees it and every chart has it.

#include "idl/types.hpp"
#include "server/exercise/definition/exercise_def.hpp"

namespace windlass::perceive {

/// Fills in every field from the definition's landmarks, which config has checked; of an open sea all lists
/// are empty.
void describe_landmarks(const exercise::ExerciseDef& def, Landmarks& to);

} // namespace windlass::perceive
