#pragma once
// What an attempt leaves to chance, drawn from its one seed: moment, severity and kind of a lesson's faults,
// within the bounds of its author. A pure function of seed and place, so that a replay draws the same.

#include "server/assess/fold.hpp"

namespace windlass::assess {

/// Takes the seed of this attempt, if its lesson leaves anything to chance and has none yet.
void draw(const Lesson& lesson, State& state, const exercise::ChanceDrawn& drawn);

/// What was drawn for an attempt whose state has that seed: drawn for a fresh one, it gives the same seed.
exercise::ChanceDrawn drawn_for(std::int64_t seed);

/// Whether a fault that has not come comes at this tick. To be asked at every tick.
bool comes(const Lesson& lesson, State& state, std::size_t fault, const exercise::Snapshot& seen,
           int tick_rate);

/// The fault as this attempt has it.
exercise::FaultOrder drawn_fault(const Lesson& lesson, const State& state, std::size_t fault);

} // namespace windlass::assess
