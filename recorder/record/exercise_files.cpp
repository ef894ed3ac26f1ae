#include "recorder/record/exercise_files.hpp"

#include "server/config/config.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>

namespace windlass::recorder {

namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool is_of_name(const fs::path& file, const std::string& name) {
    const auto document = nlohmann::json::parse(content(file), nullptr, false);
    return document.is_object() && document.contains("name") && document["name"] == name;
}

} // namespace

std::vector<ExerciseFile> find_exercise(const fs::path& config_root, const std::string& name) {
    const fs::path folder = config_root / "exercises";
    if (!fs::is_directory(folder))
        throw std::runtime_error("there is no folder " + fs::absolute(folder).string() +
                                 "; name the one with ships, windlasses and exercises (--config-root)");
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".json" || !is_of_name(entry.path(), name)) continue;
        std::vector<ExerciseFile> files;
        for (const auto& file : config::exercise_files(entry.path(), config_root))
            files.push_back({file.lexically_relative(config_root).generic_string(), content(file)});
        return files;
    }
    throw std::runtime_error("no file in " + folder.string() + " has the name " + name);
}

} // namespace windlass::recorder
