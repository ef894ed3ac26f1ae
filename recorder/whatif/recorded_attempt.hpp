#pragma once
// The attempt at a lesson that a recording has.

#include "lesson/whatif/attempt.hpp"
#include "recorder/resimulate/runs.hpp"

namespace windlass::recorder {

/// A run from its first checkpoint on. Throws Gap where an order is missing, mcap::Damage where a checkpoint
/// cannot be read.
whatif::Attempt recorded_attempt(recording::Recording& recording, const Run& run);

/// The scripts of the lesson's model run, as the lesson names them; empty: no lesson, or none named. Throws
/// exercise::CheckpointError.
std::vector<std::string> model_scripts(const whatif::Attempt& attempt);

} // namespace windlass::recorder
