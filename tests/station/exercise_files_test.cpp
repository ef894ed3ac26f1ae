// What a page may do to exercise files: every mistake at its field, nothing outside the folder, nothing lost.

#include "instructor_console/exercise_files.hpp"

#include "instructor_console/lesson_files.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <unistd.h>

namespace windlass::console {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

std::string text_in(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A config folder of its own, with what the shipped lesson L01 needs.
class ExerciseFilesTest : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(root / "exercises");
        for (const char* part :
             {"ships", "windlasses", "chains", "anchors", "grounds", "landmarks", "scripts"})
            fs::copy(shipped / part, root / part, fs::copy_options::recursive);
        for (const char* name : {"L01_let_go_25m.json", "let_go_port_25m.json"})
            fs::copy(shipped / "exercises" / name, folder / name);
        std::ofstream(root / "secret.json") << R"({"title": "not for a page"})";
    }
    void TearDown() override { fs::remove_all(root); }

    /// L01 with one value in another's place; null takes it away.
    std::string l01(const char* at, const json& value) const {
        json document = json::parse(text_in(folder / "L01_let_go_25m.json"));
        const json::json_pointer place(at);
        if (value.is_null())
            document.at(place.parent_pointer()).erase(place.back());
        else
            document[place] = value;
        return document.dump();
    }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder))
            found.push_back(entry.path().filename().string());
        std::ranges::sort(found);
        return found;
    }

    const fs::path shipped = WINDLASS_CONFIG_DIR;
    const fs::path root = fs::temp_directory_path() / ("windlass_exercise_files_" + std::to_string(getpid()));
    const fs::path folder = root / "exercises";
    ExerciseFiles files{folder};
};

TEST_F(ExerciseFilesTest, ListHasAccidentsBehindTheCourse) {
    fs::copy(shipped / "exercises" / "A01_stellar_voyager.json", folder / "A01_stellar_voyager.json");
    const json list = files.list();
    ASSERT_EQ(list.at("files").size(), 3U);
    EXPECT_EQ(list.at("files")[0].at("lesson"), "L01");
    EXPECT_EQ(list.at("files")[2].at("lesson"), "A1");
}

// A class is offered each accident once: as its lesson.
TEST_F(ExerciseFilesTest, ExerciseOfWhichAnAccidentsLessonIsMadeSaysWhich) {
    for (const char* name : {"A01_stellar_voyager.json", "accident_stellar_voyager.json"})
        fs::copy(shipped / "exercises" / name, folder / name);
    const json list = files.list();
    std::map<std::string, json> taught_as;
    for (const json& file : list.at("files"))
        taught_as.emplace(file.at("name").get<std::string>(), file.at("taught_as"));
    EXPECT_EQ(taught_as.at("accident_stellar_voyager"), "A1");
    EXPECT_TRUE(taught_as.at("A01_stellar_voyager").is_null());
    EXPECT_TRUE(taught_as.at("let_go_port_25m").is_null()) << "L01 is made of it, and is another exercise";
}

TEST_F(ExerciseFilesTest, AreListedWithTheirLessonsAndTheNamesThatALessonMayUse) {
    const json list = files.list();
    ASSERT_EQ(list.at("files").size(), 2U);
    EXPECT_EQ(list.at("files")[0].at("name"), "L01_let_go_25m");
    EXPECT_EQ(list.at("files")[0].at("lesson"), "L01");
    EXPECT_TRUE(list.at("files")[1].at("lesson").is_null());
    EXPECT_THAT(list.at("events"), Contains("anchor.brought_up"));
    EXPECT_THAT(list.at("faults"), Contains("brake-lining-faded"));
}

TEST_F(ExerciseFilesTest, ALessonIsReadWithWhatItTakesOver) {
    const json read = files.read("L01_let_go_25m");
    EXPECT_EQ(read.at("text"), text_in(folder / "L01_let_go_25m.json"));
    EXPECT_THAT(read.at("mistakes"), IsEmpty());
    EXPECT_EQ(read.at("inherited").at("environment").at("depth"), 25.0);
}

TEST_F(ExerciseFilesTest, EachMistakeIsToldAtItsFieldAsLessonCheckTellsIt) {
    const struct {
        const char* at;
        json value;
        const char* told_at;
        const char* words;
    } mistakes[] = {
        {"/lesson/criteria/1/max", "fast", "/lesson/criteria/1/max", "a number"},
        {"/lesson/criteria/9/report", nullptr, "/lesson/criteria/9/report", "is missing"},
        {"/lesson/criteria/1/fail_above", 2, "/lesson/criteria/1/fail_above", "lies within the limit"},
        {"/lesson/criteria/0/at", "letgo", "/lesson/criteria/0/at", "let-go"},
        {"/lesson/orders/2/value", nullptr, "/lesson/orders/2/value", "how far"},
        {"/lesson/orders/2/codes", 1, "/lesson/orders/2/codes", "\"code\""},
        {"/environment/depth", -3, "/environment/depth", "from 2 to 1000"},
        {"/from", "no_such", "/from", "let_go_port_25m"},
        {"/from", "../secret.json", "/from", "inside the config folder"},
        {"/lesson/model_run", "../secret.json", "/lesson/model_run", "inside the config folder"},
        {"/lesson/model_run", "/etc/passwd", "/lesson/model_run", "inside the config folder"},
        {"/lesson/errors/0/script", "scripts/none.json", "/lesson/errors/0/script", "none.json"},
    };
    for (const auto& mistake : mistakes) {
        const auto told = files.mistakes("mine", l01(mistake.at, mistake.value));
        ASSERT_EQ(told.size(), 1U) << mistake.at << " " << mistake.value;
        EXPECT_EQ(told[0].at, mistake.told_at);
        EXPECT_THAT(told[0].text, HasSubstr(mistake.words));
    }
    EXPECT_THAT(files.mistakes("mine", "{"), ElementsAre(Field(&Mistake::text, HasSubstr("not JSON"))));
    EXPECT_THAT(files.mistakes("mine", "[]"), testing::SizeIs(1));
    EXPECT_THAT(files.mistakes("mine", std::string(100, '[')),
                ElementsAre(Field(&Mistake::text, HasSubstr("deep"))));
}

TEST_F(ExerciseFilesTest, WhatIsSoundIsSavedUnderANewNameAndLessonCheckTakesIt) {
    const json saved = files.save("mine", l01("/lesson/criteria/1/max", 5), "");
    EXPECT_TRUE(saved.at("saved").get<bool>());
    EXPECT_EQ(read_lesson_file(folder / "mine.json").lesson.criteria.at(1).max, 5);
    EXPECT_THAT(names(), ElementsAre("L01_let_go_25m.json", "let_go_port_25m.json", "mine.json"));
}

TEST_F(ExerciseFilesTest, WhatIsNotSoundIsNotSaved) {
    const json saved = files.save("mine", l01("/lesson/criteria/1/weight", -1), "");
    EXPECT_FALSE(saved.at("saved").get<bool>());
    EXPECT_THAT(saved.at("mistakes"), testing::SizeIs(1));
    EXPECT_FALSE(fs::exists(folder / "mine.json"));
}

TEST_F(ExerciseFilesTest, AGuardWithoutAFromIsDoubted) {
    json lesson = json::parse(text_in(folder / "L01_let_go_25m.json"));
    const auto doubts = [&] { return files.check("L01_let_go_25m", lesson.dump()).at("doubts").dump(); };
    const std::string doubted = "(guard): is in play before anything has been done";
    json guard = {{"id", "guard"},
                  {"kind", "prohibited"},
                  {"that", {{"brake_position", {{"below", 0.1}}}}},
                  {"weight", 1},
                  {"objective", lesson.at("lesson").at("objectives").at(0).at("id")}};
    lesson.at("lesson").at("criteria").push_back(guard);
    EXPECT_THAT(doubts(), HasSubstr(doubted));
    lesson.at("lesson").at("criteria").back()["from"] = {{"time", 5}};
    EXPECT_THAT(doubts(), testing::Not(HasSubstr(doubted)));
}

TEST_F(ExerciseFilesTest, AFileIsReplacedOnlyByOneWhoHasReadIt) {
    const std::string before = text_in(folder / "L01_let_go_25m.json");
    const std::string changed = l01("/lesson/criteria/1/max", 5);
    EXPECT_THAT([&] { files.save("L01_let_go_25m", changed, ""); },
                ThrowsMessage<std::runtime_error>(HasSubstr("is there already")));
    EXPECT_THAT([&] { files.save("L01_let_go_25m", changed, "0123"); },
                ThrowsMessage<std::runtime_error>(HasSubstr("by somebody else")));
    EXPECT_EQ(text_in(folder / "L01_let_go_25m.json"), before);
    const std::string stamp = files.read("L01_let_go_25m").at("stamp");
    const json saved = files.save("L01_let_go_25m", changed, stamp);
    EXPECT_EQ(text_in(folder / "L01_let_go_25m.json"), changed + "\n");
    EXPECT_THAT([&] { files.save("L01_let_go_25m", changed, stamp); },
                ThrowsMessage<std::runtime_error>(HasSubstr("by somebody else")))
        << "it was saved in between";
    EXPECT_EQ(files.read("L01_let_go_25m").at("stamp"), saved.at("stamp"));
}

TEST_F(ExerciseFilesTest, AFileThatWouldBeginWithItselfIsNotSaved) {
    const std::string stamp = files.read("let_go_port_25m").at("stamp");
    const json saved = files.save("let_go_port_25m", R"({"from": "L01_let_go_25m"})", stamp);
    EXPECT_FALSE(saved.at("saved").get<bool>());
    EXPECT_EQ(saved.at("mistakes")[0].at("at"), "/from");
}

TEST_F(ExerciseFilesTest, NoNameLeadsOutOfTheFolder) {
    const std::string sound = l01("/lesson/criteria/1/max", 5);
    for (const std::string& name :
         {std::string(), std::string("."), std::string(".."), std::string("../secret"),
          std::string("../exercises/mine"), std::string("/etc/passwd"), std::string("a/b"),
          std::string("a\\b"), std::string(".hidden"), std::string("-rf"), std::string("mine.json"),
          std::string("mi\0ne", 5), std::string("mine\n"), std::string("m\xC3\xBC") + "de",
          std::string("%2e%2e"), std::string(65, 'a')}) {
        EXPECT_FALSE(is_file_name(name)) << name;
        EXPECT_THROW(files.read(name), std::runtime_error) << name;
        EXPECT_THROW(files.save(name, sound, ""), std::runtime_error) << name;
    }
    EXPECT_THAT(names(), ElementsAre("L01_let_go_25m.json", "let_go_port_25m.json"));
    for (const char* name : {"a", "L01_let_go_25m", "2.0-b", "a..b"})
        EXPECT_TRUE(is_file_name(name)) << name;
    EXPECT_TRUE(is_file_name(std::string(64, 'a')));
}

TEST_F(ExerciseFilesTest, ALinkOutOfTheFolderIsNotFollowed) {
    fs::create_symlink(root / "secret.json", folder / "linked.json");
    EXPECT_THAT([&] { files.read("linked"); }, ThrowsMessage<std::runtime_error>(HasSubstr("leads out")));
    EXPECT_THROW(files.save("linked", l01("/lesson/criteria/1/max", 5), ""), std::runtime_error);
    EXPECT_EQ(text_in(root / "secret.json"), R"({"title": "not for a page"})");
}

TEST_F(ExerciseFilesTest, AFolderThatCannotBeWrittenIsSaidAndNothingIsLeftInIt) {
    if (geteuid() == 0) GTEST_SKIP() << "root writes everywhere";
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THAT([&] { files.save("mine", l01("/lesson/criteria/1/max", 5), ""); },
                ThrowsMessage<std::runtime_error>(HasSubstr("cannot be written")));
    fs::permissions(folder, fs::perms::owner_all);
    EXPECT_THAT(names(), testing::SizeIs(2));
}

TEST_F(ExerciseFilesTest, AQuestionThatIsNoneIsRefused) {
    EXPECT_THAT(
        [&] {
            files.answer({{"what", "remove"}, {"name", "L01_let_go_25m"}});
        },
        ThrowsMessage<std::runtime_error>(HasSubstr("list, read, check or save")));
    EXPECT_THROW(files.answer(json::object()), std::runtime_error);
    EXPECT_THROW(files.answer({{"what", 3}, {"name", json::array()}}), std::runtime_error);
}

} // namespace
} // namespace windlass::console
