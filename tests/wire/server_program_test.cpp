// windlass_server as a program: options, exit codes, and its end.

#include "rigs/server_process.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace windlass::test {
using namespace rigs;

namespace {

std::string domain() {
    return std::to_string(own_domain());
}

void expect_code(std::vector<std::string> options, int code, const std::string& said) {
    ServerProcess server(std::move(options));
    EXPECT_EQ(server.exit_code(), code) << server.text();
    EXPECT_NE(server.text().find(said), std::string::npos)
        << "expected: " << said << "\ngot: " << server.text();
}

TEST(ServerProgram, HelpTellsOptionsAndExitCodes) {
    ServerProcess server({"--help"});
    EXPECT_EQ(server.exit_code(), 0);
    for (const char* word : {"--exercise", "--domain", "--partition", "--keep", "--time-scale", "--duration",
                             "--realtime", "--wait", "Exit codes:", "  4  DDS could not start"}) {
        EXPECT_NE(server.text().find(word), std::string::npos) << word;
    }
}

TEST(ServerProgram, BadOptionsEndWithCode2AndNameTheOption) {
    expect_code({"--brake", "1"}, 2, "--brake");
    expect_code({"--domain", "233"}, 2, "--domain");
    expect_code({"--time-scale", "nan"}, 2, "nan is not allowed: 0 or 0.1..20");
    expect_code({"--time-scale", "1e30"}, 2, "--time-scale");
    expect_code({"--duration", "-1"}, 2, "--duration");
    expect_code({"--partition", "a/b*"}, 2, "--partition");
    expect_code({"--log-level", "loud"}, 2, "--log-level");
    expect_code({"--realtime", "--time-scale", "0"}, 2, "--realtime");
    expect_code({"--partition", "a", "--partition", "a"}, 2, "a is given twice");
    expect_code({"--exercise", "x.json", "--exercise", "y.json"}, 2, "1 given for 2 --exercise");
}

TEST(ServerProgram, ExerciseThatIsNotThereEndsWithCode3AndNamesTheFile) {
    expect_code({"--exercise", "nowhere/nothing.json"}, 3, "nowhere/nothing.json");
}

TEST(ServerProgram, ExerciseWithABadValueEndsWithCode3AndNamesTheField) {
    const auto file =
        std::filesystem::temp_directory_path() / ("windlass_bad_" + std::to_string(getpid()) + ".json");
    std::ofstream(file) << R"({"name": "bad", "environment": {"depth": -25}})";
    expect_code({"--exercise", file.string(), "--config-root", WINDLASS_CONFIG_DIR}, 3, "/environment/depth");
    std::filesystem::remove(file);
}

TEST(ServerProgram, PracticeOfWhatHasNoLessonEndsWithCode3AndSaysSo) {
    expect_code({"--practice"}, 3, "has no lesson; name an exercise that has one, or leave practice out");
}

TEST(ServerProgram, PracticeIsToldInTheBriefing) {
    ServerProcess server({"--domain", domain(), "--practice", "--exercise",
                          std::string(WINDLASS_CONFIG_DIR) + "/exercises/L01_let_go_25m.json", "--duration",
                          "1", "--time-scale", "0"});
    EXPECT_EQ(server.exit_code(), 0) << server.text();
    EXPECT_NE(server.text().find("is for practice: you may be given a hint"), std::string::npos)
        << server.text();
}

TEST(ServerProgram, DdsThatCannotStartEndsWithCode4) {
    setenv("FASTRTPS_DEFAULT_PROFILES_FILE", "/nowhere/profiles.xml", 1);
    expect_code({"--domain", domain()}, 4, "/nowhere/profiles.xml");
    unsetenv("FASTRTPS_DEFAULT_PROFILES_FILE");
}

TEST(ServerProgram, SetDurationEndsWithCode0) {
    expect_code({"--domain", domain(), "--duration", "1", "--time-scale", "0"}, 0,
                "the set duration was run");
}

TEST(ServerProgram, SignalsStopItCleanlyWithCode0) {
    for (const int number : {SIGTERM, SIGINT}) {
        ServerProcess server({"--domain", domain()});
        ASSERT_TRUE(eventually([&] { return server.text().find("exercise.started") != std::string::npos; }));
        server.signal(number);
        EXPECT_EQ(server.exit_code(), 0) << server.text();
        EXPECT_NE(server.text().find("exercise finished"), std::string::npos);
    }
}

TEST(ServerProgram, RealTimeThatIsRefusedIsToldAndRunsWithoutIt) {
    ServerProcess server({"--domain", domain(), "--realtime", "--duration", "0.2"});
    EXPECT_EQ(server.exit_code(), 0) << server.text(); // with the right or without
}

} // namespace
} // namespace windlass::test
