// The pacer on a clock of the test's own.

#include "server/host/pacer.hpp"

#include <gtest/gtest.h>

namespace windlass::host {
namespace {

using namespace std::chrono_literals;

constexpr double kTick = 0.005;
constexpr double kBeat = 2 * kTick;
const Pacer::Time kStart{1000s};

double seconds(std::chrono::steady_clock::duration d) {
    return std::chrono::duration<double>(d).count();
}

/// Runs beats that each take `work`, sleeping until due; returns the wall time used.
double run(Pacer& pacer, Pacer::Time& now, int beats, std::chrono::microseconds work, int* ticks = nullptr) {
    const auto begin = now;
    for (int i = 0; i < beats; ++i) {
        now = std::max(now, pacer.due()) + work;
        if (ticks != nullptr) *ticks += pacer.ticks_per_beat();
        pacer.beat_ended(pacer.ticks_per_beat(), now);
    }
    return seconds(now - begin);
}

TEST(Pacer, KeepsRealTimeWithoutDrift) {
    Pacer pacer(kTick, 1, kStart);
    auto now = kStart;
    EXPECT_NEAR(run(pacer, now, 10000, 700us), 100, kBeat);
    EXPECT_EQ(pacer.overruns(), 0U);
    EXPECT_NEAR(pacer.scale_achieved(), 1, 0.01);
}

TEST(Pacer, RunsHalfAndTwentyTimesAsFast) {
    for (const double scale : {0.5, 20.0}) {
        Pacer pacer(kTick, scale, kStart);
        auto now = kStart;
        int ticks = 0;
        const double wall = run(pacer, now, 5000, 100us, &ticks);
        EXPECT_NEAR(ticks * kTick / wall, scale, 0.01 * scale);
        EXPECT_NEAR(pacer.scale_achieved(), scale, 0.02 * scale);
    }
}

TEST(Pacer, HeldBackItGoesNoFasterThanRealTimeAndThenAsBefore) {
    for (const double scale : {10.0, 0.0}) {
        Pacer pacer(kTick, scale, kStart);
        auto now = kStart;
        run(pacer, now, 1000, 100us);
        pacer.hold_back(true, now);
        int ticks = 0;
        const double held = run(pacer, now, 500, 100us, &ticks);
        EXPECT_NEAR(ticks * kTick / held, 1, 0.02) << scale;
        EXPECT_NEAR(pacer.scale_achieved(), 1, 0.1) << "it is told as it is";
        pacer.hold_back(false, now);
        ticks = 0;
        const double wall = run(pacer, now, 5000, 100us, &ticks);
        EXPECT_GT(ticks * kTick / wall, 9.9) << scale;
    }
    Pacer slow(kTick, 0.5, kStart);
    auto now = kStart;
    slow.hold_back(true, now);
    EXPECT_NEAR(run(slow, now, 100, 100us), 100 * kTick / 0.5, 2 * kTick) << "one that is slower stays so";
}

/// What costs with many exercises is not a tick but to come upon another's (bench/README.md).
TEST(Pacer, BeatIsAsManyTicksAsGoIntoTenMilliseconds) {
    EXPECT_EQ(Pacer(1.0 / 300, 1, kStart).ticks_per_beat(), 3);
    EXPECT_EQ(Pacer(1.0 / 300, 8, kStart).ticks_per_beat(), 24);
    EXPECT_EQ(Pacer(1.0 / 300, 0.1, kStart).ticks_per_beat(), 1);
    EXPECT_EQ(Pacer(1.0 / 60, 1, kStart).ticks_per_beat(), 1);
    EXPECT_EQ(Pacer(1.0 / 240, 1, kStart).ticks_per_beat(), 2);
}

TEST(Pacer, NobodyWaitsLongerThanTenMillisecondsToBeHeard) {
    for (const double scale : {1.0, 0.7, 20.0}) {
        Pacer pacer(1.0 / 300, scale, kStart);
        pacer.beat_ended(pacer.ticks_per_beat(), kStart);
        EXPECT_LE(pacer.due() - kStart, 10ms) << scale;
    }
}

TEST(Pacer, OverrunIsCountedAndLostTimeIsNotChased) {
    Pacer pacer(kTick, 1, kStart);
    auto now = kStart;
    run(pacer, now, 1, 110ms); // one beat that took 110 ms
    EXPECT_EQ(pacer.overruns(), 1U);
    EXPECT_NEAR(pacer.lateness(), 0.100, 1e-9);
    EXPECT_NEAR(run(pacer, now, 200, 1ms), 200 * kBeat, kBeat); // then as before, no faster
    EXPECT_EQ(pacer.overruns(), 1U);
    EXPECT_EQ(pacer.lateness(), 0);
}

TEST(Pacer, BeatOfFewerTicksThanThereWereToRunLosesNoTime) {
    Pacer pacer(1.0 / 300, 20, kStart);
    ASSERT_GT(pacer.ticks_per_beat(), 2);
    auto now = kStart;
    for (int tick = 0; tick < 6000; tick += 2) {
        now = std::max(now, pacer.due()) + 50us;
        pacer.beat_ended(2, now);
    }
    EXPECT_NEAR(seconds(now - kStart), 1, 0.001); // 20 s of exercise
    EXPECT_TRUE(pacer.hurried());
}

TEST(Pacer, EveryLateBeatCounts) {
    Pacer pacer(kTick, 1, kStart);
    auto now = kStart;
    run(pacer, now, 400, 20ms); // a machine half as fast as needed
    EXPECT_EQ(pacer.overruns(), 400U);
    EXPECT_NEAR(pacer.scale_achieved(), 0.5, 0.01);
}

TEST(Pacer, AsFastAsPossibleIsAlwaysDueAndNeverLate) {
    Pacer pacer(kTick, 0, kStart);
    auto now = kStart;
    EXPECT_NEAR(run(pacer, now, 30000, 100us), 3, 1e-6);
    EXPECT_EQ(pacer.overruns(), 0U);
    EXPECT_NEAR(pacer.scale_achieved(), 50, 0.5);
}

TEST(Pacer, TimeStandingStillIsNotMadeUpAfterwards) {
    Pacer pacer(kTick, 1, kStart);
    auto now = kStart;
    run(pacer, now, 100, 1ms);
    pacer.set_standing(true, now);
    EXPECT_NEAR(run(pacer, now, 1000, 1ms), 10, 0.02);
    pacer.set_standing(false, now);
    EXPECT_NEAR(run(pacer, now, 100, 1ms), 1, 2 * kTick);
    EXPECT_EQ(pacer.overruns(), 0U);
}

TEST(Pacer, ChangeOfRateStartsAtOnce) {
    Pacer pacer(kTick, 0.1, kStart);
    auto now = kStart;
    run(pacer, now, 2, 1ms); // the next beat is due in 50 ms
    pacer.set_scale(10, now);
    EXPECT_LE(pacer.due(), now);
}

} // namespace
} // namespace windlass::host
