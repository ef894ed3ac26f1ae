#pragma once
// The ends of what a lesson leaves to chance: what no number of draws is sure to come to.

#include "server/exercise/definition/exercise_def.hpp"

#include <string>
#include <vector>

namespace windlass::lesson {

/// An exercise whose lesson leaves nothing to chance: its faults stand at an end of their author's bounds.
struct AtAnEnd {
    std::string which; ///< "soonest, weakest, kind 1 of 2"; only what is drawn
    exercise::ExerciseDef def;
};

/// Soonest and latest, with each of these weakest and strongest, each kind by itself. Empty where a lesson
/// leaves nothing to chance. The lesson is taken to be sound (assess::read_lesson).
std::vector<AtAnEnd> ends_of_chance(const exercise::ExerciseDef& def);

} // namespace windlass::lesson
