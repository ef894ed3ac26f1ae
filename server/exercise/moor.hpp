#pragma once
// The prelude of an exercise that starts moored to two anchors: a standing moor, and the swings since then.
//
// She is moved as it is wanted (as another simulator moves her); anchors, cables and windlasses are the
// model's. The first tackle's anchor is let go ahead, in line with the heading on which she moors, the second
// one's astern, the first hove in as the second is veered; each is pulled at until it bears three times its
// weight. Then she is turned about her bow by ship_start's `turned`, is herself again, and lies.

#include "server/exercise/definition/exercise_def.hpp"

namespace windlass::exercise {

class Exercise;

/// Whether she starts at two anchors.
bool moored(const ExerciseDef& def);

/// A ship that starts moored, over the place of the first anchor, both hanging at the waterline.
void begin_moor(ExerciseDef& def);

/// exercise: just set up from there. Throws std::runtime_error where she cannot be moored.
void play_moor(Exercise& exercise, const ExerciseDef& def);

} // namespace windlass::exercise
