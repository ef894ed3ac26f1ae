// Keeping on a simulated disk (sim/), which may be slow and lose its power at any call.

#include "server/keep/take_up.hpp"
#include "sim/disk.hpp"
#include "tests/keep/let_go.hpp"

#include <gmock/gmock.h>

#include <thread>

namespace windlass::keep {
namespace {

using sim::Loss;
using sim::SimDisk;
using sim::World;
using test::LetGo;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::filesystem::path kFolder = "/kept/exercise-anna", kAside = "/kept/aside";

/// A server runs the let-go up to that tick.
void keep_up_to(std::uint64_t tick, KeptExercise& kept, LetGo& let_go) {
    let_go.look(&kept);
    kept.write_waiting();
    if (!let_go.session().running()) let_go.give(run::RunAction::start);
    while (let_go.session().now_tick() < tick) {
        let_go.go_to(std::min(let_go.session().now_tick() + 30, tick), &kept);
        kept.write_waiting();
        kept.sync();
    }
}

TEST(SimulatedDisk, ThatIsWaitedForWhileTheExerciseEndsIsNotWaitedForAgain) {
    World world(1);
    SimDisk disk(world);
    KeptExercise kept(kFolder, "anna", test::let_go_hash(), disk, [&world] { return world.time(); });
    LetGo let_go;
    keep_up_to(300, kept, let_go);
    let_go.go_to(330, &kept);
    kept.write_waiting();
    disk.served = true;
    disk.sync_takes = 1;
    world.at(0.5, [&] {
        let_go.give(run::RunAction::stop);
        let_go.look(&kept);
        kept.write_waiting();
    });
    kept.sync();
    kept.sync();
    let_go.look(&kept);
    EXPECT_EQ(kept.trouble(), "");
    EXPECT_THAT(kept_files(kFolder, disk), IsEmpty());
}

// Seed 2799 of the simulated centres: what had been removed of it, and an older course, were there again.
TEST(SimulatedDisk, HasNothingOfAnExerciseThatEndedAfterAPowerCut) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        World world(seed);
        SimDisk disk(world);
        KeptExercise kept(kFolder, "anna", test::let_go_hash(), disk, [&world] { return world.time(); });
        LetGo let_go;
        keep_up_to(300, kept, let_go);
        let_go.give(run::RunAction::stop);
        let_go.look(&kept);
        kept.write_waiting();
        disk.lose(Loss::power_cut);
        ASSERT_THAT(kept_files(kFolder, disk), IsEmpty()) << seed;
    }
}

// A file with a checkpoint says from its beginning whether the exercise ran.
TEST(SimulatedDisk, HasThatTheExerciseRanAtWhateverCallItsServerIsLost) {
    bool lost = true;
    for (std::uint64_t k = 1; lost; ++k) {
        World world(k);
        SimDisk disk(world);
        KeptExercise kept(kFolder, "anna", test::let_go_hash(), disk, [&world] { return world.time(); });
        LetGo let_go;
        keep_up_to(2970, kept, let_go);
        let_go.go_to(3001, &kept); // with the next checkpoint
        disk.lose_in(k, Loss::killed);
        lost = false;
        try {
            kept.write_waiting();
        } catch (const sim::Crash&) {
            lost = true;
        }
        disk.lose(Loss::killed);
        const auto taken =
            take_up(kFolder, "anna", kAside,
                    {.definition_hash = test::let_go_hash(), .check = {}, .running = true}, disk);
        ASSERT_TRUE(taken && taken->def) << k;
        EXPECT_EQ(taken->how.state, exercise::RunState::running) << k;
    }
}

std::optional<TakenUp> start(SimDisk& disk, std::uint64_t definition_hash = test::let_go_hash()) {
    return take_up(kFolder, "anna", kAside, {.definition_hash = definition_hash, .check = {}}, disk);
}

/// What is kept of the let-go at that tick, on a disk of its own.
class KeptAt {
public:
    explicit KeptAt(std::uint64_t tick) { go_on(tick, {}); }
    /// Taken up by another server, which runs it up to that tick.
    void go_on(std::uint64_t tick) { go_on(tick, start(disk_)->how); }
    /// The same on that disk, which has it.
    void copy_to(SimDisk& disk) {
        disk.make_folder(kFolder);
        for (const auto& path : disk_.list(kFolder)) {
            const auto file = disk.make(path, files::ReadBy::owner);
            file->append(disk_.read(path));
            file->sync();
        }
        disk.sync_folder(kFolder);
    }

private:
    void go_on(std::uint64_t tick, std::optional<run::Resumption> from) {
        KeptExercise kept(kFolder, "anna", test::let_go_hash(), disk_, [this] { return world_.time(); });
        LetGo let_go(std::move(from));
        keep_up_to(tick, kept, let_go);
        kept.write_waiting();
    }

    World world_{1};
    SimDisk disk_{world_};
};

double time(const std::optional<TakenUp>& taken) {
    return taken && taken->def ? LetGo(taken->how).session().now_time() : -1;
}

/// A server starts, and is lost in its k-th call to the disk; false: it makes less of them.
bool lost_in(std::uint64_t k, Loss how, SimDisk& disk) {
    disk.lose_in(k, how);
    try {
        start(disk);
    } catch (const sim::Crash&) {
        disk.lose(how);
        return true;
    }
    disk.lose(how);
    return false;
}

TEST(SetBack, StandsAtTheSameCheckpointAtWhateverCallToTheDiskItsServerIsLost) {
    KeptAt kept(3100); // of checkpoints at 0 and at 10 s
    kept.go_on(3200);
    for (const Loss how : {Loss::killed, Loss::power_cut}) {
        bool lost = true;
        for (std::uint64_t k = 1; lost; ++k) {
            World world(k);
            SimDisk disk(world);
            kept.copy_to(disk);
            start(disk);
            disk.sync_folder(kFolder);
            lost = lost_in(k, how, disk);
            auto next = start(disk);
            for (int start_again = 0; start_again < 2 && next && next->how.set_back.empty(); ++start_again)
                next = start(disk); // the power took what was counted
            ASSERT_TRUE(next) << k;
            EXPECT_THAT(next->how.set_back, HasSubstr("ended the server 2 times and lies in /kept/aside"))
                << k;
            EXPECT_EQ(time(next), 10) << k;
        }
    }
}

TEST(SetBack, ToTheBeginningIsToldThoughItsServerIsLostAtIt) {
    KeptAt kept(600); // of a checkpoint at 0
    bool lost = true;
    for (std::uint64_t k = 1; lost; ++k) {
        World world(k);
        SimDisk disk(world);
        kept.copy_to(disk);
        start(disk), start(disk);
        lost = lost_in(k, Loss::killed, disk);
        const auto next = start(disk);
        if (!next) continue; // lost at the last call: all is done
        EXPECT_FALSE(next->def) << k;
        EXPECT_THAT(next->how.set_back, HasSubstr("it begins from its file, and waits to be started")) << k;
        EXPECT_FALSE(start(disk)) << k;
    }
}

TEST(SetBack, CountsTheLossesOfTheServersThatStandThere) {
    KeptAt kept(6100);
    World world(1);
    SimDisk disk(world);
    kept.copy_to(disk);
    start(disk), start(disk); // and are lost
    for (int k = 0; k < 3; ++k)
        EXPECT_EQ(time(start(disk)), 10);
    const auto anew = start(disk);
    ASSERT_TRUE(anew && !anew->def) << "the checkpoint ended two servers as well";
    EXPECT_THAT(anew->how.set_back, HasSubstr("it begins from its file"));
}

/// A server runs what it took up, or began anew, up to that tick and is lost.
void lose_at(std::uint64_t tick, SimDisk& disk, const World& world, const run::Resumption& how) {
    KeptExercise kept(kFolder, "anna", test::let_go_hash(), disk, [&world] { return world.time(); });
    LetGo let_go(how);
    keep_up_to(tick, kept, let_go);
    kept.write_waiting();
}

/// A course with two checkpoints, of which two servers were lost, and which the disk refused to have put
/// aside when the third began anew.
class OldCourse : public testing::Test {
protected:
    OldCourse() {
        KeptAt kept(3100);
        kept.copy_to(disk_);
        start(disk_), start(disk_);
        disk_.refuses = true;
        anew_ = start(disk_)->how;
        disk_.refuses = false;
        EXPECT_THAT(anew_.refused, HasSubstr("Input/output error"));
        EXPECT_THAT(kept_files(kFolder, disk_), SizeIs(2));
    }

    World world_{1};
    SimDisk disk_{world_};
    run::Resumption anew_;
};

TEST_F(OldCourse, IsNotTakenForTheNewOneAndItsLossesAreNotCountedOfIt) {
    lose_at(600, disk_, world_, anew_);
    for (int loss = 0; loss < 2; ++loss) {
        const auto taken = start(disk_);
        EXPECT_EQ(time(taken), 2) << loss;
        EXPECT_EQ(taken->how.set_back, "") << loss;
    }
    const auto back = start(disk_);
    ASSERT_TRUE(back && !back->def) << "a checkpoint before is there, of the old course";
    EXPECT_THAT(back->how.set_back, HasSubstr("its state at 0:02 ended the server 2 times"));
    EXPECT_THAT(back->how.set_back, HasSubstr("it begins from its file"));
    EXPECT_THAT(kept_files(kAside / "anna-1", disk_), SizeIs(3)) << "with what is left of the old one";
}

TEST_F(OldCourse, GoesWithTheSecondCheckpointOfTheNewOne) {
    lose_at(3100, disk_, world_, anew_);
    EXPECT_THAT(kept_files(kFolder, disk_), SizeIs(2));
    EXPECT_THAT(attempts_files(kFolder, disk_), IsEmpty());
    EXPECT_NEAR(time(start(disk_)), 3100 / 300.0, 1e-9);
}

TEST(SetBack, ToTheBeginningOfACourseComesToNoOlderOneAtWhateverCallItsServerIsLost) {
    KeptAt kept(3100);
    for (const Loss how : {Loss::killed, Loss::power_cut}) {
        bool lost = true;
        for (std::uint64_t k = 1; lost; ++k) {
            World world(k);
            SimDisk disk(world);
            kept.copy_to(disk);
            start(disk), start(disk);
            disk.refuses = true; // to put the old course aside
            const auto anew = start(disk)->how;
            disk.refuses = false;
            lose_at(600, disk, world, anew);
            start(disk), start(disk);
            disk.sync_folder(kFolder);
            lost = lost_in(k, how, disk);
            auto next = start(disk);
            for (int start_again = 0; start_again < 2 && next && next->how.set_back.empty(); ++start_again) {
                EXPECT_EQ(time(next), 2) << k;
                next = start(disk); // the power took what was counted
            }
            if (!next) continue; // lost at the last call: all is done
            EXPECT_FALSE(next->def) << k << ": at " << time(next) << " s of the old course";
            EXPECT_THAT(next->how.set_back, HasSubstr("it begins from its file")) << k;
        }
    }
}

TEST(SetBack, GoesNoFurtherBackThanAResetOfWhichTheDiskTookNothingAtFirst) {
    KeptAt kept(3100);
    World world(1);
    SimDisk disk(world);
    kept.copy_to(disk);
    const auto taken = start(disk);
    {
        KeptExercise again(kFolder, "anna", test::let_go_hash(), disk, [&world] { return world.time(); });
        LetGo let_go(taken->how);
        disk.refuses = true;
        let_go.look(&again);
        again.write_waiting();
        let_go.give(run::RunAction::reset);
        let_go.look(&again);
        disk.refuses = false;
        keep_up_to(600, again, let_go);
    }
    for (int loss = 0; loss < 2; ++loss)
        EXPECT_EQ(time(start(disk)), 2) << loss;
    EXPECT_FALSE(start(disk)->def) << "not to a checkpoint from before the reset";
}

TEST(SetBack, IsForLossesBehindTheLastCheckpointThoughTheDiskRefusedToForgetThoseBefore) {
    KeptAt kept(600);
    World world(1);
    SimDisk disk(world);
    kept.copy_to(disk);
    start(disk);
    const auto second = start(disk);
    {
        KeptExercise again(kFolder, "anna", test::let_go_hash(), disk, [&world] { return world.time(); });
        LetGo let_go(second->how);
        keep_up_to(2970, again, let_go);
        let_go.go_to(3001, &again);
        again.write_waiting();
        again.sync();
        disk.refuses = true;
        again.write_waiting();
    }
    disk.refuses = false;
    ASSERT_THAT(attempts_files(kFolder, disk), SizeIs(1));
    const auto third = start(disk);
    EXPECT_GE(time(third), 10);
    EXPECT_EQ(third->how.set_back, "");
}

TEST(SetBack, IsForNoServerThatEndedByItself) {
    KeptAt kept(600);
    World world(1);
    SimDisk disk(world);
    kept.copy_to(disk);
    for (int round = 0; round < 4; ++round) {
        const auto taken = start(disk);
        ASSERT_EQ(time(taken), 2) << round;
        KeptExercise again(kFolder, "anna", test::let_go_hash(), disk, [&world] { return world.time(); });
        LetGo let_go(taken->how);
        let_go.look(&again);
        std::thread closing([&] { again.close(false); });
        while (again.write_waiting()) {
        }
        closing.join();
    }
}

TEST(PutAside, StaysThereAfterAPowerCut) {
    KeptAt kept(400);
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        World world(seed);
        SimDisk disk(world);
        kept.copy_to(disk);
        const auto refused = start(disk, 1);
        ASSERT_TRUE(refused && !refused->def);
        disk.lose(Loss::power_cut);
        EXPECT_THAT(kept_files(kFolder, disk), IsEmpty()) << seed;
        EXPECT_THAT(kept_files(kAside / "anna-1", disk), SizeIs(1)) << seed;
    }
}

} // namespace
} // namespace windlass::keep
