// Keeping on a simulated disk (sim/), which may be slow and lose its power at any call.

#include "sim/disk.hpp"
#include "tests/keep/let_go.hpp"

#include <gmock/gmock.h>

namespace windlass::keep {
namespace {

using sim::SimDisk;
using sim::World;
using test::LetGo;
using testing::IsEmpty;

const std::filesystem::path kFolder = "/kept/exercise-anna", kAside = "/kept/aside";

/// A server runs the let-go up to that tick.
void keep_up_to(std::uint64_t tick, KeptExercise& kept, LetGo& let_go) {
    let_go.look(&kept);
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

} // namespace
} // namespace windlass::keep
