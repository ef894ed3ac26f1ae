// A replay: the same bytes at the same times, steered by topic, and never where a server is.

#include "tests/wire/recorder_rig.hpp"

#include "idl/raw.hpp"
#include "recorder/info/figures.hpp"
#include "recorder/recording/typed.hpp"
#include "recorder/replay/replay_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>

namespace windlass::test {
using namespace rigs;

namespace {

using recording::KeptMessage;
using recording::Recording;
using testing::HasSubstr;

/// Messages by topic and number of their writer (the lowest id where there are several: the server).
using Numbered = std::map<std::string, std::map<std::uint32_t, KeptMessage>>;

Numbered numbered(const std::filesystem::path& path) {
    Recording recording({path});
    Numbered found;
    auto cursor = recording.messages({.topics = recorder::shown_topics()});
    while (const auto message = cursor.next())
        found[message->topic()].try_emplace(message->sequence, *message);
    return found;
}

/// Bytes and times of a recording of a replay against the recording that was replayed.
struct Comparison {
    std::uint64_t compared = 0, different = 0, missing = 0, events_missing = 0;
    std::vector<double> error; ///< s, sorted
};

/// The replay writes the messages of a topic in their order: its n-th is the n-th of the recording.
Comparison compare(const std::filesystem::path& original, const std::filesystem::path& again) {
    Comparison result;
    const auto before = numbered(original);
    const auto after = numbered(again);
    std::vector<double> offsets;
    for (const auto& [topic, messages] : before) {
        std::uint32_t n = 0;
        for (const auto& [number, message] : messages) {
            ++n;
            const auto there = after.find(topic);
            const auto found = there == after.end() ? std::map<std::uint32_t, KeptMessage>::const_iterator{}
                                                    : there->second.find(n);
            if (there == after.end() || found == there->second.end()) {
                ++result.missing;
                if (topic == wire::topics::event.name) ++result.events_missing;
                continue;
            }
            auto expected = message.payload;
            if (topic == "ExerciseStatus") recorder::flag_as_replay(expected);
            ++result.compared;
            if (found->second.payload != expected) ++result.different;
            // When it was written, against when it was recorded; which moment is which, is the median's.
            offsets.push_back(static_cast<double>(found->second.publish_time - message.log_time) * 1e-9);
        }
    }
    auto sorted = offsets;
    std::ranges::sort(sorted);
    for (const double offset : offsets)
        result.error.push_back(std::abs(offset - sorted[sorted.size() / 2]));
    std::ranges::sort(result.error);
    return result;
}

std::vector<std::string> replay(const std::filesystem::path& recording, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"replay", recording.string()});
    return recorder_command(std::move(more));
}

/// What a station has heard of the replay.
struct Heard {
    ExerciseStatus status;
    ReplayStatus replay;
    std::vector<std::uint64_t> events;
};

class Watcher {
public:
    Heard heard() {
        const std::lock_guard lock(mutex_);
        return heard_;
    }
    bool until(const std::function<bool(const Heard&)>& condition) {
        return eventually([&] { return condition(heard()); });
    }

private:
    std::mutex mutex_;
    Heard heard_;
    wire::Participant participant_{{own_domain(), "exercise/replay", "station"}};
    wire::Reader<ExerciseStatus> status_{participant_, wire::topics::exercise_status,
                                         [this](const auto& sample) {
                                             const std::lock_guard lock(mutex_);
                                             heard_.status = sample;
                                         }};
    wire::Reader<ReplayStatus> replay_{participant_, wire::topics::replay_status, [this](const auto& sample) {
                                           const std::lock_guard lock(mutex_);
                                           heard_.replay = sample;
                                       }};
    wire::Reader<Event> log_{participant_, wire::topics::event, [this](const Event& sample) {
                                 const std::lock_guard lock(mutex_);
                                 auto& events = heard_.events;
                                 if (!events.empty() && sample.number() <= events.back()) events.clear();
                                 events.push_back(sample.number());
                             }};
};

Ending control(const std::string& order) {
    return run_recorder("control --domain " + std::to_string(own_domain()) + " " + order);
}

TEST(ReplayProgram, SendsTheSameBytesAtTheSameTimes) {
    const Folder folder;
    ASSERT_EQ(record_exercise(folder / "live", "10"), 0);
    {
        RecorderProcess second(folder / "again", {"--partition", "replay"});
        ChildProcess shown(replay(folder / "live"));
        ASSERT_EQ(shown.exit_code(), 0) << shown.text();
        std::cout << shown.text();
        EXPECT_TRUE(eventually([&] { // the last that was shown
            return statuses_in(folder / "again").size() == statuses_in(folder / "live").size();
        }));
        second.signal(SIGINT);
        ASSERT_EQ(second.exit_code(), 0) << second.text();
    }
    const auto result = compare(folder / "live", folder / "again");
    EXPECT_EQ(result.different, 0U);
    Recording live({folder / "live"});
    std::uint64_t written = 0; // by the server: what was heard, and what is missing from its numbers
    for (const auto& topic : recorder::figures_of(live).topics)
        written += topic.messages + topic.lost;
    EXPECT_GT(written, 3000U); // 10 s of more than 340 messages each
    // Streams are best-effort: on a machine that is busy elsewhere some are lost, and are not compared. One
    // that the replay leaves out shifts those behind it and makes them different; the log tells that it came
    // to its end.
    EXPECT_GT(result.compared, result.missing);
    EXPECT_EQ(result.events_missing, 0U);
    const auto part = [&](double p) {
        return 1e3 * result.error[static_cast<std::size_t>(p * static_cast<double>(result.error.size() - 1))];
    };
    std::cout << "timing error of " << result.compared << " messages, " << result.missing
              << " not heard: p50 " << part(0.5) << " ms, p99 " << part(0.99) << " ms, max " << part(1)
              << " ms\n";
}

TEST(ReplayProgram, IsSteeredByTopicAndShownAsReplay) {
    const Folder folder;
    ASSERT_EQ(record_exercise(folder / "live", "8"), 0);
    Watcher station;
    ChildProcess shown(replay(folder / "live", {"--paused", "--stay", "--start", "2"}));
    ASSERT_TRUE(station.until([](const Heard& heard) { return heard.status.state() == RUN_REPLAY; }))
        << shown.text();
    // Paused, with the very picture that was recorded last up to then: how far the exercise had come by that
    // moment is the machine's affair.
    Recording live({folder / "live"});
    const auto recorded = [&](int seconds) {
        const auto last = live.last_before("ExerciseStatus", live.start() + seconds * 1'000'000'000LL);
        return last ? recording::decode<ExerciseStatus>(last->payload).time() : -1;
    };
    ASSERT_LT(recorded(1), recorded(2));
    ASSERT_LT(recorded(2), recorded(6));
    EXPECT_EQ(station.heard().status.time(), recorded(2));

    EXPECT_EQ(control("seek 6").code, 0);
    EXPECT_TRUE(station.until([&](const Heard& heard) { return heard.status.time() == recorded(6); }));
    EXPECT_EQ(control("seek 1").code, 0);
    EXPECT_TRUE(station.until([&](const Heard& heard) { return heard.status.time() == recorded(1); }));
    EXPECT_TRUE(
        station.until([](const Heard& heard) { return !heard.events.empty() && heard.events.front() == 1; }));
    EXPECT_FALSE(station.heard().replay.playing());

    const auto too_far = control("seek 1000");
    EXPECT_EQ(too_far.code, 1);
    EXPECT_THAT(too_far.text, HasSubstr("value = 1000 refused; allowed: 0.."));
    EXPECT_EQ(control("speed 11").code, 1);

    EXPECT_EQ(control("speed 10").code, 0);
    EXPECT_EQ(control("play").code, 0);
    EXPECT_TRUE(station.until([](const Heard& heard) { return heard.status.time() > 7.5; }));
    EXPECT_TRUE(station.until([](const Heard& heard) { return !heard.replay.playing(); }))
        << "held at its end";
    EXPECT_EQ(control("loop 1").code, 0);
    EXPECT_EQ(control("speed 4").code, 0);
    EXPECT_EQ(control("play").code, 0);
    EXPECT_TRUE(station.until([](const Heard& heard) { return heard.status.time() > 7; }));
    EXPECT_TRUE(station.until([](const Heard& heard) { return heard.status.time() < 4; })) << "began again";
    EXPECT_THAT(control("status").text, HasSubstr("speed 4, loop"));
    EXPECT_EQ(control("stop").code, 0);
    EXPECT_EQ(shown.exit_code(), 0) << shown.text();
    EXPECT_THAT(shown.text(), HasSubstr("stopped by control-"));
}

TEST(ReplayProgram, TellsItsStreamsAgainWhileItStands) {
    const Folder folder;
    ASSERT_EQ(record_exercise(folder / "live", "3"), 0);
    ChildProcess shown(replay(folder / "live", {"--paused", "--stay", "--start", "2"}));
    Watcher station;
    ASSERT_TRUE(station.until([](const Heard& heard) { return heard.status.state() == RUN_REPLAY; }))
        << shown.text();
    // Comes after the jump: a stream is not kept for it, as one that a busy page missed is not.
    wire::Participant participant({own_domain(), "exercise/replay", "listener"});
    std::atomic<double> time = -1;
    std::atomic<int> heard = 0;
    const wire::Reader<WindlassLoad> late(participant, wire::topics::windlass_load,
                                          [&](const WindlassLoad& load) {
                                              time = load.time();
                                              ++heard;
                                          });
    EXPECT_TRUE(eventually([&] { return heard >= 2; }));
    EXPECT_NEAR(time, station.heard().status.time(), 0.3); // of the moment, not of where it began
}

TEST(ReplayProgram, GoesNowhereWhereALiveServerIs) {
    const Folder folder;
    ASSERT_EQ(record_exercise(folder / "live", "3"), 0);
    ServerProcess server(let_go("1000", {"--partition", "class"}));
    wire::Participant participant({own_domain(), "exercise/class", "listener"});
    std::atomic<int> heard = 0;
    std::atomic<int> replays = 0;
    const wire::Reader<ExerciseStatus> reader(participant, wire::topics::exercise_status,
                                              [&](const ExerciseStatus& sample) {
                                                  ++heard;
                                                  if (sample.state() == RUN_REPLAY) ++replays;
                                              });
    ASSERT_TRUE(eventually([&] { return heard > 0; }));
    ChildProcess refused(replay(folder / "live", {"--partition", "class"}));
    EXPECT_EQ(refused.exit_code(), 4);
    EXPECT_THAT(refused.text(), HasSubstr("nothing was sent"));
    EXPECT_EQ(replays, 0);
}

TEST(ReplayProgram, LeavesWhenALiveServerComes) {
    const Folder folder;
    ASSERT_EQ(record_exercise(folder / "live", "3"), 0);
    Watcher station;
    ChildProcess shown(replay(folder / "live", {"--loop"}));
    ASSERT_TRUE(station.until([](const Heard& heard) { return heard.status.state() == RUN_REPLAY; }))
        << shown.text();
    ServerProcess server(let_go("1000", {"--partition", "replay"}));
    EXPECT_EQ(shown.exit_code(), 4) << shown.text();
    EXPECT_THAT(shown.text(), HasSubstr("is in this partition now"));
}

TEST(ReplayProgram, StationsSayThatItTakesNoOrders) {
    const Folder folder;
    ASSERT_EQ(record_exercise(folder / "live", "3"), 0);
    // Listens to orders, as a recorder does: that somebody hears them does not make them obeyed.
    wire::Participant participant({own_domain(), "exercise/replay", "listener"});
    std::vector<wire::RawReader> commands;
    for (const auto& row : wire::topics::all)
        if (!row.from_server) commands.emplace_back(participant, row, [](const auto&) {});
    ChildProcess shown(replay(folder / "live", {"--loop"}));
    const std::string there = " --partition replay --domain " + std::to_string(own_domain());
    for (const auto& station :
         {INSTRUCTOR_CONSOLE " pause" + there, INSTRUCTOR_CONSOLE " levers --brake 1 --duration 0.1" + there,
          TRAINEE_CLIENT " --coach --script " WINDLASS_CONFIG_DIR "/scripts/let_go_port_25m.json" + there}) {
        const auto ending = run(station);
        EXPECT_EQ(ending.code, 4) << station;
        EXPECT_THAT(ending.text, HasSubstr("this is a replay, which takes no orders")) << station;
    }
}

TEST(ReplayProgram, WritesNoCommandTopic) {
    const Folder folder;
    ASSERT_EQ(record_exercise(folder / "live", "3"), 0);
    Watcher station;
    wire::Participant participant({own_domain(), "exercise/*", "listener"});
    std::vector<wire::RawReader> commands;
    for (const auto& row : wire::topics::all)
        if (!row.from_server) commands.emplace_back(participant, row, [](const auto&) {});
    ChildProcess shown(replay(folder / "live", {"--loop"}));
    ASSERT_TRUE(station.until([](const Heard& heard) { return heard.status.state() == RUN_REPLAY; }))
        << shown.text();
    // Its other writers have been found by now; these would have been announced with them.
    ASSERT_TRUE(station.until([](const Heard& heard) { return !heard.events.empty(); }));
    for (const auto& reader : commands)
        EXPECT_EQ(reader.matched(), 0);
}

} // namespace
} // namespace windlass::test
