// Servers in the classroom, and the instructor who opens and removes their exercises.

#include "idl/wire.hpp"
#include "rigs/server_process.hpp"
#include "tests/recorder/folder.hpp"
#include "tests/wire/run_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <future>
#include <map>

namespace windlass::test {
using namespace rigs;

namespace {

using testing::HasSubstr;

std::string domain() {
    return std::to_string(own_domain());
}

Ending console(const std::string& words) {
    return run(std::string(INSTRUCTOR_CONSOLE) + " --domain " + domain() + " --timeout 10 " + words);
}

nlohmann::json servers() {
    const auto answer = console("--json classroom list");
    return answer.code == 0 ? nlohmann::json::parse(answer.output) : nlohmann::json::array();
}

/// The exercise as the classroom tells it; null when there is none.
nlohmann::json exercise(const std::string& id) {
    for (const auto& server : servers())
        for (const auto& one : server["exercises"])
            if (one["id"] == id) return one;
    return {};
}

/// The classroom tells within a moment that the exercise is in that state.
bool becomes(const std::string& id, const std::string& state) {
    return eventually([&] {
        const auto one = exercise(id);
        return !one.is_null() && one["state"] == state;
    });
}

ServerProcess server(const std::string& name, std::vector<std::string> more) {
    more.insert(more.end(), {"--domain", domain(), "--name", name, "--config-root", WINDLASS_CONFIG_DIR});
    return ServerProcess(std::move(more));
}

bool in_classroom(const ServerProcess& server, std::chrono::seconds limit = std::chrono::seconds(20)) {
    return eventually([&] { return server.text().find("in the classroom") != std::string::npos; }, limit);
}

TEST(Classroom, InstructorCreatesWatchesAndRemovesExercises) {
    const auto running = server("bridge", {"--classroom"});
    ASSERT_TRUE(in_classroom(running)) << running.text();
    EXPECT_EQ(console("classroom create a --exercise let_go_port_25m").code, 0) << running.text();
    EXPECT_EQ(console("classroom create b --exercise let_go_port_25m --wait").code, 0) << running.text();
    EXPECT_TRUE(becomes("a", "RUN_RUNNING"));
    EXPECT_TRUE(becomes("b", "RUN_READY"));
    EXPECT_EQ(exercise("a")["failure"], "");
    EXPECT_TRUE(eventually([] { return exercise("a")["load"] > 0; })); // of the first whole second
    EXPECT_EQ(console("--partition b start").code, 0);                 // each is led as one that stands alone
    EXPECT_TRUE(becomes("b", "RUN_RUNNING"));
    EXPECT_EQ(console("classroom remove a").code, 0) << running.text();
    EXPECT_TRUE(exercise("a").is_null());
    EXPECT_TRUE(becomes("b", "RUN_RUNNING"));
    EXPECT_EQ(console("classroom remove a").code, 1);
    EXPECT_EQ(console("classroom create a --exercise let_go_port_25m").code, 0) << "its name is free again";
}

TEST(Classroom, LessonThatBeginsAtAnchorIsWaitedForAsLongAsTheServerIsAtWork) {
    const auto running = server("bridge", {"--classroom"});
    ASSERT_TRUE(in_classroom(running)) << running.text();
    const auto create = [&](const std::string& id) {
        Ending created;
        EXPECT_TRUE(eventually([&] { // on a busy machine three seconds may not do to hear of the server
            created = run(std::string(INSTRUCTOR_CONSOLE) + " --domain " + domain() + " --timeout 3 --name " +
                          id + " classroom create " + id + " --exercise A09_box_ship_gard --wait");
            return created.code != 4;
        }));
        return created;
    };
    // The second waits for the first one's way to its anchor as well as for its own.
    auto second = std::async(std::launch::async, create, "b9");
    const Ending first = create("a9"), other = second.get();
    EXPECT_EQ(first.code, 0) << first.text << running.text();
    EXPECT_EQ(other.code, 0) << other.text << running.text();
    EXPECT_TRUE(becomes("a9", "RUN_READY"));
    EXPECT_TRUE(becomes("b9", "RUN_READY"));
}

TEST(Classroom, DefinitionIsSentAlongAndABadOneIsRefusedWithFieldAndValue) {
    const Folder folder;
    const auto define = [&](const std::string& text) {
        std::ofstream(folder / "x.json") << text;
        return console("classroom create x --definition " + (folder / "x.json").string());
    };
    const auto running = server("bridge", {"--classroom"});
    ASSERT_TRUE(in_classroom(running)) << running.text();
    const auto expect_refused = [&](const std::string& text, const std::string& why) {
        const auto answer = define(text);
        EXPECT_EQ(answer.code, 1);
        EXPECT_THAT(answer.text, HasSubstr(why));
    };
    expect_refused(R"({"name": "bad", "environment": {"depth": -25}})", "/environment/depth: -25");
    expect_refused(R"({"name": "bad", "ship": {"from": "../../etc/passwd.json"}})",
                   "inside the config folder");
    expect_refused(R"({"name": "bad", "ship": {"from": "/etc/passwd.json"}})", "inside the config folder");
    expect_refused(std::string(100000, '['), "nested deeper than 64");
    expect_refused("anchor", "not JSON");
    EXPECT_TRUE(servers().at(0)["exercises"].empty());
    const auto good = define(R"({"name": "mine", "environment": {"depth": 40}})");
    EXPECT_EQ(good.code, 0) << good.text;
    EXPECT_EQ(exercise("x")["exercise"], "mine");
    EXPECT_THAT(console("--partition x status").text, HasSubstr("40.0 m"));
}

TEST(Classroom, BadOrdersAreRefusedAndWhatRunsGoesOn) {
    const auto running = server("bridge", {"--partition", "a"});
    ASSERT_TRUE(in_classroom(running)) << running.text();
    const auto expect_refused = [&](const std::string& words, const std::string& why) {
        const auto answer = console("classroom " + words);
        EXPECT_EQ(answer.code, 1) << words;
        EXPECT_THAT(answer.text, HasSubstr(why));
    };
    expect_refused("create a --exercise let_go_port_25m", R"(id = "a" refused)");
    expect_refused("create b --exercise nowhere", "nowhere.json: cannot be read");
    expect_refused("create b --exercise ../exercises/let_go_port_25m", "inside the server's exercise folder");
    expect_refused("create b", "a file name, or a definition");
    expect_refused("create b --exercise let_go_port_25m --server other", "no server other here");
    EXPECT_EQ(console("classroom create b/c --exercise let_go_port_25m").code, 2);
    EXPECT_EQ(servers().at(0)["exercises"].size(), 1U);
    EXPECT_TRUE(becomes("a", "RUN_RUNNING"));
}

TEST(Classroom, SeveralServersShareADomainWithoutMixing) {
    const auto port = server("port", {"--partition", "one"});
    const auto starboard = server("starboard", {"--partition", "two"});
    ASSERT_TRUE(in_classroom(port) && in_classroom(starboard)) << port.text() << starboard.text();
    // From now on a console that hears one of them knows of the other.
    ASSERT_TRUE(eventually([] {
        const auto both = servers();
        return both.size() == 2 && both[0]["neighbours"] == 1 && both[1]["neighbours"] == 1;
    }));
    EXPECT_EQ(console("classroom create three --exercise let_go_port_25m --server starboard").code, 0);
    EXPECT_EQ(console("classroom create four --exercise let_go_port_25m").code, 0);
    // A name that the other has is refused, whoever is asked.
    const auto answer = console("classroom create three --exercise let_go_port_25m --server port");
    EXPECT_EQ(answer.code, 1);
    EXPECT_THAT(answer.text, HasSubstr("server starboard has it"));
    EXPECT_EQ(console("--partition one pause").code, 0);
    EXPECT_TRUE(becomes("one", "RUN_PAUSED"));
    EXPECT_TRUE(becomes("two", "RUN_RUNNING"));
    EXPECT_TRUE(becomes("three", "RUN_RUNNING"));
    const auto both = servers();
    EXPECT_EQ(both.at(0)["exercises"].size(), 2U) << "four went to the one that had fewest, port";
    EXPECT_EQ(both.at(1)["exercises"].size(), 2U);
}

/// The wire's list of a server's exercises has 64 places.
TEST(Classroom, ProcessWithMoreExercisesThanAListHoldsIsTwoServers) {
    std::vector<std::string> options{"--threads", "1", "--wait"};
    for (int i = 1; i <= 65; ++i)
        options.insert(options.end(), {"--partition", "e" + std::to_string(i)});
    const auto running = server("bridge", std::move(options));
    // 65 exercises are opened one after another: 9 s on two cores at rest, over 20 beside other work.
    ASSERT_TRUE(in_classroom(running, std::chrono::seconds(120))) << running.text();
    std::map<std::string, std::size_t> told;
    EXPECT_TRUE(eventually([&] {
        for (const auto& one : servers())
            told[one["server"]] = one["exercises"].size();
        return told == std::map<std::string, std::size_t>{{"bridge", 64}, {"bridge.2", 1}};
    })) << running.text();
    EXPECT_TRUE(becomes("e65", "RUN_READY"));
    EXPECT_EQ(console("--partition e65 start").code, 0); // each is led as one of the first server's
    EXPECT_TRUE(becomes("e65", "RUN_RUNNING"));
    EXPECT_EQ(console("classroom remove e65").code, 0) << running.text();
    EXPECT_EQ(console("classroom create e1 --server bridge.2 --exercise let_go_port_25m").code, 1)
        << "its name is the first server's";
    const Ending again = console("classroom create e65 --server bridge.2 --exercise let_go_port_25m");
    EXPECT_EQ(again.code, 0) << again.text;
}

TEST(Classroom, ServerWithAnExerciseThatAnotherHasEndsWithCode5AndNamesIt) {
    const auto first = server("first", {"--partition", "a"});
    ASSERT_TRUE(in_classroom(first)) << first.text();
    auto second = server("second", {"--partition", "a"});
    EXPECT_EQ(second.exit_code(), 5) << second.text();
    EXPECT_THAT(second.text(), HasSubstr("server first"));
    EXPECT_TRUE(becomes("a", "RUN_RUNNING"));
}

TEST(Classroom, ServerWhoseNameAnotherHasEndsWithCode5AndTheOtherGoesOn) {
    auto first = server("bridge", {"--partition", "a"});
    ASSERT_TRUE(in_classroom(first)) << first.text();
    auto second = server("bridge", {"--partition", "b"});
    EXPECT_EQ(second.exit_code(), 5) << second.text();
    EXPECT_THAT(second.text(), HasSubstr("server bridge ends: another server of this name"));
    EXPECT_TRUE(becomes("a", "RUN_RUNNING"));
    EXPECT_FALSE(first.ended()) << first.text();
}

TEST(Classroom, KilledServersNamesAreFreeForTheNext) {
    auto first = server("bridge", {"--partition", "a"});
    ASSERT_TRUE(in_classroom(first)) << first.text();
    first.signal(SIGKILL);
    first.exit_code();
    const auto second = server("bridge", {"--partition", "a"});
    EXPECT_TRUE(in_classroom(second)) << second.text();
    EXPECT_TRUE(becomes("a", "RUN_RUNNING"));
}

/// A server that was cut off from us until now, and has had exercise a since long before.
class CutOff {
public:
    explicit CutOff(const std::string& name = "cut-off") {
        ClassroomStatus status;
        status.server(name);
        status.exercises().resize(1);
        status.exercises()[0].id("a");
        status.exercises()[0].since_unix_ns(1);
        EXPECT_TRUE(writer_.write(status));
    }

private:
    wire::Participant member_{{own_domain(), wire::kClassroomPartition, "cut-off", {}, {}}};
    wire::Writer<ClassroomStatus> writer_{member_, wire::topics::classroom_status};
};

TEST(Classroom, ServerThatGaveWayWithItsOnlyExerciseEndsWithCode5) {
    auto running = server("late", {"--partition", "a"});
    ASSERT_TRUE(in_classroom(running)) << running.text();
    const CutOff other;
    EXPECT_EQ(running.exit_code(), 5) << running.text();
    EXPECT_THAT(running.text(), HasSubstr("exercise a closed by late: server cut-off has one"));
}

TEST(Classroom, OfTwoServersOfOneNameThatMeetTheOneWithTheLaterExercisesEnds) {
    auto running = server("bridge", {"--partition", "b"});
    ASSERT_TRUE(in_classroom(running)) << running.text();
    const CutOff other("bridge");
    EXPECT_EQ(running.exit_code(), 5) << running.text();
    EXPECT_THAT(running.text(), HasSubstr("exercise finished: another server has the name bridge"));
}

TEST(Classroom, OfTwoServersThatOpenedOneNameUnheardTheLaterGivesWay) {
    const auto running = server("late", {"--partition", "a", "--partition", "b"});
    ASSERT_TRUE(in_classroom(running)) << running.text();
    const CutOff other;
    ASSERT_TRUE(eventually([&] { return running.text().find("classroom.gave_way") != std::string::npos; }))
        << running.text();
    EXPECT_THAT(running.text(), HasSubstr("exercise a closed by late: server cut-off has one"));
    EXPECT_TRUE(becomes("b", "RUN_RUNNING"));
}

} // namespace
} // namespace windlass::test
