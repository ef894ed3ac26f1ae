// The recorder with a real server: whole, killed, out of room, and opened by the readers of others.

#include "tests/recorder/made_recording.hpp"
#include "tests/wire/recorder_rig.hpp"

#include "idl/wire.hpp"
#include "recorder/command.hpp"
#include "recorder/info/figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>
#include <sys/stat.h>

namespace windlass::test {
using namespace rigs;

namespace {

using nlohmann::json;
using recording::Recording;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// Messages of each topic, by what our own reader finds.
std::map<std::string, std::uint64_t> counts(const std::filesystem::path& path) {
    Recording recording({path});
    std::map<std::string, std::uint64_t> found;
    for (const auto& topic : recorder::figures_of(recording).topics)
        found[topic.topic] = topic.messages;
    return found;
}

TEST(RecorderProgram, RecordsEveryTopicOfTheServerWithItsFilesAndEvents) {
    const Folder folder;
    ASSERT_EQ(record_exercise(folder / "r", "6"), 0);
    const auto ending = run_recorder("info --json " + (folder / "r").string());
    EXPECT_EQ(ending.code, 0);
    const json info = json::parse(ending.output);
    std::map<std::string, json> topics;
    for (const auto& topic : info["topics"])
        topics[topic["topic"]] = topic;
    // What a server of this version writes; a topic it learns to write is recorded with no change here.
    for (const char* name : {"ExerciseStatus", "ExerciseTruth", "EnvironmentState", "ShipState",
                             "AnchorState", "ChainState", "WindlassLoad", "CableForce", "ForecastleView",
                             "BridgeView", "SceneDescription", "Landmarks", "Event"}) {
        EXPECT_TRUE(topics.contains(name)) << name;
        EXPECT_EQ(topics[name]["type"], wire::type_name(std::string(name)));
    }
    for (const char* name : {"ForecastleEvent", "BridgeEvent"})
        EXPECT_EQ(topics[name]["type"], wire::type_name(std::string("SeatEvent"))) << name;
    // 6 s at 60 and 100 Hz, less a tenth for the time until both have found each other. Streams may lose
    // samples on a machine that is busy elsewhere; each is missing from its writer's numbers.
    const auto written = [&](const char* topic) {
        return topics[topic]["messages"].get<int>() + topics[topic]["lost"].get<int>();
    };
    EXPECT_GT(written("ShipState"), 324);
    EXPECT_GT(written("WindlassLoad"), 540);
    for (const char* topic : {"ShipState", "WindlassLoad"})
        EXPECT_GT(topics[topic]["messages"], topics[topic]["lost"]) << topic;
    EXPECT_THAT(info["attachments"], Contains("exercises/let_go_port_25m.json"));
    EXPECT_THAT(info["attachments"], Contains("windlasses/electric_78mm.json"));
    EXPECT_EQ(info["recording"]["idl_sha256"].get<std::string>().size(), 64U);
    EXPECT_EQ(info["recording"]["wire_version"], std::to_string(WIRE_VERSION));
    EXPECT_EQ(info["closing"]["dropped"], "0");
    EXPECT_EQ(info["events"].back()["code"], "exercise.finished");
}

/// Says it once the recorder hears; a stream, which may lose a sample, ten times.
template <class T>
void say(wire::Participant& client, const wire::Topic<T>& topic, const T& sample = {}) {
    wire::Writer<T> writer(client, topic);
    EXPECT_TRUE(eventually([&] { return writer.matched() > 0; })) << topic.name;
    for (int times = topic.reliable ? 1 : 10; times > 0; --times) {
        EXPECT_TRUE(writer.write(sample)) << topic.name;
        pace(std::chrono::milliseconds(5));
    }
    EXPECT_TRUE(writer.wait_acknowledged(std::chrono::seconds(10))) << topic.name;
}

/// Something on every topic that clients write, and on those of the server that it need not write by itself.
void say_every_topic() {
    namespace topics = wire::topics;
    wire::Participant client({own_domain(), "exercise/default", "client"});
    say(client, topics::windlass_command);
    say(client, topics::instructor_windlass_command);
    say(client, topics::helm_command);
    say(client, topics::instructor_helm_command);
    say(client, topics::own_ship_input);
    say(client, topics::exercise_command);
    say(client, topics::fault_command);
    say(client, topics::report);
    say(client, topics::bridge_order_command);
    say(client, topics::watch_circle);
    say(client, topics::lights_and_shapes_command);
    say(client, topics::deck_work_command);
    say(client, topics::forecastle_answer);
    say(client, topics::bridge_answer);
    say(client, topics::alert_command);
    say(client, topics::assessment_command);
    say(client, topics::replay_command);
    say(client, topics::forecastle_question);
    say(client, topics::bridge_question);
    say(client, topics::order_taken);
    say(client, topics::bridge_order);
    say(client, topics::forecastle_alert);
    say(client, topics::server_alert);
    say(client, topics::assessment);
    // Sequences in structures, of structures, of octets.
    EnvironmentCommand weather;
    weather.weather().current_profile().resize(3);
    say(client, topics::environment_command, weather);
    SeaState sea;
    sea.components().resize(2);
    say(client, topics::sea_state, sea);
    SeabedDescription seabed;
    seabed.heights().resize(16);
    seabed.soils().resize(16);
    say(client, topics::seabed_description, seabed);
    Chart chart;
    chart.soundings().resize(5);
    say(client, topics::chart, chart);
    RestoreCommand restore;
    restore.from("monday");
    restore.checkpoint().assign(1000, 7);
    say(client, topics::restore_command, restore);
}

TEST(RecorderProgram, ReadersOfOthersDecodeEveryMessageOfEveryTopic) {
    const Folder folder;
    if (run("command -v node && test -d " WINDLASS_NPM).code != 0)
        GTEST_SKIP()
            << "\n*** NOT TESTED: the pages are not built (no node or npm), so nobody but ourselves has "
               "read our files";

    for (const char* compression : {"zstd", "lz4"}) {
        const auto output = folder / compression;
        ASSERT_EQ(
            record_exercise(output, "3", {"--compression", compression, "--roll", "1"}, say_every_topic), 0);
        const auto read = run("node " WINDLASS_RUN_TS " " WINDLASS_READ " " + output.string() + "/*.mcap");
        ASSERT_EQ(read.code, 0) << read.text;
        const json found = json::parse(read.output);
        const auto expected = counts(output);
        EXPECT_EQ(found["topics"].size(), expected.size());
        for (const auto& row : wire::topics::all)
            EXPECT_TRUE(row.from_server || expected.contains(row.name)) << row.name;
        EXPECT_TRUE(expected.contains("OrderTaken"));
        for (const auto& [topic, messages] : expected)
            EXPECT_EQ(found["topics"][topic]["messages"], messages) << topic;
        EXPECT_EQ(found["topics"]["ServerAlert"]["type"], "windlass::v12::Alert");
        EXPECT_EQ(found["topics"]["InstructorHelmCommand"]["type"], "windlass::v12::HelmCommand");
        EXPECT_EQ(found["topics"]["ShipState"]["last_time"], 3.0) << "decoded, not only counted";
        EXPECT_THAT(found["attachments"], Contains("ships/bulk_carrier_225m.json"));
    }
}

TEST(RecorderProgram, WhatIsRecordedSurvivesAKill) {
    const Folder folder;
    RecorderProcess recorder_process(folder / "r");
    ServerProcess server(let_go("5"));
    EXPECT_EQ(server.exit_code(), 0);
    // Nothing more comes: what there is must reach the disk by itself, not by an orderly end.
    const auto ended_on_disk = [&] {
        Recording so_far({folder / "r"});
        const auto figures = recorder::figures_of(so_far);
        return !figures.events.empty() && figures.events.back().code() == "exercise.finished";
    };
    EXPECT_TRUE(eventually(ended_on_disk));
    recorder_process.signal(SIGKILL);
    recorder_process.exit_code();

    EXPECT_TRUE(ended_on_disk());
    Recording recording({folder / "r"});
    ASSERT_EQ(recording.damage().size(), 1U);
    EXPECT_THAT(recording.damage()[0], HasSubstr("not closed"));
    EXPECT_GT(recording.seconds(), 3.5); // of 5 s; the first may go by before streams have found each other
    const auto info = run_recorder("info " + (folder / "r").string());
    EXPECT_EQ(info.code, 3);
    EXPECT_THAT(info.text, HasSubstr("bytes are left out"));
}

TEST(RecorderProgram, EndsInOrderWhenTheSystemRefusesToWrite) {
    const Folder folder;
    // Blocks of 1 KiB: some seconds after the definitions that a file begins with, the whole IDL for each
    // topic.
    ChildProcess recorder_process(
        {"/bin/bash", "-c",
         "ulimit -f 1500; exec " WINDLASS_RECORDER " record --compression none --domain " +
             std::to_string(own_domain()) + " --output " + (folder / "r").string()});
    ASSERT_TRUE(
        eventually([&] { return recorder_process.text().find("recording partition") != std::string::npos; }));
    ServerProcess server(let_go("20"));
    EXPECT_EQ(recorder_process.exit_code(), 5) << recorder_process.text();
    EXPECT_THAT(recorder_process.text(), HasSubstr("ended early"));
    EXPECT_THAT(recorder_process.text(), HasSubstr("cannot write: File too large"));
    EXPECT_THAT(recorder_process.text(), HasSubstr("could not be written"));

    Recording recording({folder / "r"});
    EXPECT_GT(recorder::figures_of(recording).messages, 100U);
    EXPECT_GT(recording.seconds(), 0.5);
}

TEST(RecorderProgram, RefusesToStartWhereThereIsTooLittleRoom) {
    const Folder folder;
    const auto ending = run_recorder("record --keep-free 1e9 --output " + (folder / "r").string());
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.text, HasSubstr("1000000000.0 MB are to be kept free (--keep-free)"));
    EXPECT_FALSE(std::filesystem::exists(folder / "r"));
}

TEST(RecorderProgram, LeavesNothingBehindWhereNothingWasHeard) {
    const Folder folder;
    const std::string record = "record --domain " + std::to_string(rigs::own_domain()) + " --output " +
                               (folder / "new" / "rec").string();
    const auto quiet = run_recorder(record + " --partition nobody-there --duration 1");
    EXPECT_EQ(quiet.code, 0);
    EXPECT_THAT(quiet.text, HasSubstr("nothing was heard in partition exercise/nobody-there of domain"));
    EXPECT_FALSE(std::filesystem::exists(folder / "new"));

    const auto wrong = run_recorder(record + " --partition 'no name' --duration 1");
    EXPECT_NE(wrong.code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "new")) << wrong.text;
}

TEST(RecorderProgram, CountsWhatItDidNotHear) {
    const Folder folder;
    RecorderProcess recorder_process(folder / "r");
    wire::Participant participant({own_domain(), "exercise/default", "server"});
    wire::Writer<ChainState> writer(participant, wire::topics::chain_state);
    ASSERT_TRUE(eventually([&] { return writer.matched() == 1; }));
    ChainState full_cable;
    full_cable.nodes().resize(2048);
    full_cable.tension().resize(2047);
    std::uint64_t written = 0;
    const auto write = [&](int samples, int milliseconds) {
        for (; samples > 0; --samples) {
            if (writer.write(full_cable)) ++written;
            pace(std::chrono::milliseconds(milliseconds));
        }
    };
    const auto known = [&] { // heard, or missed, of what is on the disk
        try {
            Recording so_far({folder / "r"});
            const auto topics = recorder::figures_of(so_far).topics;
            return topics.empty() ? std::uint64_t{0} : topics[0].lost + topics[0].messages;
        } catch (const std::exception&) { // its beginning is not on the disk yet
            return std::uint64_t{0};
        }
    };
    write(100, 1);
    // A writer may know a reader that does not know it yet: what goes out then nobody can count.
    ASSERT_TRUE(eventually([&] {
        const std::uint64_t before = known();
        write(1, 0);
        return before > 0 && eventually([&] { return known() == before + 1; }, std::chrono::seconds(2));
    }));
    const std::uint64_t before_it_listened = written - known();
    ASSERT_LT(before_it_listened, 50U);
    written -= before_it_listened;
    recorder_process.signal(SIGSTOP);
    write(2000, 1); // 66 MB: far more than all buffers hold for a recorder that does not look
    recorder_process.signal(SIGCONT);
    write(100, 1);
    // A gap is known by what is heard after it: the last must be heard, also by one that is behind.
    EXPECT_TRUE(eventually(
        [&] {
            write(1, 0);
            return eventually([&] { return known() == written; }, std::chrono::seconds(5));
        },
        std::chrono::seconds(60)));
    recorder_process.signal(SIGINT);
    EXPECT_EQ(recorder_process.exit_code(), 0);

    Recording recording({folder / "r"});
    const auto figures = recorder::figures_of(recording);
    ASSERT_EQ(figures.topics.size(), 1U);
    EXPECT_GT(figures.topics[0].lost, 0U);
    EXPECT_EQ(figures.topics[0].lost + figures.topics[0].messages, written);
}

TEST(RecorderProgram, InfoSaysOfWhichWindlassAnEventIsAndHowBad) {
    const Folder folder;
    recorder::Tape tape({.folder = folder / "r"});
    Event event;
    event.number(1);
    event.code("windlass.overspeed");
    event.severity(EVENT_WARNING);
    event.side(SIDE_STARBOARD);
    event.text("running away");
    tape.write(sample(wire::topics::event, event, 0));
    tape.close({});

    const std::string path = (folder / "r").string();
    EXPECT_THAT(run_recorder("info " + path).text, HasSubstr("WARNING: starboard: running away\n"));
    const json told = json::parse(run_recorder("info --json " + path).output);
    EXPECT_EQ(told["events"].at(0)["side"], "starboard");
    EXPECT_EQ(told["events"].at(0)["severity"], "warning");
}

TEST(RecorderProgram, TellsWhatIsWrongWithAFile) {
    const Folder folder;
    put(folder / "notes.mcap", "this is no recording at all");
    const auto notes = run_recorder("info " + (folder / "notes.mcap").string());
    EXPECT_EQ(notes.code, 3);
    EXPECT_THAT(notes.text, HasSubstr("notes.mcap: is no MCAP file"));

    ASSERT_EQ(record_exercise(folder / "r", "3"), 0);
    const auto whole = content(folder / "r" / "r_000.mcap");
    const auto last = mcap::Reader(folder / "r" / "r_000.mcap").chunks().back().offset;
    put(folder / "cut.mcap", whole.substr(0, last + 100));
    const auto cut = run_recorder("export --format jsonl " + (folder / "cut.mcap").string() + " --output " +
                                  (folder / "cut.jsonl").string());
    EXPECT_EQ(cut.code, 3);
    EXPECT_THAT(cut.text, HasSubstr("cut.mcap: it was not closed: at byte"));
    EXPECT_THAT(content(folder / "cut.jsonl"), HasSubstr("\"topic\":\"ShipState\""));

    EXPECT_EQ(run_recorder("info " + (folder / "missing").string()).code, 1);
    EXPECT_EQ(run_recorder("replay").code, 2);
    EXPECT_EQ(run_recorder("record --roll nan").code, 2);
}

TEST(RecorderProgram, RefusesARecordingOfAnotherVersionOfTheWire) {
    const Folder folder;
    {
        mcap::Writer writer(folder / "monday.mcap", {});
        writer.add_metadata({"windlass.recording", {{"recording", "monday"}}});
        const auto schema = writer.add_schema("windlass::ShipState", "omgidl", "");
        const auto channel = writer.add_channel(schema, "ShipState", "cdr", {});
        writer.write({channel, 1, kStart, kStart, recording::encode(ShipState{})});
        writer.close();
    }
    const std::string path = (folder / "monday.mcap").string();
    for (const char* command : {"info ", "export --format jsonl ", "replay ", "resimulate "}) {
        const auto ending = run_recorder(command + path);
        EXPECT_EQ(ending.code, 3) << command;
        EXPECT_THAT(ending.text, HasSubstr(path + " is of version 1 of the wire, this program of version " +
                                           std::to_string(WIRE_VERSION) + ": "))
            << command;
    }
}

TEST(RecorderProgram, ExportsATableForEachTopicAndJsonLines) {
    const Folder folder;
    ASSERT_EQ(record_exercise(folder / "r", "3"), 0);
    const std::string recording = (folder / "r").string();
    ASSERT_EQ(run_recorder("export " + recording + " --output " + (folder / "csv").string()).code, 0);
    ASSERT_EQ(
        run_recorder("export --format jsonl " + recording + " --output " + (folder / "a.jsonl").string())
            .code,
        0);
    // What is told at each set-up holds for all of it, and has no time.
    const std::set<std::string> timeless{"SceneDescription", "SeabedDescription", "Chart", "Landmarks"};
    std::uint64_t total = 0;
    for (const auto& [topic, messages] : counts(folder / "r")) {
        const auto table = content(folder / "csv" / (topic + ".csv"));
        EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), static_cast<std::ptrdiff_t>(messages + 1))
            << topic;
        EXPECT_THAT(table, HasSubstr("recorded (s),log_time (ns)")) << topic;
        EXPECT_THAT(table, HasSubstr(timeless.contains(topic) ? "definition_hash" : "time (s)")) << topic;
        total += messages;
    }
    std::ifstream lines(folder / "a.jsonl");
    std::uint64_t read = 0;
    for (std::string line; std::getline(lines, line); ++read) {
        const json message = json::parse(line)["message"];
        ASSERT_TRUE(message.contains("time") || message.contains("definition_hash")) << line;
    }
    EXPECT_EQ(read, total);
}

TEST(RecordMany, KeepsEachOfItsExercisesByItself) {
    const Folder folder;
    const std::string a = folder / "a", b = folder / "b", fifo = folder / "orders";
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    // First: it would hold the orders open that are opened below.
    const ServerProcess server(
        let_go("1000", {"--partition", "a", "--exercise",
                        WINDLASS_CONFIG_DIR "/exercises/let_go_port_25m.json", "--partition", "b"}));
    ChildProcess recorder({"/bin/sh", "-c",
                           "exec " WINDLASS_RECORDER " record-many --config-root " WINDLASS_CONFIG_DIR
                           " --domain " +
                               std::to_string(own_domain()) + " < " + fifo});
    std::ofstream orders(fifo); // waits for the other end
    const auto record = [&](const std::string& exercise, const std::string& output) {
        orders << nlohmann::json{{"record", exercise}, {"output", output}} << std::endl;
    };
    record("a", a);
    record("b", b);
    record("a", folder / "once_more");
    record("c", "/proc/nowhere"); // which has no room
    record("../d", folder / "d");
    orders << "nonsense\n"
           << R"({"end": "d"})" << std::endl;
    ASSERT_TRUE(eventually([&] { return !statuses_in(a).empty() && !statuses_in(b).empty(); }))
        << recorder.text();

    orders << R"({"end": "a"})" << std::endl;
    ASSERT_TRUE(eventually([&] {
        return recorder.text().find(R"({"code":0,"ended":"a"})") != std::string::npos;
    })) << recorder.text();
    EXPECT_EQ(run_recorder("info " + a).code, 0);
    const auto so_far = statuses_in(b).size();
    EXPECT_TRUE(eventually([&] { return statuses_in(b).size() > so_far; })) << "b goes on";

    orders.close(); // as it is when the program that began it has gone
    EXPECT_EQ(recorder.exit_code(), recorder::kDisk) << "of c";
    const std::string text = recorder.text();
    EXPECT_THAT(text, HasSubstr(R"({"code":5,"ended":"c"})"));
    EXPECT_THAT(text, HasSubstr(R"({"code":0,"ended":"b"})"));
    EXPECT_THAT(text, HasSubstr("exercise a is recorded already"));
    EXPECT_THAT(text, HasSubstr("nonsense"));
    EXPECT_THAT(text, HasSubstr("../d"));
    EXPECT_EQ(run_recorder("info " + b).code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "d"));
    EXPECT_FALSE(std::filesystem::exists(folder / "once_more"));
}

} // namespace
} // namespace windlass::test
