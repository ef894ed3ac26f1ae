// Recordings: by time and topic, over several files, with what is wrong told.

#include "recorder/info/figures.hpp"
#include "recorder/record/sample_queue.hpp"
#include "recorder/replay/replay_state.hpp"
#include "rigs/file_size_limit.hpp"

#include "tests/recorder/folder.hpp"
#include "tests/recorder/made_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace windlass::recorder {
namespace {

using recording::Recording;
using test::content;
using test::Folder;
using test::kSecond;
using test::kStart;
using test::put;
using test::sample;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

ShipState ship(int i) {
    ShipState state;
    state.tick(static_cast<std::uint64_t>(i));
    state.heading(i * 0.001);
    return state;
}

/// Ten seconds: ship states at 60 Hz, an event every second, a checkpoint at 0 and 5 s.
void write_ten_seconds(Tape& tape) {
    std::uint32_t events = 0;
    std::uint32_t checkpoints = 0;
    for (int i = 0; i < 600; ++i) {
        const double at = i / 60.0;
        if (i % 60 == 0) {
            Event event;
            event.number(events + 1);
            event.time(at);
            event.code("test.second");
            tape.write(sample(wire::topics::event, event, at, ++events));
            tape.flush();
        }
        if (i % 300 == 0) {
            Checkpoint checkpoint;
            checkpoint.tick(static_cast<std::uint64_t>(i));
            checkpoint.data().resize(100'000, static_cast<std::uint8_t>(i));
            tape.write(sample(wire::topics::checkpoint, checkpoint, at, ++checkpoints));
        }
        tape.write(sample(wire::topics::ship_state, ship(i), at, static_cast<std::uint32_t>(i + 1)));
    }
}

std::vector<std::uint64_t> ticks(Recording& recording, const recording::Query& query) {
    std::vector<std::uint64_t> found;
    auto cursor = recording.messages(query);
    while (const auto message = cursor.next())
        found.push_back(recording::decode<ShipState>(message->payload).tick());
    return found;
}

TEST(RecordingTest, MessagesComeByTopicAndTimeAcrossRolledFiles) {
    const Folder folder;
    Tape tape({.folder = folder / "r", .compression = mcap::Compression::none, .roll_size = 150'000});
    write_ten_seconds(tape);
    tape.close({});
    EXPECT_GT(tape.files(), 1U);
    EXPECT_EQ(tape.messages(), 612U);

    Recording recording({folder / "r"});
    EXPECT_THAT(recording.damage(), IsEmpty());
    EXPECT_THAT(recording.files(), SizeIs(tape.files()));
    EXPECT_EQ(recording.start(), kStart);
    EXPECT_NEAR(recording.seconds(), 599 / 60.0, 1e-9);
    EXPECT_THAT(ticks(recording, {.topics = {"ShipState"}}), SizeIs(600));
    const auto some = ticks(
        recording, {.topics = {"ShipState"}, .from = kStart + 2 * kSecond, .until = kStart + 3 * kSecond});
    ASSERT_THAT(some, SizeIs(60));
    EXPECT_EQ(some.front(), 120U);
    EXPECT_EQ(some.back(), 179U);
}

TEST(RecordingTest, LastCheckpointBeforeAMomentIsFound) {
    const Folder folder;
    Tape tape({.folder = folder / "r", .roll_size = 150'000});
    write_ten_seconds(tape);
    tape.close({});
    Recording recording({folder / "r"});
    const auto tick_at = [&](double seconds) {
        const auto found =
            recording.last_before("Checkpoint", kStart + static_cast<std::int64_t>(seconds * 1e9));
        return found ? static_cast<int>(recording::decode<Checkpoint>(found->payload).tick()) : -1;
    };
    EXPECT_EQ(tick_at(-1), -1);
    EXPECT_EQ(tick_at(0), 0);
    EXPECT_EQ(tick_at(4.99), 0);
    EXPECT_EQ(tick_at(5), 300);
    EXPECT_EQ(tick_at(100), 300);
    EXPECT_FALSE(recording.last_before("Alert", kStart + 10 * kSecond));
}

TEST(RecordingTest, DamagedChunkIsLeftOutAndTold) {
    const Folder folder;
    Tape tape({.folder = folder / "r"});
    write_ten_seconds(tape);
    tape.close({});
    const auto file = folder / "r" / "r_000.mcap";
    std::string bytes = test::content(file);
    const auto chunk = mcap::Reader(file).chunks().at(4);
    bytes.at(chunk.offset + chunk.length - 10) ^= 0x55;
    test::put(file, bytes);

    Recording recording({folder / "r"});
    const auto left = ticks(recording, {.topics = {"ShipState"}});
    EXPECT_LT(left.size(), 600U);
    EXPECT_GE(left.size(), 480U); // chunks are of a second
    ASSERT_THAT(recording.damage(), SizeIs(1));
    EXPECT_THAT(recording.damage()[0], HasSubstr("r_000.mcap: chunk at byte"));
}

TEST(RecordingTest, FilesOfTwoRecordingsAreNotMixed) {
    const Folder folder;
    for (const char* name : {"a", "b"}) {
        Tape tape({.folder = folder / name, .metadata = {{"recording", name}}});
        write_ten_seconds(tape);
        tape.close({});
    }
    EXPECT_THROW(Recording({folder / "a", folder / "b"}), std::runtime_error);
    EXPECT_NO_THROW(Recording({folder / "b"}));
    EXPECT_THROW(Recording({folder.path()}), std::runtime_error); // no .mcap in it
}

/// A file with one ship state, its type and what is said of the recording as given; whole, or without its
/// end.
void make_file(const std::filesystem::path& file, const char* type, const mcap::Strings& said,
               std::optional<std::size_t> cut = {}) {
    mcap::Writer writer(file, {});
    if (!said.empty()) writer.add_metadata({"windlass.recording", said});
    const auto schema = writer.add_schema(type, "omgidl", "");
    const auto channel = writer.add_channel(schema, "ShipState", "cdr", {});
    const auto payload = recording::encode(ship(1));
    writer.write({channel, 1, kStart, kStart, payload});
    writer.close();
    if (cut) std::filesystem::resize_file(file, *cut);
}

std::string refusal(const std::filesystem::path& path) {
    try {
        Recording recording({path});
    } catch (const recording::VersionError& error) {
        return error.what();
    }
    return "none";
}

TEST(RecordingTest, OfAnotherVersionOfTheWireIsRefusedAtOnceWithBothVersions) {
    const Folder folder;
    std::filesystem::create_directory(folder / "monday");
    make_file(folder / "monday" / "a.mcap", "windlass::ShipState", {{"recording", "x"}});
    EXPECT_EQ(
        refusal(folder / "monday"),
        (folder / "monday").string() +
            " is of version 1 of the wire, this program of version 12: use the programs of version 1, or "
            "any MCAP reader, since the file has its types with it");
    make_file(folder / "13.mcap", "windlass::v13::ShipState", {{"recording", "x"}, {"wire_version", "13"}});
    EXPECT_THAT(refusal(folder / "13.mcap"), HasSubstr("13.mcap is of version 13 of the wire"));
    make_file(folder / "11.mcap", "windlass::v11::ShipState", {{"recording", "x"}, {"wire_version", "11"}});
    EXPECT_THAT(refusal(folder / "11.mcap"), HasSubstr("11.mcap is of version 11 of the wire"));
    // Whoever wrote it, and however little of it is left.
    make_file(folder / "foreign.mcap", "windlass::ShipState", {});
    EXPECT_THAT(refusal(folder / "foreign.mcap"), HasSubstr("is of version 1 of the wire"));
    make_file(folder / "cut.mcap", "windlass::ShipState", {{"recording", "x"}}, 110);
    EXPECT_THAT(refusal(folder / "cut.mcap"), HasSubstr("is of version 1 of the wire"));
    make_file(folder / "12.mcap", "windlass::v12::ShipState", {{"recording", "x"}, {"wire_version", "12"}});
    EXPECT_EQ(refusal(folder / "12.mcap"), "none");
    make_file(folder / "theirs.mcap", "their::ShipState", {});
    EXPECT_EQ(refusal(folder / "theirs.mcap"), "none") << "nothing of ours: it says nothing of a version";
}

TEST(TapeTest, SaysWhichVersionOfTheWireItIs) {
    const Folder folder;
    Tape tape({.folder = folder / "r"});
    tape.write(sample(wire::topics::instructor_windlass_command, WindlassCommand{}, 0));
    tape.close({});
    Recording recording({folder / "r"});
    const auto& file = *recording.files()[0];
    EXPECT_EQ(file.metadata().at(0).entries.at("wire_version"), "12");
    ASSERT_EQ(file.schemas().size(), 1U);
    EXPECT_EQ(file.schemas().begin()->second.name, "windlass::v12::WindlassCommand")
        << "its type's, not its own";
    EXPECT_EQ(file.channels().begin()->second.topic, "InstructorWindlassCommand");
}

// Its recorder was killed, or its disk was full, as it began the next one.
TEST(RecordingTest, OfWhichTheLastFileWasOnlyBegunIsReadWithoutIt) {
    const Folder folder;
    Tape tape({.folder = folder / "r"});
    write_ten_seconds(tape);
    tape.close({});
    const std::string whole = content(folder / "r" / "r_000.mcap");
    for (const std::size_t size : {0U, 5U, 8U, 20U, 60U}) {
        put(folder / "r" / "r_001.mcap", whole.substr(0, size));
        Recording recording({folder / "r"});
        EXPECT_THAT(ticks(recording, {.topics = {"ShipState"}}), SizeIs(600)) << size;
        EXPECT_THAT(recording.damage(), ElementsAre(HasSubstr("r_001.mcap: it was begun"))) << size;
    }
}

TEST(TapeTest, FolderWithARecordingInItIsRefused) {
    const Folder folder;
    Tape({.folder = folder / "a"}).close({});
    EXPECT_THROW(Tape({.folder = folder / "a"}), std::runtime_error);
}

TEST(TapeTest, ThatIsDiscardedLeavesNothingOfItsOwnAndAllOfOthers) {
    const Folder folder;
    std::filesystem::create_directories(folder / "there");
    put(folder / "there" / "notes.txt", "kept");
    for (const char* name : {"new/of/it", "there"}) {
        Tape tape({.folder = folder / name});
        tape.close({});
        EXPECT_TRUE(std::filesystem::exists(folder / name));
        tape.discard();
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "new"));
    EXPECT_EQ(content(folder / "there" / "notes.txt"), "kept");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "there"), {}), 1);
}

TEST(TapeTest, ThatCannotBeBegunLeavesNoFolder) {
    const Folder folder;
    Tape({.folder = folder / "a"}).close({});
    put(folder / "file", "no folder");
    EXPECT_THROW(Tape({.folder = folder / "file" / "b"}), std::runtime_error);
    {
        const rigs::FileSizeLimit full(0);
        EXPECT_THROW(Tape({.folder = folder / "c"}), mcap::WriteError);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "c"));
}

TEST(TapeTest, ThousandsOfWritersShareAChannel) {
    const Folder folder;
    Tape tape({.folder = folder / "r"});
    for (std::uint32_t i = 0; i < 3000; ++i) {
        Sample one = sample(wire::topics::report, Report{}, i * 0.001);
        std::memcpy(one.writer.data(), &i, sizeof i);
        one.writer[15] = 1;
        tape.write(one);
    }
    tape.close({});
    Recording recording({folder / "r"});
    EXPECT_EQ(recording.files()[0]->channels().size(), 1001U);
    EXPECT_EQ(figures_of(recording).topics.at(0).messages, 3000U);
}

TEST(SampleQueueTest, DropsWhatDoesNotFitAndCountsItByTopic) {
    SampleQueue queue(100'000);
    const auto push = [&](std::size_t topic) {
        Sample one;
        one.topic = topic;
        one.payload.resize(1000);
        return queue.push(std::move(one), 0);
    };
    int kept = 0;
    while (push(3))
        ++kept;
    EXPECT_GT(kept, 80); // 1 kB and some tens of bytes each
    EXPECT_LT(kept, 100);
    EXPECT_FALSE(push(5));
    EXPECT_EQ(queue.drops()[3], 1U);
    EXPECT_EQ(queue.drops()[5], 1U);

    const auto taken = queue.pop_all(std::chrono::milliseconds(0));
    EXPECT_THAT(taken, SizeIs(kept));
    EXPECT_FALSE(push(3)) << "what is being written still takes its room";
    EXPECT_THAT(queue.pop_all(std::chrono::milliseconds(0)), IsEmpty());
    EXPECT_TRUE(push(3));
    for (std::size_t i = 1; i < taken.size(); ++i)
        ASSERT_GE(taken[i].log_time, taken[i - 1].log_time);
}

TEST(FiguresTest, CountRatesGapsLossesAndLatencies) {
    const Folder folder;
    Tape tape({.folder = folder / "r"});
    std::uint32_t sequence = 0;
    for (int i = 0; i < 600; ++i) {
        if (i >= 300 && i < 330) { // half a second that never came, numbered all the same
            ++sequence;
            continue;
        }
        tape.write(sample(wire::topics::ship_state, ship(i), i / 60.0, ++sequence));
    }
    tape.close({});
    Recording recording({folder / "r"});
    const auto figures = figures_of(recording);
    ASSERT_THAT(figures.topics, SizeIs(1));
    const auto& topic = figures.topics[0];
    EXPECT_EQ(topic.type, "windlass::v12::ShipState");
    EXPECT_EQ(topic.messages, 570U);
    EXPECT_EQ(topic.lost, 30U);
    EXPECT_NEAR(topic.rate(), 569 / (599 / 60.0), 1e-6);
    EXPECT_NEAR(topic.largest_gap, 31 / 60.0, 1e-6);
    EXPECT_NEAR(topic.largest_gap_at, 299 / 60.0, 1e-6);
    EXPECT_NEAR(topic.latency_at(0.5), 0.001, 1e-6);
}

Alert alert(const char* code, AlertCondition condition) {
    Alert made;
    made.code(code);
    made.condition(condition);
    return made;
}

TEST(ShownTest, NoCommandIsEverAmongTheTopicsOfAReplay) {
    const auto topics = shown_topics();
    for (const auto& row : wire::topics::all)
        EXPECT_EQ(topics.contains(row.name), row.from_server && std::string(row.name) != "ReplayStatus")
            << row.name;
}

TEST(ShownTest, FlagChangesTheStateAndNothingElse) {
    ExerciseStatus status;
    status.tick(77);
    status.time(12.5);
    status.state(RUN_PAUSED);
    status.title("the title");
    auto payload = recording::encode(status);
    ASSERT_TRUE(flag_as_replay(payload));
    status.state(RUN_REPLAY);
    EXPECT_EQ(payload, recording::encode(status));
    mcap::Buffer none(10);
    EXPECT_FALSE(flag_as_replay(none));
}

TEST(ShownTest, PictureHasAllEventsTheLastAlertsAndTheNewestStreams) {
    const Folder folder;
    Tape tape({.folder = folder / "r"});
    tape.write(sample(wire::topics::alert, alert("brake.hot", ALERT_ACTIVE_UNACKNOWLEDGED), 0, 1));
    tape.write(sample(wire::topics::alert, alert("chain.end", ALERT_ACTIVE_UNACKNOWLEDGED), 0, 2));
    write_ten_seconds(tape);
    tape.write(sample(wire::topics::alert, alert("brake.hot", ALERT_NORMAL), 10, 3));
    tape.close({});
    Recording recording({folder / "r"});

    std::map<std::string, int> count;
    std::uint64_t newest = 0;
    for (const auto& message : picture_at(recording, kStart + 6 * kSecond)) {
        ++count[message.topic];
        if (message.topic == "ShipState") newest = recording::decode<ShipState>(message.payload).tick();
        if (message.topic != "Checkpoint") continue;
        EXPECT_EQ(recording::decode<Checkpoint>(message.payload).tick(), 300U);
    }
    EXPECT_EQ(count["Event"], 6);
    EXPECT_EQ(count["Alert"], 2);
    EXPECT_EQ(count["Checkpoint"], 1);
    EXPECT_EQ(count["ShipState"], 15); // a quarter of a second
    EXPECT_EQ(newest, 359U);
    EXPECT_THAT(picture_at(recording, kStart), IsEmpty());
}

TEST(ShownTest, PictureHasEveryOrderOfTheBridgeAsItStandsAndWhatSeatsNoticed) {
    const Folder folder;
    Tape tape({.folder = folder / "r"});
    BridgeOrder order;
    for (const auto& [number, state, at] :
         {std::tuple{1, ORDER_GIVEN, 0.0}, {2, ORDER_GIVEN, 1.0}, {1, ORDER_REPEATED, 2.0}}) {
        order.number(number);
        order.state(state);
        tape.write(sample(wire::topics::bridge_order, order, at));
    }
    SeatEvent noticed;
    tape.write(sample(wire::topics::forecastle_event, noticed, 0.5));
    tape.write(sample(wire::topics::server_alert, alert("server.late", ALERT_ACTIVE_UNACKNOWLEDGED), 0.5));
    tape.write(sample(wire::topics::exercise_truth, ExerciseTruth{}, 0.6));
    order.number(3);
    tape.write(sample(wire::topics::bridge_order, order, 4));
    tape.close({});
    Recording recording({folder / "r"});
    std::vector<std::pair<int, BridgeOrderState>> orders;
    std::map<std::string, int> count;
    for (const auto& message : picture_at(recording, kStart + 3 * kSecond)) {
        ++count[message.topic];
        if (message.topic != "BridgeOrder") continue;
        const auto one = recording::decode<BridgeOrder>(message.payload);
        orders.emplace_back(one.number(), one.state());
    }
    EXPECT_THAT(orders, testing::ElementsAre(std::pair(2, ORDER_GIVEN), std::pair(1, ORDER_REPEATED)));
    EXPECT_EQ(count["ForecastleEvent"], 1);
    EXPECT_EQ(count["ServerAlert"], 1);
    EXPECT_EQ(count["ExerciseTruth"], 1);
}

TEST(ShownTest, AlertsAndOrdersThatStandAreTakenBackByAJump) {
    Standing standing;
    standing.keep("Alert", recording::encode(alert("brake.hot", ALERT_ACTIVE_UNACKNOWLEDGED)));
    standing.keep("Alert", recording::encode(alert("chain.end", ALERT_ACTIVE_ACKNOWLEDGED)));
    standing.keep("Alert", recording::encode(alert("brake.hot", ALERT_NORMAL)));
    standing.keep("ServerAlert", recording::encode(alert("chain.end", ALERT_ACTIVE_UNACKNOWLEDGED)));
    BridgeOrder order;
    order.number(7);
    order.state(ORDER_REPEATED);
    standing.keep("BridgeOrder", recording::encode(order));
    order.number(8);
    order.state(ORDER_CANCELLED);
    standing.keep("BridgeOrder", recording::encode(order));
    standing.keep("Event", recording::encode(Event{}));
    const auto samples = standing.taken_back();
    ASSERT_THAT(samples, SizeIs(3));
    EXPECT_EQ(samples[0].topic, "Alert");
    EXPECT_EQ(samples[1].topic, "ServerAlert");
    EXPECT_EQ(recording::decode<Alert>(samples[0].payload).code(), "chain.end");
    EXPECT_EQ(recording::decode<Alert>(samples[0].payload).condition(), ALERT_NORMAL);
    EXPECT_EQ(samples[2].topic, "BridgeOrder");
    EXPECT_EQ(recording::decode<BridgeOrder>(samples[2].payload).number(), 7);
    EXPECT_EQ(recording::decode<BridgeOrder>(samples[2].payload).state(), ORDER_CANCELLED);
    EXPECT_THAT(standing.taken_back(), IsEmpty());
}

} // namespace
} // namespace windlass::recorder
