#pragma once
// What a scene is made of, for pictures and charts: made once at each set-up from what the exercise computes
// with.

#include "server/perceive/perceive.hpp"

namespace windlass::perceive {

/// Ship, hull mesh and tackle. The mesh is that which chain and anchor touch, to single precision.
void describe_scene(const exercise::ExerciseDef& def, const SeatAids& aids, SceneDescription& to);

/// The ground as it is.
void describe_seabed(const exercise::ExerciseDef& def, SeabedDescription& to);

/// Soundings below the datum some 50 m apart, farther where there would be too many, over the ground's grid
/// and the waters round the ship's start.
void draw_chart(const exercise::ExerciseDef& def, Chart& to);

/// The sea's surface, from when it last became another.
void describe_sea(const exercise::Snapshot& from, SeaState& to);

} // namespace windlass::perceive
