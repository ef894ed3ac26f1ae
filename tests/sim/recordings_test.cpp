// The recorder in a simulated centre, and that the checks of its recordings can fail.

#include "sim/centre.hpp"
#include "sim/checks.hpp"
#include "sim/disk.hpp"
#include "sim/recording_checks.hpp"

#include "tests/recorder/made_recording.hpp"
#include "tests/sim/first_failure.hpp"

#include <gmock/gmock.h>

namespace windlass::sim {
namespace {

using testing::HasSubstr;

TEST(Centre, HasRecordersThatAreLost) {
    std::uint64_t recordings = 0, kills = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Outcome found = run({.seed = seed, .minutes = 0.5});
        recordings += found.recordings, kills += found.recorder_kills;
    }
    EXPECT_GT(kills, 0U);
    EXPECT_GT(recordings, 20U);
}

TEST(Checks, FindThatTheEndOfARecordingIsMissing) {
    EXPECT_EQ(first_failure(Sabotage::recording_shortened, 10), "recording");
}

TEST(Checks, FindASampleThatIsRecordedTwice) {
    EXPECT_EQ(first_failure(Sabotage::recording_doubled, 10), "recording");
}

TEST(Checks, FindASampleThatNobodyHeardWhileARecorderListened) {
    EXPECT_EQ(first_failure(Sabotage::recording_deaf, 10), "recording");
}

TEST(Checks, FindThatARecorderFlushesNothing) {
    EXPECT_EQ(first_failure(Sabotage::recording_unflushed, 10), "recording");
}

/// A recording of some events, closed, and what was heard of them.
Recorded closed_recording(SimDisk& disk) {
    Recorded recorded{.folder = "/recordings/a", .closed = true};
    recorder::Tape tape({.folder = recorded.folder}, disk);
    for (std::uint32_t k = 1; k <= 20; ++k) {
        const auto sample = test::sample(wire::topics::event, Event{}, k, k);
        recorded.heard.push_back({.topic = sample.topic,
                                  .writer = sample.writer,
                                  .sequence = sample.sequence,
                                  .log_time = sample.log_time,
                                  .publish_time = sample.publish_time,
                                  .payload = hash_of(sample.payload)});
        tape.write(sample);
        if (k % 5 == 0) tape.flush();
    }
    tape.close({{"messages", "20"}, {"lost_at_end", "0"}, {"dropped", "0"}});
    return recorded;
}

/// What the checks find of it.
std::string failure_of(SimDisk& disk, const Recorded& recorded) {
    try {
        hold_recording(disk, recorded);
    } catch (const Failure& found) {
        return found.expected + ", " + found.found;
    }
    return "";
}

// The disk was waited for: the file, its folder, and the folder above it.
TEST(Tape, ThatWasClosedIsWholeAfterAPowerCut) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        World world(seed);
        SimDisk disk(world);
        Recorded recorded = closed_recording(disk);
        disk.lose(Loss::power_cut);
        recorded.power_cut = true;
        ASSERT_EQ(failure_of(disk, recorded), "") << seed;
    }
}

TEST(Checks, FindWhatIsWrongWithARecording) {
    World world(1);
    SimDisk disk(world);
    const Recorded recorded = closed_recording(disk);
    ASSERT_EQ(failure_of(disk, recorded), "");

    Recorded other = recorded;
    other.heard.pop_back();
    EXPECT_THAT(failure_of(disk, other), HasSubstr("one of topic Event that was not heard"));
    other = recorded;
    std::swap(other.heard[3], other.heard[4]);
    EXPECT_THAT(failure_of(disk, other), HasSubstr("message 4 of 20 that were heard"));
    other = recorded;
    other.heard.push_back({.topic = recorded.heard.back().topic, .sequence = 21});
    EXPECT_THAT(failure_of(disk, other), HasSubstr("all 21 messages"));
    other.refused = true;
    EXPECT_THAT(failure_of(disk, other), HasSubstr("lost_at_end 1 in windlass.closing"));
    other = recorded;
    other.dropped = 2;
    EXPECT_THAT(failure_of(disk, other), HasSubstr("dropped 2 in windlass.closing"));
    other = recorded;
    other.closed = false, other.flushed = 21;
    EXPECT_THAT(failure_of(disk, other), HasSubstr("the 21 messages that were flushed"));

    disk.lose_the_end(".mcap", 10);
    EXPECT_THAT(failure_of(disk, recorded), HasSubstr("files that were closed"));
    other = recorded;
    other.closed = false;
    EXPECT_EQ(failure_of(disk, other), "") << "of one that was killed";
    const std::size_t size = disk.content("/recordings/a/a_000.mcap").value().size();
    disk.lose_the_end(".mcap", size - 1000); // in the midst of a record
    EXPECT_EQ(failure_of(disk, other), "");
    other.refused = true;
    EXPECT_EQ(failure_of(disk, other), "") << "killed as it wrote what the full disk had room for";
    other.ended = true;
    EXPECT_THAT(failure_of(disk, other), HasSubstr("nothing half written"));
}

} // namespace
} // namespace windlass::sim
