#pragma once
// Lesson files: read, doubted, begun.

#include "instructor_console/history/next_lesson.hpp"
#include "server/assess/lesson.hpp"
#include "server/exercise/definition/exercise_def.hpp"
#include "trainee_client/script.hpp"

#include <filesystem>
#include <string_view>

namespace windlass::console {

struct LessonFile {
    std::filesystem::path file, root; ///< root: the config folder
    exercise::ExerciseDef def;
    assess::Lesson lesson;
};

/// Throws exercise::ConfigError: every mistake with file, place, value and remedy; also when it has no
/// lesson.
LessonFile read_lesson_file(const std::filesystem::path& file);

/// As a trainee's seat plays them: what looks at the truth is refused. Throws exercise::ConfigError.
std::vector<trainee::Script> load_scripts(const std::vector<std::filesystem::path>& files);

/// Those of one of its runs. The same.
std::vector<trainee::Script> scripts_of(const LessonFile& file, const assess::LessonRun& run);

/// Reads every script that the lesson names. Throws exercise::ConfigError.
void check_scripts(const LessonFile& file);

/// What is no mistake and may be one.
std::vector<std::string> doubts(const LessonFile& file);

/// Exercise files of a folder that have a lesson, by name.
std::vector<std::filesystem::path> lesson_files(const std::filesystem::path& folder);

/// A lesson of an accident, by its id (A1): for who has done the course, so that lists have it last.
bool of_an_accident(std::string_view lesson_id);

/// Lessons of a folder in the order in which they are to be done: by name, those made of an accident (A01,
/// ...) after the others. Throws exercise::ConfigError.
std::vector<history::Offered> offered_lessons(const std::filesystem::path& folder);

/// The text of a lesson to begin with. from: name or path of an exercise; empty: let_go_port_25m.
std::string new_lesson(const std::string& id, const std::filesystem::path& from);

} // namespace windlass::console
