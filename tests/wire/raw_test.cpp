// Payloads as they travel: recorded and written again without being opened.

#include "idl/raw.hpp"

#include "idl/payload.hpp"

#include "rigs/own_domain.hpp"
#include "rigs/wait.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mutex>

namespace windlass::wire {
namespace {

using rigs::eventually;
using rigs::own_domain;

/// What a raw reader heard.
struct Heard {
    std::mutex mutex;
    std::vector<std::vector<std::uint8_t>> payloads;
    std::vector<std::uint64_t> sequences;

    RawReader::OnSample callback() {
        return [this](const RawSample& sample) {
            const std::lock_guard lock(mutex);
            payloads.emplace_back(sample.payload.begin(), sample.payload.end());
            sequences.push_back(sample.sequence);
        };
    }
    std::size_t count() {
        const std::lock_guard lock(mutex);
        return payloads.size();
    }
};

TEST(RawEnds, KeyedSamplesPassThroughRecorderAndReplayUnchanged) {
    Participant server({own_domain(), "exercise/live", "server"});
    Participant recorder({own_domain(), "exercise/live", "recorder"});
    Participant replay({own_domain(), "exercise/replay", "replay"});
    Participant station({own_domain(), "exercise/replay", "station"});
    Heard live;
    std::mutex mutex;
    std::vector<Alert> shown;
    const RawReader records(recorder, topics::alert, live.callback());
    const Reader<Alert> shows(station, topics::alert, [&](const Alert& alert) {
        const std::lock_guard lock(mutex);
        shown.push_back(alert);
    });
    Writer<Alert> writer(server, topics::alert);
    RawWriter replays(replay, topics::alert);

    for (const char* code : {"brake.hot", "anchor.dragging", "chain.end"}) {
        for (const int side : {SIDE_PORT, SIDE_STARBOARD}) {
            Alert alert;
            alert.code(code);
            alert.side(side);
            alert.value(side + 0.25);
            ASSERT_TRUE(writer.write(alert));
        }
    }
    ASSERT_TRUE(eventually([&] { return live.count() == 6; }));
    {
        const std::lock_guard lock(live.mutex);
        for (const auto& payload : live.payloads)
            ASSERT_TRUE(replays.write(payload));
        EXPECT_THAT(live.sequences, testing::UnorderedElementsAre(1, 2, 3, 4, 5, 6));
    }
    // Depth is 1 for each instance: all six arrive late only when every payload has got its own key.
    ASSERT_TRUE(eventually([&] {
        const std::lock_guard lock(mutex);
        return shown.size() == 6;
    }));
    Heard again;
    Participant second({own_domain(), "exercise/replay", "recorder"});
    const RawReader late(second, topics::alert, again.callback());
    ASSERT_TRUE(eventually([&] { return again.count() == 6; }));
    EXPECT_THAT(again.payloads, testing::UnorderedElementsAreArray(live.payloads));
    EXPECT_THAT(shown, testing::Contains(testing::Truly([](const Alert& alert) {
                    return alert.code() == "anchor.dragging" && alert.side() == SIDE_STARBOARD &&
                           alert.value() == SIDE_STARBOARD + 0.25;
                })));
}

TEST(RawEnds, WhatIsNoPayloadIsNotWritten) {
    Participant participant({own_domain(), "exercise/a", "replay"});
    RawWriter writer(participant, topics::event);
    EXPECT_FALSE(writer.write({}));
    EXPECT_FALSE(writer.write(std::vector<std::uint8_t>(3)));
    EXPECT_FALSE(writer.write(std::vector<std::uint8_t>(4096))); // an Event is smaller
}

TEST(RawEnds, TypedEndOfTheSameTopicIsRefused) {
    Participant participant({own_domain(), "exercise/a", "recorder"});
    const RawReader raw(participant, topics::event, [](const auto&) {});
    EXPECT_THROW(Writer<Event>(participant, topics::event), std::logic_error);
    EXPECT_NO_THROW(RawWriter(participant, topics::event));
}

TEST(RawEnds, AWriterThatOutranksTheOthersIsTheOnlyOneHeardAndCanBeOutrankedAgain) {
    constexpr int kStrength = 10;
    Participant hears({own_domain(), "exercise/ranks", "server"});
    Participant first({own_domain(), "exercise/ranks", "desk-1"});
    Participant second({own_domain(), "exercise/ranks", "desk-2"});
    std::mutex mutex;
    std::vector<std::string> heard;
    const RawReader reader(hears, topics::instructor_windlass_command, [&](const RawSample& sample) {
        const std::lock_guard lock(mutex);
        heard.push_back(decode<WindlassCommand>(sample.payload).origin().source().to_string());
    });
    RawWriter one(first, topics::instructor_windlass_command, kStrength);
    RawWriter two(second, topics::instructor_windlass_command, kStrength);
    std::uint64_t serial = 0;
    const auto speak = [&](RawWriter& writer, const char* name) {
        WindlassCommand levers;
        levers.side(SIDE_PORT);
        levers.origin().source(name);
        levers.origin().serial(++serial);
        EXPECT_TRUE(writer.write(encode(levers)));
    };
    const auto only = [&](const std::string& name) {
        constexpr std::size_t kInARow = 10;
        return eventually([&] {
            speak(one, "desk-1");
            speak(two, "desk-2");
            const std::lock_guard lock(mutex);
            return heard.size() >= kInARow && std::all_of(heard.end() - kInARow, heard.end(),
                                                          [&](const auto& who) { return who == name; });
        });
    };
    ASSERT_TRUE(eventually([&] { return one.matched() == 1 && two.matched() == 1; }));
    two.outrank();
    EXPECT_TRUE(only("desk-2"));
    EXPECT_TRUE(one.outranked_by(two.id()));
    EXPECT_FALSE(two.outranked_by(one.id()));
    one.outrank();
    EXPECT_TRUE(only("desk-1"));
    EXPECT_TRUE(two.outranked_by(one.id()));
    two.outrank();
    EXPECT_TRUE(only("desk-2"));
}

} // namespace
} // namespace windlass::wire
