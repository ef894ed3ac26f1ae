#pragma once
// The windlasses of config/, each with the chain and anchor that it is made for.

#include "server/physics/tackle/ground_tackle.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace windlass::lab {

/// A windlass with its cable and anchor, by the name of its file.
struct Machine {
    std::string name;
    physics::TackleSetup setup;
};

/// Every windlass of the config folder whose size of chain its name tells (..._78mm), by name. Throws
/// exercise::ConfigError where a file is wrong or missing.
std::vector<Machine> shipped_machines(const std::filesystem::path& config_root);

} // namespace windlass::lab
