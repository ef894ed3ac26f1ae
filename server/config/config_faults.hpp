#pragma once
// The faults of an exercise file: armed or there from the start, each with what makes it come.

#include "server/exercise/definition/exercise_def.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace windlass::config {

/// Those of a document that fits the schema; none where it has none.
std::vector<exercise::FaultOrder> faults_from_json(const nlohmann::json& document);

/// As a file has them.
nlohmann::json faults_to_json(const std::vector<exercise::FaultOrder>& faults);

/// What the schema cannot see: JSON pointer, value and what is allowed.
std::vector<std::string> order_faults(const exercise::ExerciseDef& def);

} // namespace windlass::config
