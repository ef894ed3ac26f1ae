// A live exercise from any moment of a recording: server, recorder, console and trainee, each a process.

#include "recorder/mcap/writer.hpp"
#include "recorder/resimulate/resimulation.hpp"

#include "idl/wire.hpp"

#include "tests/wire/recorder_rig.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using recorder::Mark;
using recording::Recording;
using testing::HasSubstr;

/// Programs of one exercise; with DDS Security, each with the identity of its role.
class Exercise {
public:
    explicit Exercise(bool secure) : secure_(secure) {
        if (!secure) return;
        const auto made = run(WINDLASS_SECURITY_DIR "/make_identities " + (folder_ / "identities").string());
        EXPECT_EQ(made.code, 0) << made.text;
    }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::vector<std::string> as(const std::string& role, std::vector<std::string> arguments = {}) const {
        if (secure_) arguments.insert(arguments.end(), {"--security", path("identities/" + role)});
        return arguments;
    }
    std::vector<std::string> server(const std::string& duration, std::vector<std::string> more) const {
        return let_go(duration, as("server", std::move(more)));
    }

    Ending console(const std::string& command) const {
        return client(INSTRUCTOR_CONSOLE " --timeout 25", "instructor", command);
    }
    Ending trainee(const std::string& script) const {
        put(path("script.json"), script);
        return client(TRAINEE_CLIENT " --connect 25 --view line", "trainee",
                      "--script " + path("script.json"));
    }
    json status() const { return json::parse(console("--json status").output); }

    /// Six seconds and more of let-go with orders of a trainee and an instructor, recorded under that name.
    void record(const std::string& name) const {
        RecorderProcess recorder(path(name), as("recorder"));
        ServerProcess server(this->server("40", {"--time-scale", "2"}));
        EXPECT_EQ(console("fault brake-lining-faded --severity 0.3").code, 0);
        const auto played =
            trainee(R"({"steps": [{"do": {"brake": 0}}, {"when": {"after": 3}, "do": {"brake": 0.4}},
                                  {"when": {"after": 2}, "do": {"brake": 0.2}}, {"when": {"after": 2}}]})");
        EXPECT_EQ(played.code, 0) << played.text;
        EXPECT_EQ(console("stop").code, 0);
        server.signal(SIGINT);
        EXPECT_EQ(server.exit_code(), 0) << server.text();
        EXPECT_TRUE(has_the_end(path(name)));
        recorder.signal(SIGINT);
        EXPECT_EQ(recorder.exit_code(), 0) << recorder.text();
    }

private:
    Ending client(const std::string& program, const std::string& role, const std::string& command) const {
        std::string line =
            "timeout 60 " + program + " --domain " + std::to_string(own_domain()) + " " + command;
        for (const auto& word : as(role))
            line += " " + word;
        return run(line);
    }

    bool secure_;
    Folder folder_;
};

/// The last state in the recording that has its hash only: none that a checkpoint alone would give back.
Mark last_hash(const std::string& path) {
    Recording recording({path});
    const auto runs = recorder::runs_of(recording);
    const auto found =
        std::ranges::find_if(runs.at(0).marks.rbegin(), runs.at(0).marks.rend(),
                             [](const Mark& mark) { return !mark.checkpoint && mark.tick % 3000 != 0; });
    return *found;
}

/// The recording, which is being written, has a run that begins at that instant.
bool begins_at(const std::string& path, const Mark& then) {
    try {
        Recording recording({path});
        const auto runs = recorder::runs_of(recording);
        const Mark* first = runs.empty() ? nullptr : runs.back().first_checkpoint();
        return first != nullptr && first->tick == then.tick;
    } catch (const std::exception&) { // its beginning is not on the disk yet
        return false;
    }
}

class Restore : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(OpenAndSecure, Restore, testing::Bool(),
                         [](const auto& info) { return info.param ? "Secure" : "Open"; });

TEST_P(Restore, GoesOnFromARecordedInstantAndTheTraineeCarriesOn) {
    const Exercise exercise(GetParam());
    exercise.record("monday");
    const auto again = run_recorder("resimulate " + exercise.path("monday"));
    ASSERT_EQ(again.code, 0) << again.text;

    const Mark then = last_hash(exercise.path("monday"));
    ASSERT_GT(then.time, 5);
    RecorderProcess recorder(exercise.path("branch"), exercise.as("recorder"));
    ServerProcess server(exercise.server("1000", {"--wait"}));
    const auto restored =
        exercise.console(fmt::format("restore {}@{:.6f}", exercise.path("monday"), then.time));
    ASSERT_EQ(restored.code, 0) << restored.text << server.text();
    const json now = exercise.status();
    EXPECT_EQ(now.at("state"), "RUN_PAUSED");
    EXPECT_EQ(now.at("tick"), then.tick);
    EXPECT_EQ(now.at("state_hash"), std::to_string(then.state_hash));
    // A recorder that finds the server only after the next checkpoint has that one instead.
    ASSERT_TRUE(rigs::eventually([&] { return begins_at(exercise.path("branch"), then); }));

    EXPECT_EQ(exercise.console("start").code, 0);
    const auto played = exercise.trainee(R"({"steps": [{"do": {"brake": 1}}, {"when": {"after": 1}}]})");
    EXPECT_EQ(played.code, 0) << played.text;
    EXPECT_EQ(exercise.console("stop").code, 0);
    server.signal(SIGINT);
    EXPECT_EQ(server.exit_code(), 0);
    EXPECT_TRUE(has_the_end(exercise.path("branch")));
    recorder.signal(SIGINT);
    EXPECT_EQ(recorder.exit_code(), 0);

    // The branch is a recording as any other: its last run begins at that instant, and the trainee is in
    // it.
    const auto branch = run_recorder("resimulate " + exercise.path("branch"));
    EXPECT_EQ(branch.code, 0) << branch.text;
    Recording recording({exercise.path("branch")});
    const auto runs = recorder::runs_of(recording);
    ASSERT_FALSE(runs.empty());
    EXPECT_EQ(runs.back().first_checkpoint()->tick, then.tick);
    EXPECT_EQ(runs.back().first_checkpoint()->state_hash, then.state_hash);
    EXPECT_TRUE(std::ranges::any_of(runs.back().orders, [](const auto& order) {
        return order.source == "trainee" &&
               std::holds_alternative<windlass::exercise::WindlassOrder>(order.command);
    }));
}

TEST(RestoreProgram, WhatCannotBeRestoredLeavesTheRunningExerciseAlone) {
    const Exercise exercise(false);
    exercise.record("monday");
    const std::string whole = exercise.path("monday") + "/monday_000.mcap";
    ASSERT_TRUE(std::filesystem::exists(whole));
    std::string bytes = content(whole);
    put(exercise.path("cut.mcap"), bytes.substr(0, 200));
    put(exercise.path("no_recording.mcap"), "nothing of the kind");
    {
        mcap::Writer writer(exercise.path("old.mcap"), {});
        writer.add_schema("windlass::Checkpoint", "omgidl", ""); // as before versions had numbers
        writer.close();
    }

    ServerProcess server(exercise.server("1000", {"--wait"}));
    const json before = exercise.status();
    const std::vector<std::pair<std::string, std::string>> refused{
        {exercise.path("monday") + "@500", "500 s of exercise is not in the recording, which has run 1 from"},
        {exercise.path("monday") + "@1 --run 7", "run 7 at 1 s"},
        {exercise.path("nowhere") + "@1", "cannot be read"},
        {exercise.path("no_recording.mcap") + "@1", "is no MCAP file"},
        {exercise.path("old.mcap") + "@1", "old.mcap is of version 1 of the wire, this program of version " +
                                               std::to_string(WIRE_VERSION) + ": "},
        {exercise.path("cut.mcap") + "@1", "is not in the recording"},
    };
    for (const auto& [what, why] : refused) {
        const auto ending = exercise.console("restore " + what);
        EXPECT_EQ(ending.code, 1) << what;
        EXPECT_THAT(ending.text, HasSubstr(why)) << what;
    }

    // A client that does not look before it sends.
    wire::Participant participant({own_domain(), wire::exercise_partition("default"), "careless"});
    wire::Writer<RestoreCommand> writer(participant, wire::topics::restore_command);
    ASSERT_TRUE(eventually([&] { return writer.matched() > 0; }));
    RestoreCommand command;
    command.origin().source("careless");
    command.origin().serial(1);
    command.from("nowhere");
    command.checkpoint().assign(20'000, 7);
    ASSERT_TRUE(writer.write(command));
    ASSERT_TRUE(eventually([&] { return exercise.status().at("commands_refused") == 1; }));
    EXPECT_THAT(server.text(),
                HasSubstr("RestoreCommand from careless: checkpoint = 20000 bytes from nowhere refused; "
                          "allowed: these bytes are no checkpoint"));

    const json after = exercise.status();
    for (const char* field : {"state", "tick", "state_hash", "exercise"})
        EXPECT_EQ(after.at(field), before.at(field)) << field;
}

} // namespace
} // namespace windlass::test
