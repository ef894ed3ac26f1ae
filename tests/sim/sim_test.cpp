// Simulated centres: the same seed is the same centre, and what is done to one on purpose is found.

#include "sim/centre.hpp"
#include "sim/disk.hpp"

#include <gmock/gmock.h>

#include <system_error>

namespace windlass::sim {
namespace {

using testing::HasSubstr;

/// The first check that fails, of so many seeds; empty: none does.
std::string first_failure(Sabotage sabotage, std::uint64_t seeds) {
    Plan plan;
    plan.sabotage = sabotage;
    plan.minutes = 0.5;
    for (plan.seed = 1; plan.seed <= seeds; ++plan.seed)
        if (const Outcome found = run(plan); found.failed) return found.failed->what.check;
    return "";
}

TEST(Centre, OfTheSameSeedIsTheSame) {
    for (const std::uint64_t seed : {1U, 5U, 7U}) {
        Plan plan;
        plan.seed = seed;
        const Outcome once = run(plan), again = run(plan);
        EXPECT_EQ(once.digest, again.digest) << seed;
        EXPECT_EQ(once.simulated, again.simulated) << seed;
        EXPECT_GT(once.ticks, 0U);
    }
}

TEST(Centre, OfAnotherSeedIsAnother) {
    EXPECT_NE(run({.seed = 1}).digest, run({.seed = 2}).digest);
}

TEST(Centre, NotDrawnFromItsSeedAloneIsNotTheSame) {
    const Plan plan{.seed = 1, .minutes = 0.2, .sabotage = Sabotage::chance};
    EXPECT_NE(run(plan).digest, run(plan).digest);
}

TEST(Checks, FindThatTheLastRecordsAreLost) {
    EXPECT_EQ(first_failure(Sabotage::last_record_lost, 10), "kept");
}

TEST(Checks, FindAnOrderThatIsNotTheOneThatWasTaken) {
    EXPECT_EQ(first_failure(Sabotage::order_altered, 10), "state");
}

TEST(Checks, FindALeverThatNoHandMoves) {
    EXPECT_EQ(first_failure(Sabotage::ghost_hand, 10), "levers");
}

TEST(Checks, FindAnEventThatIsNotTold) {
    EXPECT_EQ(first_failure(Sabotage::event_lost, 10), "events");
}

TEST(Checks, FindAnAlertThatIsNotTold) {
    EXPECT_EQ(first_failure(Sabotage::alert_untold, 10), "alerts");
}

/// Bytes for a file.
std::vector<std::uint8_t> bytes(std::size_t count) {
    return std::vector<std::uint8_t>(count, 'x');
}

TEST(SimDisk, HasAfterAPowerCutWhatItWasWaitedForAndOfTheRestAnyPart) {
    bool less = false, all = false;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        World world(seed);
        SimDisk disk(world);
        disk.make_folder("/kept");
        const auto file = disk.make("/kept/a");
        file->append(bytes(100));
        file->sync();
        disk.sync_folder("/kept");
        file->append(bytes(100));
        disk.lose(Loss::power_cut);
        const auto left = disk.read("/kept/a");
        ASSERT_GE(left.size(), 100U);
        EXPECT_EQ(std::vector(left.begin(), left.begin() + 100), bytes(100));
        less = less || left.size() < 200;
        all = all || left == bytes(200);
    }
    EXPECT_TRUE(less);
    EXPECT_TRUE(all);
}

TEST(SimDisk, HasAllThatAKilledServerHandedOver) {
    World world(1);
    SimDisk disk(world);
    disk.make("/a")->append(bytes(100));
    disk.lose(Loss::killed);
    EXPECT_EQ(disk.read("/a"), bytes(100));
}

TEST(SimDisk, ThatIsFullTakesWhatItHasRoomForAndRefusesTheRest) {
    World world(1);
    SimDisk disk(world);
    disk.room = 60;
    const auto file = disk.make("/a");
    EXPECT_EQ(file->append(bytes(100)), 60U);
    EXPECT_THROW(file->append(bytes(1)), std::system_error);
}

TEST(SimDisk, LosesTheServerAtTheCallThatWasDrawn) {
    World world(1);
    SimDisk disk(world);
    const auto file = disk.make("/a");
    disk.lose_in(2, Loss::killed);
    file->append(bytes(10));
    EXPECT_THROW(file->append(bytes(10)), Crash);
    EXPECT_THROW(disk.make("/b"), Crash) << "it makes no more calls";
    disk.lose(Loss::killed);
    EXPECT_GE(disk.read("/a").size(), 10U);
}

} // namespace
} // namespace windlass::sim
