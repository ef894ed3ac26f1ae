// An exercise on its way to the disk, which may be full or slow, and may end in order.

#include "rigs/file_size_limit.hpp"
#include "tests/keep/let_go.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>

namespace windlass::keep {
namespace {

using run::RunAction;
using test::LetGo;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Without a keeper: what its threads do is done where the test says so.
class KeptExerciseTest : public testing::Test {
protected:
    /// The exercise goes on to that tick, and what is new is written now and then.
    void go_to(std::uint64_t tick) {
        while (let_go_.session().now_tick() < tick) {
            let_go_.go_to(std::min(let_go_.session().now_tick() + 30, tick), &kept_);
            kept_.write_waiting();
        }
    }
    std::optional<TakenUp> taken_up() const {
        return take_up(path_, "anna", folder_ / "aside",
                       {.definition_hash = test::let_go_hash(), .check = {}});
    }
    double time_taken_up() const {
        const auto taken = taken_up();
        if (!taken || !taken->def) return -1;
        return exercise::read_checkpoint(taken->how.checkpoint, {}, &beside_).time();
    }
    /// As the session tells of it.
    bool told(const char* code) {
        let_go_.session().report_keeping(kept_.trouble());
        const auto& events = let_go_.session().events();
        return std::ranges::any_of(events, [&](const auto& event) { return event.code == code; });
    }

    const windlass::test::Folder folder_;
    const std::filesystem::path path_ = folder_ / "exercise-anna";
    KeptExercise kept_{path_, "anna", test::let_go_hash()};
    LetGo let_go_;
    mutable assess::Assessor beside_;
};

TEST_F(KeptExerciseTest, HasTheLastCheckpointAndTheOneBeforeWithTheirOrders) {
    go_to(6030);
    kept_.sync();
    go_to(6060);
    const auto files = kept_files(path_);
    ASSERT_THAT(files, SizeIs(2));
    std::size_t orders = 0;
    const KeptContents before(files.front());
    for (const auto& entry : before.entries())
        orders += entry.kind == Record::order ? 1U : 0U;
    EXPECT_EQ(orders, 200U) << "of the ten seconds between them";
    EXPECT_EQ(time_taken_up(), 6060 / 300.0);
}

TEST_F(KeptExerciseTest, FileSaysWhatTheDiskHasOfItAndThatAloneIsNotWaitedForAgain) {
    go_to(300);
    const auto file = kept_files(path_).front();
    const std::uint64_t size = std::filesystem::file_size(file);
    for (int round = 0; round < 3; ++round) {
        kept_.sync();
        kept_.write_waiting();
    }
    const KeptContents contents(file);
    ASSERT_EQ(contents.entries().back().kind, Record::synced);
    std::uint64_t synced = 0;
    std::memcpy(&synced, contents.entries().back().payload.data(), sizeof synced);
    EXPECT_EQ(synced, size);
    EXPECT_EQ(contents.entries().back().at, size) << "once";
}

TEST_F(KeptExerciseTest, FullDiskLetsTheExerciseRunOnAndSaysThatItIsNotKept) {
    go_to(600);
    const std::uint64_t hash_at_1500 = [] {
        LetGo alone;
        alone.go_to(1500);
        return alone.hash();
    }();
    {
        const rigs::FileSizeLimit full(std::filesystem::file_size(kept_files(path_).front()) + 200);
        go_to(1500);
        EXPECT_THAT(kept_.trouble(), HasSubstr("000001.kept: cannot write: File too large"));
        EXPECT_TRUE(told("exercise.not_kept"));
        EXPECT_THAT(let_go_.session().alerts(), SizeIs(1));
        let_go_.session().clear_news();
        go_to(1530);
        EXPECT_FALSE(told("exercise.not_kept")) << "once";
        EXPECT_EQ(let_go_.session().now_tick(), 1530U);
    }
    const double kept = time_taken_up();
    EXPECT_GE(kept, 600 / 300.0) << "up to where the disk took it";
    EXPECT_LT(kept, 700 / 300.0);
    let_go_.session().clear_news();
    go_to(3030); // with the next checkpoint, now that there is room
    EXPECT_EQ(kept_.trouble(), "");
    EXPECT_TRUE(told("exercise.kept"));
    EXPECT_EQ(time_taken_up(), 3030 / 300.0);

    LetGo alone;
    alone.go_to(1500);
    EXPECT_EQ(alone.hash(), hash_at_1500);
    alone.go_to(3030);
    EXPECT_EQ(let_go_.hash(), alone.hash()) << "it ran as if there were no disk";
}

TEST_F(KeptExerciseTest, DiskThatTakesNothingIsToldAndNoOrderIsKeptBehindOneThatWasLost) {
    go_to(30);
    for (int i = 0; i < 5000; ++i) { // more orders than may wait
        run::Inbox inbox;
        inbox.orders.push_back({"trainee", *test::order_at(0)});
        let_go_.session().carry_out(inbox, 0.1);
        let_go_.look(&kept_);
    }
    EXPECT_THAT(kept_.trouble(), HasSubstr("does not come to the disk"));
    let_go_.go_to(300, &kept_);
    kept_.write_waiting();
    const double kept = time_taken_up();
    EXPECT_GE(kept, 30 / 300.0);
    EXPECT_LT(kept, 40 / 300.0) << "up to the last order that is there";
    let_go_.go_to(3000, &kept_);
    EXPECT_EQ(kept_.trouble(), "") << "the checkpoint has all that was lost";
    kept_.write_waiting();
    EXPECT_EQ(time_taken_up(), 3000 / 300.0);
}

TEST_F(KeptExerciseTest, ExerciseThatEndsInOrderLeavesNothing) {
    go_to(300);
    ASSERT_THAT(kept_files(path_), SizeIs(1));
    let_go_.give(RunAction::stop);
    let_go_.look(&kept_);
    kept_.write_waiting();
    EXPECT_FALSE(std::filesystem::exists(path_));
    EXPECT_FALSE(taken_up());

    let_go_.give(RunAction::reset); // and is kept when it begins again
    let_go_.look(&kept_);
    kept_.write_waiting();
    EXPECT_EQ(time_taken_up(), 0);
}

TEST_F(KeptExerciseTest, ExerciseThatIsResetLeavesNothingOfItsCourseBefore) {
    go_to(3300);
    ASSERT_THAT(kept_files(path_), SizeIs(2));
    let_go_.give(RunAction::reset);
    let_go_.look(&kept_);
    kept_.write_waiting();
    EXPECT_EQ(time_taken_up(), 0);
    kept_.sync();
    kept_.write_waiting();
    EXPECT_THAT(kept_files(path_), SizeIs(1));
}

TEST_F(KeptExerciseTest, PausedExerciseWhoseLeversAreHeldAsksForACheckpointBeforeItsFileGrowsLong) {
    go_to(30);
    let_go_.give(RunAction::pause);
    std::uint64_t orders = 0;
    while (!kept_.wants_checkpoint() && orders < 100'000) {
        run::Inbox inbox;
        inbox.orders.push_back({"trainee", *test::order_at(0)});
        let_go_.session().carry_out(inbox, 0.1);
        let_go_.look(&kept_);
        if (++orders % 100 == 0) kept_.write_waiting();
    }
    EXPECT_TRUE(kept_.wants_checkpoint());
    let_go_.session().take_checkpoint_now();
    let_go_.look(&kept_);
    kept_.write_waiting();
    EXPECT_FALSE(kept_.wants_checkpoint());
    EXPECT_EQ(time_taken_up(), 30 / 300.0);
}

TEST(KeeperTest, FolderIsOneServersAlone) {
    const windlass::test::Folder folder;
    const Keeper first(folder.path());
    EXPECT_THAT([&] { const Keeper second(folder.path()); },
                testing::Throws<KeptError>(testing::Property(
                    &KeptError::what,
                    HasSubstr("process " + std::to_string(getpid()) + " keeps its exercises here"))));
}

TEST(KeeperTest, FolderThatCannotBeMadeIsNamed) {
    EXPECT_THAT(
        [] { const Keeper keeper("/dev/null/kept"); },
        testing::Throws<KeptError>(testing::Property(&KeptError::what, HasSubstr("/dev/null/kept: "))));
}

} // namespace
} // namespace windlass::keep
