// The clock of a replay, and what it may be asked.

#include "recorder/replay/orders.hpp"
#include "recorder/replay/playhead.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace windlass::recorder {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr Playhead::Time kNow{1000s};

TEST(PlayheadTest, RunsAtItsSpeedAndStandsWhenPaused) {
    Playhead head(100);
    EXPECT_EQ(head.position(kNow + 5s), 0);
    head.play(kNow);
    EXPECT_DOUBLE_EQ(head.position(kNow + 5s), 5);
    head.set_speed(4, kNow + 5s);
    EXPECT_DOUBLE_EQ(head.position(kNow + 7s), 13);
    head.pause(kNow + 7s);
    EXPECT_DOUBLE_EQ(head.position(kNow + 50s), 13);
    head.play(kNow + 50s);
    EXPECT_DOUBLE_EQ(head.position(kNow + 51s), 17);
}

TEST(PlayheadTest, SaysWhenAPositionIsDue) {
    Playhead head(100);
    head.set_speed(0.5, kNow);
    head.seek(10, kNow);
    head.play(kNow);
    EXPECT_EQ(head.due(12), kNow + 4s);
}

TEST(PlayheadTest, StaysWithinTheRecording) {
    Playhead head(100);
    head.play(kNow);
    EXPECT_EQ(head.position(kNow + 500s), 100);
    head.seek(-5, kNow);
    EXPECT_EQ(head.position(kNow), 0);
    head.set_speed(1000, kNow);
    EXPECT_EQ(head.speed(), Playhead::kFastest);
}

ReplayCommand command(ReplayAction action, double value, std::uint64_t serial) {
    ReplayCommand made;
    made.origin().source("instructor");
    made.origin().serial(serial);
    made.action(action);
    made.value(value);
    return made;
}

TEST(OrderCheckTest, RefusesWhatIsOutOfRangeUnknownOrOld) {
    OrderCheck check;
    const wire::WriterId writer{1};
    const auto refusal = [&](const ReplayCommand& c) { return check.refusal(c, writer, 60).value_or(""); };
    EXPECT_EQ(refusal(command(REPLAY_SEEK, 60, 1)), "");
    EXPECT_EQ(refusal(command(REPLAY_SPEED, 0.1, 2)), "");
    EXPECT_THAT(refusal(command(REPLAY_SEEK, 60.1, 3)), HasSubstr("value = 60.1 refused; allowed: 0..60 s"));
    EXPECT_THAT(refusal(command(REPLAY_SPEED, 11, 3)), HasSubstr("allowed: 0.1..10"));
    EXPECT_THAT(refusal(command(REPLAY_SPEED, std::numeric_limits<double>::quiet_NaN(), 3)),
                HasSubstr("nan"));
    EXPECT_THAT(refusal(command(static_cast<ReplayAction>(9), 0, 3)), HasSubstr("action = 9"));
    EXPECT_THAT(refusal(command(REPLAY_PLAY, 0, 2)), HasSubstr("origin.serial = 2"));
    EXPECT_EQ(refusal(command(REPLAY_PLAY, 0, 3)), "");
    EXPECT_EQ(check.refusal(command(REPLAY_PLAY, 0, 1), {2}, 60).value_or(""), "") << "another writer";
}

} // namespace
} // namespace windlass::recorder
