// What would have kept lost points, as a station's pages show it.

#include "instructor_console/debrief_page.hpp"

#include "tests/lesson/recorded_lesson.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

#include <chrono>

namespace windlass::console {
namespace {

using test::Folder;
using test::kConfig;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kAgain = "http-equiv=\"refresh\"";

/// The page once it no longer looks again by itself; each that stood for it before.
std::string made(WhatIfPages& pages, const std::filesystem::path& recording, std::set<std::string>& before) {
    while (true) {
        std::string page = pages.page(recording);
        if (page.find(kAgain) == std::string::npos) return page;
        before.insert(std::move(page));
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

} // namespace

TEST(WhatIfPages, SayHowFarTheSearchIsAndThenShowBothCoursesAndScenes) {
    const Folder folder;
    const auto file = test::lesson_file("L15_motor_overhauled.json");
    const auto path = test::recorded(folder / "monday", file, file.lesson.errors.front());
    EXPECT_THAT(debrief_page(path, kConfig, "/debrief-1-what-if"),
                HasSubstr("<a href=\"/debrief-1-what-if\">What would have kept them</a>"));
    WhatIfPages pages(kConfig, false);
    std::set<std::string> before;
    const std::string page = made(pages, path, before);
    EXPECT_THAT(before, testing::Contains(HasSubstr("Searching for what would have kept ")));
    EXPECT_THAT(before, testing::Each(HasSubstr(
                            " min so far. It goes on with what the classes leave of the processor")))
        << "nobody thinks that it hangs";
    EXPECT_THAT(page, HasSubstr("the wheel hard on, which stood wide open"));
    EXPECT_THAT(page, HasSubstr("Do it again from <a href=\"/replay?recording=monday&amp;t="));
    EXPECT_THAT(page, HasSubstr("<h3>As it was, and as it would have been</h3>"));
    EXPECT_THAT(page, HasSubstr("<div class=\"pair\">\n<figure><p>As it was</p>"));
    EXPECT_THAT(page, HasSubstr("<figure><p>As it would have been</p>"));
    EXPECT_THAT(page, Not(HasSubstr(">What would have kept them</a>"))) << "that is what it says";
    before.clear();
    EXPECT_EQ(made(pages, path, before), page);
    EXPECT_TRUE(before.empty()) << "it is not searched for twice";
}

TEST(WhatIfPages, SayWhyThereIsNothingToSearchFor) {
    const Folder folder;
    std::filesystem::create_directory(folder / "empty");
    WhatIfPages pages(kConfig, false);
    std::set<std::string> before;
    EXPECT_THAT(made(pages, folder / "empty", before), HasSubstr("<p role=\"status\">"));
    EXPECT_THAT(made(pages, folder / "nowhere", before), HasSubstr("nowhere"));
}

TEST(SideBySidePage, LeavesOutWhatCannotBeReadOrWasNotRecordedAndSaysSo) {
    const Folder folder;
    const std::string page =
        side_by_side_page("Class", {{.who = "anna", .link = "", .recording = folder / "nowhere"},
                                    {.who = "ben", .link = "", .recording = {}}});
    EXPECT_THAT(page, HasSubstr("anna is left out: it cannot be read: "));
    EXPECT_THAT(page, HasSubstr("ben is left out: it was not recorded."));
    EXPECT_THAT(page, HasSubstr("There is no recording."));
}

} // namespace windlass::console
