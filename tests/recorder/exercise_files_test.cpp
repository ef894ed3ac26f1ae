// The files that go with a recording: found by the name that an exercise publishes, whatever its file is
// called.

#include "recorder/record/exercise_files.hpp"
#include "server/config/config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace windlass::recorder {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path kConfig = WINDLASS_CONFIG_DIR;

} // namespace

TEST(RecordedFiles, OfEveryShippedExerciseAndLessonAreFoundByItsPublishedName) {
    for (const auto& entry : fs::directory_iterator(kConfig / "exercises")) {
        const std::string name = config::load_exercise(entry.path()).name;
        SCOPED_TRACE(name);
        const auto files = find_exercise(kConfig, name);
        const auto has = [&](const std::string& wanted) {
            return std::ranges::any_of(files, [&](const ExerciseFile& file) {
                return file.name == wanted && !file.content.empty();
            });
        };
        EXPECT_TRUE(has("exercises/" + entry.path().filename().string()));
        EXPECT_TRUE(std::ranges::any_of(
            files, [](const ExerciseFile& file) { return file.name.starts_with("windlasses/"); }));
    }
}

TEST(RecordedFiles, AreAskedForByTheFolderThatIsNotThereAndNotByTheName) {
    try {
        find_exercise(kConfig / "nowhere", "L01-let-go-25m");
        FAIL() << "files of a folder that is not there";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("nowhere/exercises"));
        EXPECT_THAT(error.what(), HasSubstr("--config-root"));
    }
}

} // namespace windlass::recorder
