#pragma once
// A lesson's scripts played from a state that was kept, as of a recording: the same beginning, the same
// chances, the same weather, and other hands.

#include "server/run/course.hpp"
#include "trainee_client/script.hpp"

#include <functional>
#include <vector>

namespace windlass::lesson {

/// Plays the scripts on from there until the lesson is over, as play() does. others: what else went into the
/// exercise, by tick: an instructor's faults and weather. look: the picture before the first tick, and after
/// each. Throws std::runtime_error when the exercise has no lesson, or its state ceases to be finite.
void play_on(run::Course& course, const std::vector<trainee::Script>& scripts,
             const std::vector<run::OrderView>& others,
             const std::function<void(const exercise::Snapshot&)>& look);

} // namespace windlass::lesson
