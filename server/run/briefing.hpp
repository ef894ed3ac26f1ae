#pragma once
// What the trainees of a lesson read before it begins, in pieces that events have room for, and when it is
// over.

#include "server/assess/lesson.hpp"
#include "server/assess/state.hpp"
#include "server/exercise/definition/exercise_def.hpp"

#include <array>
#include <string>
#include <vector>

namespace windlass::run {

/// The lesson's briefing, who gives the bridge's orders, and where shackles are counted if it speaks of any.
/// Each piece is one line of at most 255 bytes; they break at spaces, which are left out (a word that is
/// longer than a piece is cut).
std::vector<std::string> briefing_pieces(const assess::Lesson& lesson);
/// What one seat alone reads, in the same way: forecastle, bridge. None: the lesson says nothing to it alone.
std::array<std::vector<std::string>, 2> own_briefing_pieces(const assess::Lesson& lesson);

/// Has the exercise's lesson played for practice, with its hints. Throws std::invalid_argument when it has no
/// lesson.
void put_to_practice(exercise::ExerciseDef& def);

/// That the lesson is over, and why: no mark, and no event that only the instructor knows of.
std::string lesson_over_text(const assess::Lesson& lesson, const assess::State& state);

} // namespace windlass::run
