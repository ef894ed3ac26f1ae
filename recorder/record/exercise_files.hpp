#pragma once
// The files that an exercise is made of, as attachments for its recording.

#include <filesystem>
#include <string>
#include <vector>

namespace windlass::recorder {

struct ExerciseFile {
    std::string name; ///< from the config folder: "exercises/let_go_port_25m.json"
    std::string content;
};

/// The file in config_root/exercises whose "name" is that, and every file it refers to. Throws
/// std::runtime_error when there is none, or one of them cannot be used.
std::vector<ExerciseFile> find_exercise(const std::filesystem::path& config_root, const std::string& name);

} // namespace windlass::recorder
