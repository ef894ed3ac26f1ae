// Payloads as they travel: recorded and written again without being opened.

#include "idl/raw.hpp"

#include "rigs/own_domain.hpp"
#include "rigs/wait.hpp"

#include <gtest/gtest.h>

#include <mutex>

namespace windlass::wire {
namespace {

using test::eventually;
using test::own_domain;

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
        EXPECT_EQ(live.sequences, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6}));
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
    EXPECT_EQ(again.payloads, live.payloads);
    EXPECT_EQ(shown.at(3).code(), "anchor.dragging");
    EXPECT_EQ(shown.at(3).value(), 1.25);
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

} // namespace
} // namespace windlass::wire
