#include "instructor_console/exercise_files.hpp"

#include "instructor_console/lesson_files.hpp"
#include "recorder/recording/sha256.hpp"
#include "server/assess/names.hpp"
#include "server/config/config.hpp"
#include "server/config/config_json.hpp"
#include "words/words.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace windlass::console {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t kLongest = 1 << 20; // bytes of an exercise: far above any that is written by hand

std::string text_of(const json& request, const char* field) {
    const auto found = request.find(field);
    return found != request.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string source_of(const std::string& name) {
    return name.empty() ? "this exercise" : name + ".json";
}

/// "L01.json: /lesson/id: ..." without the file's name, its pointer apart.
Mistake mistake_of(std::string line, const std::string& source) {
    if (line.starts_with(source + ": ")) line.erase(0, source.size() + 2);
    const auto colon = line.find(": ");
    if (!line.starts_with('/') || colon == std::string::npos) return {.at = "", .text = std::move(line)};
    std::string at = line.substr(0, colon);
    return {.at = at == "/" ? "" : std::move(at), .text = line.substr(colon + 2)};
}

std::vector<Mistake> mistakes_of(const std::exception& error, const std::string& source) {
    std::vector<Mistake> all;
    std::istringstream lines(error.what());
    for (std::string line; std::getline(lines, line);)
        all.push_back(mistake_of(line, source));
    return all;
}

/// Whether a path of a script leads into the config folder and nowhere else.
bool stays_inside(const fs::path& path) {
    const fs::path plain = path.lexically_normal();
    return !plain.empty() && !plain.is_absolute() && *plain.begin() != "..";
}

/// Scripts that a page named are read only where an exercise's scripts belong.
void refuse_scripts_elsewhere(const assess::Lesson& lesson, std::vector<Mistake>& to) {
    const auto look = [&](const assess::LessonRun& run, const std::string& at) {
        for (const std::string& script : run.scripts)
            if (!stays_inside(script))
                to.push_back({at, json(script).dump() + " is not allowed: a path inside the config folder"});
    };
    look(lesson.model_run, "/lesson/model_run");
    for (std::size_t k = 0; k < lesson.errors.size(); ++k)
        look(lesson.errors[k], fmt::format("/lesson/errors/{}/script", k));
}

std::string from_of(const std::string& text, const std::string& source) {
    const json document = parse_json(text, source);
    return document.is_object() ? text_of(document, "from") : std::string();
}

std::string text_in(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in) throw std::runtime_error(file.string() + ": cannot be read");
    return text;
}

/// An exercise and its lesson, where it has one. Throws ConfigError.
LessonFile parsed(const std::string& name, const std::string& text, const fs::path& root) {
    LessonFile file{.file = source_of(name),
                    .root = root,
                    .def = config::parse_exercise(text, source_of(name), root),
                    .lesson = {}};
    std::vector<int> sides;
    for (const exercise::GroundTackleDef& tackle : file.def.tackle)
        sides.push_back(static_cast<int>(tackle.side));
    if (!file.def.lesson.empty()) file.lesson = assess::read_lesson(file.def.lesson, sides);
    return file;
}

} // namespace

bool is_file_name(const std::string& name) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    return !name.empty() && name.size() <= 64 && plain(name.front()) && !name.ends_with(".json") &&
           std::ranges::all_of(name, [&](char c) { return plain(c) || c == '.' || c == '-' || c == '_'; });
}

ExerciseFiles::ExerciseFiles(fs::path folder)
    : folder_(std::move(folder)),
      root_(fs::absolute(folder_ / "any").lexically_normal().parent_path().parent_path()) {}

json ExerciseFiles::answer(const json& request) {
    const std::string what = text_of(request, "what"), name = text_of(request, "name"),
                      text = text_of(request, "text");
    json answer = what == "list"    ? list()
                  : what == "read"  ? read(name)
                  : what == "check" ? check(name, text)
                  : what == "save"  ? save(name, text, text_of(request, "over"))
                                    : throw std::runtime_error("what: list, read, check or save is allowed");
    answer["what"] = what;
    answer["name"] = name;
    return answer;
}

fs::path ExerciseFiles::file_of(const std::string& name) const {
    if (!is_file_name(name))
        throw std::runtime_error(
            "this name is not allowed: 1 to 64 letters, digits, dots, dashes and underscores, "
            "a letter or digit first, without .json");
    fs::path file = folder_ / (name + ".json");
    if (fs::is_symlink(fs::symlink_status(file)) &&
        fs::weakly_canonical(file).parent_path() != fs::weakly_canonical(folder_))
        throw std::runtime_error(file.string() + ": leads out of the folder");
    return file;
}

json ExerciseFiles::list() const {
    if (!fs::is_directory(folder_))
        throw std::runtime_error(folder_.string() +
                                 ": is no folder; name the one with the exercise files (--exercises)");
    json files = json::array();
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
        if (entry.path().extension() == ".json" && is_file_name(entry.path().stem().string()))
            paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::map<std::string, std::string> taught; // accidents, by the exercise that their lesson begins with
    for (const fs::path& path : paths) {
        json file{{"name", path.stem().string()},
                  {"title", ""},
                  {"lesson", nullptr},
                  {"taught_as", nullptr},
                  {"bridge_judged", false}};
        try {
            const json document = read_json(path);
            file["title"] = text_of(document, "title");
            if (document.is_object() && document.contains("lesson")) {
                const std::string lesson = text_of(document.at("lesson"), "id");
                file["lesson"] = lesson;
                file["bridge_judged"] = text_of(document.at("lesson"), "bridge") == "manned";
                if (of_an_accident(lesson)) taught.emplace(text_of(document, "from"), lesson);
            }
        } catch (const std::exception& error) {
            file["title"] = error.what(); // it can be opened by hand only
        }
        files.push_back(std::move(file));
    }
    for (json& file : files)
        if (const auto lesson = taught.find(file.at("name").get<std::string>()); lesson != taught.end())
            file["taught_as"] = lesson->second;
    std::stable_partition(files.begin(), files.end(), [](const json& file) {
        return !file["lesson"].is_string() || !of_an_accident(file["lesson"].get<std::string>());
    });
    return {{"files", std::move(files)}, {"events", words::kEventNames}, {"faults", words::kFaultNames}};
}

json ExerciseFiles::read(const std::string& name) const {
    const fs::path file = file_of(name);
    if (!fs::is_regular_file(file)) throw std::runtime_error(file.string() + ": there is no such exercise");
    std::string text = text_in(file);
    parse_json(text, file.string()); // a page cannot show what is no JSON
    json answer = check(name, text);
    answer["stamp"] = recording::sha256(text);
    answer["text"] = std::move(text);
    return answer;
}

json ExerciseFiles::check(const std::string& name, const std::string& text) const {
    json list = json::array();
    for (const Mistake& each : mistakes(name, text))
        list.push_back({{"at", each.at}, {"text", each.text}});
    const bool sound = list.empty();
    return {{"mistakes", std::move(list)},
            {"doubts", sound ? doubts(name, text) : std::vector<std::string>()},
            {"inherited", inherited(text)}};
}

std::vector<Mistake> ExerciseFiles::mistakes(const std::string& name, const std::string& text) const {
    const std::string source = source_of(name);
    if (!name.empty()) file_of(name); // that it is one
    if (text.size() > kLongest) return {{"", fmt::format("is longer than {} bytes", kLongest)}};
    std::vector<Mistake> all;
    try {
        const LessonFile file = parsed(name, text, root_);
        if (begins_with_itself(name, from_of(text, source)))
            all.push_back({"/from", "refers back to this very file; name another one"});
        refuse_scripts_elsewhere(file.lesson, all);
        if (all.empty()) check_scripts(file);
    } catch (const ConfigError& error) {
        all = mistakes_of(error, source);
    }
    return all;
}

/// Whether the exercise that it takes over leads back to the file that it is to be.
bool ExerciseFiles::begins_with_itself(const std::string& name, const std::string& from) const {
    if (name.empty() || from.empty()) return false;
    const bool path = from.find('/') != std::string::npos || from.ends_with(".json");
    const fs::path own = fs::weakly_canonical(file_of(name));
    return std::ranges::any_of(
        config::exercise_files(path ? root_ / from : folder_ / (from + ".json"), root_),
        [&](const fs::path& each) { return fs::weakly_canonical(each) == own; });
}

std::vector<std::string> ExerciseFiles::doubts(const std::string& name, const std::string& text) const {
    const LessonFile file = parsed(name, text, root_);
    return file.def.lesson.empty() ? std::vector<std::string>() : console::doubts(file);
}

/// What the fields have that the text leaves out: those of the exercise that it takes over, or the defaults.
json ExerciseFiles::inherited(const std::string& text) const {
    try {
        const std::string from = from_of(text, "");
        const json base = from.empty() ? json::object() : json{{"from", from}};
        return config::to_json(config::parse_exercise(base.dump(), "", root_));
    } catch (const std::exception&) {
        return nullptr; // told as a mistake of /from
    }
}

json ExerciseFiles::save(const std::string& name, const std::string& text, const std::string& over) {
    const fs::path file = file_of(name);
    json answer = check(name, text);
    answer["saved"] = false;
    if (!answer.at("mistakes").empty()) return answer;
    const std::scoped_lock lock{saving_};
    const bool there = fs::exists(fs::symlink_status(file));
    if (there && over.empty())
        throw std::runtime_error(file.string() + ": is there already; take another name, or save over it");
    if (!over.empty() && (!there || recording::sha256(text_in(file)) != over))
        throw std::runtime_error(
            file.string() +
            ": was changed or removed by somebody else since it was opened; take another name");
    const std::string whole = text.ends_with('\n') ? text : text + '\n';
    write(file, whole, there);
    answer["saved"] = true;
    answer["stamp"] = recording::sha256(whole);
    return answer;
}

/// Whole or not at all: beside it first, then in its place.
void ExerciseFiles::write(const fs::path& file, const std::string& text, bool replace) const {
    const fs::path beside = folder_ / fmt::format(".{}.{}", file.filename().string(), getpid());
    const auto failed = [&] {
        const std::string why = std::strerror(errno);
        unlink(beside.c_str());
        throw std::runtime_error(file.string() + ": cannot be written: " + why);
    };
    const int opened = open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (opened < 0) failed();
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t put = ::write(opened, text.data() + done, text.size() - done);
        if (put < 0) break;
        done += static_cast<std::size_t>(put);
    }
    const bool kept = done == text.size() && fsync(opened) == 0;
    if (close(opened) != 0 || !kept) failed();
    // A new name never takes the place of a file that came between.
    if (replace ? rename(beside.c_str(), file.c_str()) != 0 : link(beside.c_str(), file.c_str()) != 0)
        failed();
    if (!replace) unlink(beside.c_str());
}

} // namespace windlass::console
