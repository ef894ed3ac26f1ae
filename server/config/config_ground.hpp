#pragma once
// The ground of an exercise file: rows of heights and of letters for soils, as a chart shows them, north up.

#include "server/physics/sea/ground.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace windlass::config {

/// Lays the ground that a document's environment gives over what is read of the environment already.
void read_ground(const nlohmann::json& environment, physics::EnvironmentDef& def);

/// As a file has it; of a level bed, too.
nlohmann::json ground_to_json(const physics::EnvironmentDef& def);

/// What keeps the rows of an exercise's document from being a grid: JSON pointer, value and what is allowed.
std::vector<std::string> grid_faults(const nlohmann::json& document);

/// Neighbours that lie too steeply to each other.
std::vector<std::string> ground_faults(const physics::EnvironmentDef& def);

} // namespace windlass::config
