#pragma once
// Exercise files: JSON over built-in defaults, each kind held against its schema in config/schema.
//
// Where a part says `"from": "NAME"`, the file config/<kind>/NAME.json (or the path, from the config folder)
// is read first and then changed by what stands beside it. Files give SI units, except that a name ending in
// _deg is in degrees.

#include "common/json_file.hpp"
#include "server/exercise/definition/exercise_def.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace windlass::config {

/// Reads an exercise and every file that it refers to. The config folder, to which references are relative,
/// is two levels above the file (config/exercises/x.json) unless given. Throws ConfigError naming every fault
/// found: file, JSON pointer, value and what is allowed.
exercise::ExerciseDef load_exercise(const std::filesystem::path& file);
exercise::ExerciseDef load_exercise(const std::filesystem::path& file,
                                    const std::filesystem::path& config_root);

/// Holds a definition that came from elsewhere against what a file may say. Throws ConfigError naming every
/// fault found: JSON pointer, value and what is allowed.
void check_definition(const exercise::ExerciseDef& def);
/// An exercise given as text: its references lead nowhere but into the config folder. source stands for the
/// file in what is told. Throws as above.
exercise::ExerciseDef parse_exercise(const std::string& text, const std::string& source,
                                     const std::filesystem::path& config_root);

/// What a file may hold.
enum class ConfigKind { exercise, ship, windlass, chain, anchor, ground, landmarks };

/// Folder of the kind's files within the config folder, e.g. "ships".
std::string_view config_folder(ConfigKind kind);

/// Reads one file of a kind, holds it against its schema and resolves its references. Throws as above.
nlohmann::json load_document(ConfigKind kind, const std::filesystem::path& file,
                             const std::filesystem::path& config_root);

/// The exercise's file and every file that it refers to, for whoever keeps them with a record of what was
/// run. Throws as above.
std::vector<std::filesystem::path> exercise_files(const std::filesystem::path& file,
                                                  const std::filesystem::path& config_root);

/// The kind's JSON Schema, as built into the program. Lives as long as the program.
const nlohmann::json& config_schema(ConfigKind kind);

} // namespace windlass::config
