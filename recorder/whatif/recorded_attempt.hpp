#pragma once
// The attempt at a lesson that a recording has.

#include "lesson/whatif/attempt.hpp"
#include "lesson/whatif/trials.hpp"
#include "recorder/remedies.hpp"
#include "recorder/resimulate/runs.hpp"

namespace windlass::recorder {

/// An attempt (attempts_of()) from its first checkpoint on. Throws Gap where an order is missing,
/// mcap::Damage where a checkpoint cannot be read.
whatif::Attempt recorded_attempt(recording::Recording& recording, std::span<const Run> runs);

/// The scripts of the lesson's model run, as the lesson names them; empty: no lesson, or none named. Throws
/// exercise::CheckpointError.
std::vector<std::string> model_scripts(const whatif::Attempt& attempt);

/// Those scripts, from the folder of configuration; none where one is not there, which is told.
std::vector<trainee::Script> model_of(const whatif::Attempt& attempt, const std::filesystem::path& config,
                                      const Tell& tell);

/// An attempt of a recording, 1 the first, 0 the last. Throws std::runtime_error where there is no such one,
/// and as above.
whatif::Attempt recorded_attempt(recording::Recording& recording, std::size_t run);

} // namespace windlass::recorder
