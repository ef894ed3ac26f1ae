#pragma once
// Whether the parts of an exercise fit together: what no schema can say, since it concerns several fields.

#include "server/exercise/definition/exercise_def.hpp"

#include <string>
#include <vector>

namespace windlass::config {

/// One line for each fault, `/json/pointer: VALUE is not allowed: ...`; empty when all is well.
std::vector<std::string> physical_faults(const exercise::ExerciseDef& def);

} // namespace windlass::config
