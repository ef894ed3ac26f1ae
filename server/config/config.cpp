#include "server/config/config.hpp"

#include "common/json_schema.hpp"
#include "embedded/anchor_schema.hpp"
#include "embedded/chain_schema.hpp"
#include "embedded/exercise_schema.hpp"
#include "embedded/ground_schema.hpp"
#include "embedded/landmarks_schema.hpp"
#include "embedded/lesson_condition_schema.hpp"
#include "embedded/lesson_schema.hpp"
#include "embedded/ship_schema.hpp"
#include "embedded/windlass_schema.hpp"
#include "server/config/config_check.hpp"
#include "server/config/config_ground.hpp"
#include "server/config/config_json.hpp"
#include "words/words.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace windlass::config {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

struct Kind {
    std::string_view name, folder, schema;
};

const Kind& kind_of(ConfigKind kind) {
    static constexpr std::array<Kind, 7> kinds{{
        {"exercise", "exercises", embedded::exercise_schema},
        {"ship", "ships", embedded::ship_schema},
        {"windlass", "windlasses", embedded::windlass_schema},
        {"chain", "chains", embedded::chain_schema},
        {"anchor", "anchors", embedded::anchor_schema},
        {"ground", "grounds", embedded::ground_schema},
        {"landmarks", "landmarks", embedded::landmarks_schema},
    }};
    return kinds.at(std::size_t(kind));
}

std::string_view schema_text(const std::string& file_name) {
    for (const ConfigKind kind : {ConfigKind::ship, ConfigKind::windlass, ConfigKind::chain,
                                  ConfigKind::anchor, ConfigKind::ground, ConfigKind::landmarks})
        if (file_name == std::string(kind_of(kind).name) + ".schema.json") return kind_of(kind).schema;
    if (file_name == "lesson.schema.json") return embedded::lesson_schema;
    if (file_name == "lesson_condition.schema.json") return embedded::lesson_condition_schema;
    if (file_name == "words.json") return words::json_text();
    throw std::invalid_argument("no schema " + file_name);
}

const JsonSchema& schema_of(ConfigKind kind) {
    static const std::array<JsonSchema, 7> schemas{JsonSchema(embedded::exercise_schema, schema_text),
                                                   JsonSchema(embedded::ship_schema),
                                                   JsonSchema(embedded::windlass_schema),
                                                   JsonSchema(embedded::chain_schema),
                                                   JsonSchema(embedded::anchor_schema),
                                                   JsonSchema(embedded::ground_schema, schema_text),
                                                   JsonSchema(embedded::landmarks_schema, schema_text)};
    return schemas.at(std::size_t(kind));
}

/// Reads files and resolves what they refer to. Keeps the files being read, to see a circle.
class Loader {
public:
    /// confined: no reference may lead out of the config folder.
    explicit Loader(fs::path root, bool confined = false) : root_(std::move(root)), confined_(confined) {}

    /// An exercise that is in no file.
    Json take(Json document, const std::string& source) {
        schema_of(ConfigKind::exercise).check(document, source);
        resolve(ConfigKind::exercise, document, source, "");
        return document;
    }

    Json read(ConfigKind kind, const fs::path& file) {
        const fs::path canonical = fs::weakly_canonical(file);
        if (std::find(open_.begin(), open_.end(), canonical) != open_.end())
            throw ConfigError(file.string() + ": /from: refers back to itself");
        open_.push_back(canonical);
        if (std::find(files_.begin(), files_.end(), file) == files_.end()) files_.push_back(file);
        Json document = read_json(file);
        schema_of(kind).check(document, file.string());
        resolve(kind, document, file, "");
        open_.pop_back();
        return document;
    }

    /// Everything that was read, each file once.
    const std::vector<fs::path>& files() const { return files_; }

private:
    /// Replaces "from" in a part, and in the parts inside it, by what the file named there says.
    void resolve(ConfigKind kind, Json& part, const fs::path& file, const std::string& at) {
        // A part that names its own file takes the place of that part in the base; it is not mixed with it.
        std::vector<Json::json_pointer> other;
        if (kind == ConfigKind::exercise) {
            for (const auto& [inner, pointer] :
                 {std::pair(ConfigKind::ship, "/ship"), std::pair(ConfigKind::landmarks, "/landmarks"),
                  std::pair(ConfigKind::ground, "/environment/ground")}) {
                const Json::json_pointer place(pointer);
                if (!part.contains(place)) continue;
                if (part[place].contains("from")) other.push_back(place);
                resolve(inner, part[place], file, at + pointer);
            }
            for (std::size_t i = 0; part.contains("tackle") && i < part["tackle"].size(); ++i)
                resolve_tackle(part["tackle"][i], file, at + "/tackle/" + std::to_string(i));
        }
        if (part.contains("from")) {
            Json base = read(kind, referred(kind, part["from"].get<std::string>(), file, at + "/from"));
            for (const Json::json_pointer& place : other)
                if (base.contains(place)) base[place.parent_pointer()].erase(place.back());
            base.merge_patch(part);
            part = std::move(base);
        }
        for (const char* for_people : {"$schema", "from", "note"})
            part.erase(for_people);
    }

    void resolve_tackle(Json& tackle, const fs::path& file, const std::string& at) {
        for (const ConfigKind kind : {ConfigKind::windlass, ConfigKind::chain, ConfigKind::anchor})
            if (const std::string name(kind_of(kind).name); tackle.contains(name))
                resolve(kind, tackle[name], file, at + "/" + name);
    }

    /// The file that a reference means; one that does not exist is refused with the names that do.
    fs::path referred(ConfigKind kind, const std::string& name, const fs::path& file,
                      const std::string& at) const {
        const bool is_path = name.find('/') != std::string::npos || name.ends_with(".json");
        const fs::path folder = root_ / kind_of(kind).folder;
        fs::path target = is_path ? root_ / name : folder / (name + ".json");
        if (const fs::path path = fs::path(name).lexically_normal();
            confined_ && (path.is_absolute() || *path.begin() == ".."))
            throw ConfigError(file.string() + ": " + at + ": " + Json(name).dump() +
                              " is not allowed: a name, or a path inside the config folder");
        if (fs::exists(target)) return target;
        std::set<std::string> names;
        if (fs::is_directory(folder))
            for (const fs::directory_entry& entry : fs::directory_iterator(folder))
                if (entry.path().extension() == ".json") names.insert(entry.path().stem().string());
        std::string there;
        for (const std::string& one : names)
            there += (there.empty() ? "" : ", ") + one;
        throw ConfigError(file.string() + ": " + at + ": " + Json(name).dump() +
                          " is not allowed: there is no " + target.string() + "; in " + folder.string() +
                          " there are: " + (there.empty() ? "none" : there));
    }

    fs::path root_;
    bool confined_;
    std::vector<fs::path> open_, files_;
};

void refuse(const std::vector<std::string>& faults, const std::string& source) {
    std::string text;
    for (const std::string& fault : faults)
        text += (text.empty() ? "" : "\n") + source + ": " + fault;
    if (!text.empty()) throw ConfigError(text);
}

exercise::ExerciseDef checked_exercise(const Json& document, const std::string& source) {
    refuse(grid_faults(document), source);
    exercise::ExerciseDef def = exercise_from_json(document);
    refuse(physical_faults(def), source);
    return def;
}

} // namespace

std::string_view config_folder(ConfigKind kind) {
    return kind_of(kind).folder;
}

const Json& config_schema(ConfigKind kind) {
    return schema_of(kind).json();
}

Json load_document(ConfigKind kind, const fs::path& file, const fs::path& config_root) {
    return Loader(config_root).read(kind, file);
}

std::vector<fs::path> exercise_files(const fs::path& file, const fs::path& config_root) {
    Loader loader(config_root);
    loader.read(ConfigKind::exercise, file);
    return loader.files();
}

exercise::ExerciseDef parse_exercise(const std::string& text, const std::string& source,
                                     const fs::path& config_root) {
    return checked_exercise(Loader(config_root, true).take(parse_json(text, source), source), source);
}

exercise::ExerciseDef load_exercise(const fs::path& file) {
    return load_exercise(file, fs::absolute(file).lexically_normal().parent_path().parent_path());
}

exercise::ExerciseDef load_exercise(const fs::path& file, const fs::path& config_root) {
    return checked_exercise(load_document(ConfigKind::exercise, file, config_root), file.string());
}

void check_definition(const exercise::ExerciseDef& def) {
    schema_of(ConfigKind::exercise).check(to_json(def), def.name);
    refuse(physical_faults(def), def.name);
}

} // namespace windlass::config
