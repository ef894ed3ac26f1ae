// A ghost: the model run of a lesson laid behind an attempt, played again from where the attempt began.

#include "instructor_console/debrief_page.hpp"
#include "recorder/command.hpp"
#include "recorder/debrief/compare.hpp"
#include "recorder/debrief/curves.hpp"
#include "recorder/debrief/page.hpp"
#include "recorder/debrief/read_attempt.hpp"
#include "recorder/ghost.hpp"

#include "tests/lesson/recorded_lesson.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

#include <map>

namespace windlass::recorder {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using testing::HasSubstr;
using testing::Not;

using test::kConfig;
using test::lesson_file;
using test::recorded;

debrief::Attempt read(const fs::path& path) {
    recording::Recording recording({path});
    return debrief::read_attempt(recording);
}

debrief::Attempt ghost_of(const fs::path& path, const debrief::Attempt& attempt) {
    recording::Recording recording({path});
    return model_ghost(recording, attempt, kConfig);
}

/// The largest difference of a ghost's curve from the attempt's own, over samples that both have.
double apart(const debrief::Series& own, const debrief::Series& ghost, std::size_t& held) {
    std::map<double, double> values;
    for (const debrief::Sample& sample : own.samples())
        values[sample.time] = sample.value;
    double most = 0;
    for (const debrief::Sample& sample : ghost.samples())
        if (const auto found = values.find(sample.time); found != values.end()) {
            most = std::max(most, std::abs(found->second - sample.value));
            ++held;
        }
    return most;
}

/// Runs the command, and says what it came to.
int run_debrief(const std::string& arguments, std::string& told) {
    CLI::App app;
    Command chosen;
    add_debrief(app, chosen);
    app.parse("debrief " + arguments + " --config " + kConfig.string());
    testing::internal::CaptureStderr();
    const int code = [&] {
        try {
            return chosen();
        } catch (const std::runtime_error& error) {
            tell(error.what());
            return static_cast<int>(kFailed);
        }
    }();
    told = testing::internal::GetCapturedStderr();
    return code;
}

} // namespace

class GhostOfTheModelRun : public testing::TestWithParam<const char*> {};

// Of a recording that is the model run itself: the ghost lies on it, bit for bit, and has its marks.
TEST_P(GhostOfTheModelRun, LiesOnIt) {
    const Folder folder;
    const auto file = lesson_file(GetParam());
    const fs::path path = recorded(folder / "model", file, file.lesson.model_run);
    const debrief::Attempt attempt = read(path), ghost = ghost_of(path, attempt);
    std::size_t held = 0;
    for (std::size_t side = 0; side < 2; ++side) {
        EXPECT_EQ(ghost.sides[side].worked, attempt.sides[side].worked);
        for (std::size_t k = 0; k < debrief::windlass_curves().size(); ++k)
            EXPECT_EQ(apart(attempt.sides[side].curves[k], ghost.sides[side].curves[k], held), 0)
                << debrief::windlass_curves()[k].name;
    }
    EXPECT_EQ(apart(attempt.ship[0], ghost.ship[0], held), 0);
    EXPECT_GT(held, 1000U) << "samples were held against each other";
    ASSERT_TRUE(ghost.assessment && attempt.assessment);
    EXPECT_EQ(ghost.assessment->assessment_hash(), attempt.assessment->assessment_hash());
    EXPECT_EQ(debrief::align(attempt, ghost).shift, 0);
}

INSTANTIATE_TEST_SUITE_P(Lessons, GhostOfTheModelRun,
                         testing::Values("L15_motor_overhauled.json", "L06_dredging.json",
                                         "L05_standing_moor.json", "L27_the_conn.json"));

TEST(Ghost, IsDrawnPalerWithDashesAndWordsAndTheSameBytesAgain) {
    const Folder folder;
    const auto file = lesson_file("L15_motor_overhauled.json");
    const fs::path path = recorded(folder / "monday", file, file.lesson.errors.front());
    const debrief::Attempt attempt = read(path), ghost = ghost_of(path, attempt);
    const debrief::PageOptions options{.links = {},
                                       .ghost = debrief::Ghost{&ghost, "as the model hands did it"}};
    const std::string page = debrief::page_of(attempt, options);
    EXPECT_THAT(page, HasSubstr("the lesson as the model hands did it."));
    EXPECT_THAT(page, HasSubstr(">the same, as the model hands did it</text>"));
    EXPECT_THAT(page, HasSubstr("stroke-dasharray=\"6 4\" class=\"ghost\""));
    EXPECT_THAT(page, HasSubstr("id=\"ghost-off\"")) << "it can be put out of sight";
    EXPECT_THAT(debrief::page_of(attempt, {}), Not(HasSubstr("class=\"ghost\"")));
    EXPECT_THAT(console::debrief_page(path, kConfig, ""),
                HasSubstr(">the same, as the model hands did it</text>"))
        << "by the desk's button";
    const debrief::Attempt twice = ghost_of(path, attempt);
    EXPECT_EQ(debrief::page_of(attempt,
                               {.links = {}, .ghost = debrief::Ghost{&twice, "as the model hands did it"}}),
              page);
}

TEST(Ghost, OfAnotherLessonIsRefusedAndSaysOfWhich) {
    const Folder folder;
    const auto l15 = lesson_file("L15_motor_overhauled.json"), l18 = lesson_file("L18_stuck.json");
    const fs::path ours = recorded(folder / "ours", l15, l15.lesson.errors.front());
    const fs::path theirs = recorded(folder / "theirs", l18, l18.lesson.model_run);
    const fs::path again = recorded(folder / "again", l15, l15.lesson.model_run);
    auto changed = l15;
    changed.def.weather.wind_speed += 1;
    const fs::path other_version = recorded(folder / "changed", changed, changed.lesson.model_run);
    const std::string page = (folder / "page.html").string(), output = " -o " + page + " --ghost ";
    std::string told;
    EXPECT_EQ(run_debrief(ours.string() + output + again.string(), told), kOk) << told;
    EXPECT_THAT(test::content(page), HasSubstr("the same, as in again"));
    EXPECT_EQ(run_debrief(ours.string() + output + theirs.string(), told), kFailed);
    EXPECT_THAT(told, HasSubstr("theirs: is of " + l18.def.name));
    EXPECT_THAT(told, HasSubstr("only the same lesson can be laid behind it"));
    EXPECT_EQ(run_debrief(ours.string() + output + other_version.string(), told), kFailed);
    EXPECT_THAT(told, HasSubstr("is of another version of " + l15.def.name));
}

TEST(Ghost, WithoutItsScriptThePageIsMadeAndSaysWhyThereIsNone) {
    const Folder folder;
    const auto file = lesson_file("L15_motor_overhauled.json");
    const fs::path path = recorded(folder / "monday", file, file.lesson.errors.front());
    recording::Recording recording({path});
    const debrief::Attempt attempt = debrief::read_attempt(recording);
    EXPECT_THAT([&] { model_ghost(recording, attempt, folder / "nowhere"); },
                testing::ThrowsMessage<std::runtime_error>(HasSubstr("is not there; --config says where")));
    EXPECT_THAT(console::debrief_page(path, folder / "nowhere", ""),
                HasSubstr("<p>The model run is not laid behind the curves: "));
}

} // namespace windlass::recorder
