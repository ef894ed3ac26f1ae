#pragma once
// What came before an exercise that starts at anchor: the model itself is run, as fast as it can, until she
// is brought up, and her state then is the exercise's at tick 0. The same definition gives the same bits.
//
// She comes to anchor by her head as ship_start says (which should be into wind and stream), in the
// exercise's wind but 8 m/s at most, no sea, and a tide that stands: lets go at half a knot astern, lays the
// cable out as she falls back, tests the anchor with the engine astern and lies until she is brought up. Then
// levers come to stand as the file has them and the wind rises to the exercise's; the sea comes up in the
// exercise's first half minute. A ship that lies to both anchors is moored by moor.hpp.

#include "server/exercise/definition/exercise_def.hpp"

namespace windlass::exercise {

class Exercise;

/// The cable to which she lies at the start, the first of two where she is moored; null for none.
const GroundTackleDef* anchored_by(const ExerciseDef& def);

/// How she is before the prelude; of an exercise without one: as its definition says.
ExerciseDef before_prelude(const ExerciseDef& def);

/// Plays it. exercise: just set up from before_prelude(). Throws std::runtime_error, with the place in the
/// file, when she cannot be brought up. Takes a second of one core for some ten minutes of work.
void play_prelude(Exercise& exercise, const ExerciseDef& def);

/// The definition with the state that its prelude comes to, so that to set up the exercise takes no time any
/// more. As it is when it has none. For whoever reads files where no tick waits. Throws as play_prelude.
ExerciseDef with_prelude_played(ExerciseDef def);

} // namespace windlass::exercise
