// Every exercise in which something fails, played by its script, which waits for what the seat is given of
// it: one that waits in vain is a failure that nobody notices.

#include "instructor_console/lesson_files.hpp"
#include "lesson/play.hpp"
#include "server/config/config.hpp"
#include "words/words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace windlass::console {

namespace {

namespace fs = std::filesystem;

const fs::path kShipped = WINDLASS_CONFIG_DIR;

std::vector<std::string> failures() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(kShipped / "exercises"))
        if (const auto name = entry.path().stem().string(); name.starts_with("failure_"))
            names.push_back(name);
    std::ranges::sort(names);
    return names;
}

class Failure : public testing::TestWithParam<std::string> {};

} // namespace

TEST_P(Failure, IsNoticedAtTheSeat) {
    const auto def = config::load_exercise(kShipped / "exercises" / (GetParam() + ".json"));
    std::vector<fs::path> scripts;
    for (const char* hand : {"", "_starboard"})
        if (const fs::path script = kShipped / "scripts" / (GetParam() + hand + ".json"); fs::exists(script))
            scripts.push_back(script);
    ASSERT_FALSE(scripts.empty());
    const lesson::Played played = lesson::play(def, load_scripts(scripts));
    std::string told;
    for (const lesson::Told& one : played.told)
        told += std::to_string(static_cast<int>(one.time)) + " s " + one.who + ": " + one.text + '\n';
    EXPECT_EQ(played.stuck, "") << told;
    if (testing::Test::HasFailure() || std::getenv("WINDLASS_TELL") != nullptr) std::puts(told.c_str());
}

INSTANTIATE_TEST_SUITE_P(Of, Failure, testing::ValuesIn(failures()),
                         [](const auto& info) { return info.param; });

TEST(Failures, EveryFaultIsInAnExerciseOrALesson) {
    std::set<std::string> used;
    for (const auto& entry : fs::directory_iterator(kShipped / "exercises")) {
        const exercise::ExerciseDef def = config::load_exercise(entry.path());
        for (const exercise::FaultOrder& fault : def.faults)
            used.emplace(words::row_of(fault.code).name);
        for (const words::Fault& row : words::kFaultCode) // a lesson's, which it gives itself
            if (def.lesson.find('"' + std::string(row.name) + '"') != std::string::npos)
                used.emplace(row.name);
    }
    for (const words::Fault& row : words::kFaultCode)
        EXPECT_TRUE(used.contains(std::string(row.name)))
            << row.name << " is in no exercise and in no lesson";
}

} // namespace windlass::console
