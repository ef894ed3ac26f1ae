#pragma once
// An exercise to JSON and back: the same fields as the files in config/, nothing left out.

#include "server/exercise/definition/exercise_def.hpp"

#include <nlohmann/json_fwd.hpp>

namespace windlass::config {

/// Every value of the exercise as an exercise file that refers to no other.
nlohmann::json to_json(const exercise::ExerciseDef& def);

/// Built-in defaults with what the document gives laid over them. The document must fit the schema and have
/// its references resolved (see config.hpp). A chain's properties follow from diameter and grade unless
/// given.
exercise::ExerciseDef exercise_from_json(const nlohmann::json& document);

} // namespace windlass::config
