#pragma once
// The lesson's model hands beside a trainee who practises: as the recorder's ghost, and tick by tick.

#include "server/run/model_hands.hpp"

#include <filesystem>

namespace windlass::lesson {

/// The model run of that exercise's lesson, with what the attempt drew. config: folder with its scripts.
/// Throws std::exception when there is no model run, when a script of it is not there or looks at more than a
/// seat sees, or when the exercise cannot be set up.
std::unique_ptr<run::ModelHands> model_beside(const run::Beginning& beginning,
                                              const std::filesystem::path& config);

} // namespace windlass::lesson
