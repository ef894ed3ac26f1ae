// A server that is killed, and what comes of its exercise.

#include "rigs/wait.hpp"
#include "tests/keep/let_go.hpp"
#include "tests/recorder/folder.hpp"

#include <gmock/gmock.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace windlass::keep {
namespace {

using test::LetGo;

constexpr const char* kId = "anna";

/// A process that runs the let-go at that scale and keeps it, until it is killed; stands still at that tick.
class KeepingProcess {
public:
    KeepingProcess(const std::filesystem::path& folder, double scale, std::uint64_t stand_at) {
        if (pipe(pipe_) != 0) throw std::runtime_error("no pipe");
        pid_ = fork();
        if (pid_ == 0) run(folder, scale, stand_at);
        close(pipe_[1]);
    }
    ~KeepingProcess() {
        kill_9();
        close(pipe_[0]);
    }
    KeepingProcess(const KeepingProcess&) = delete;
    KeepingProcess& operator=(const KeepingProcess&) = delete;

    /// Waits until the exercise has come to that tick.
    void wait_for(std::uint64_t tick) {
        while (tick_ < tick && read(pipe_[0], &tick_, sizeof tick_) == sizeof tick_) {
        }
    }
    void kill_9() {
        if (pid_ <= 0) return;
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
        pid_ = 0;
        std::uint64_t tick = 0;
        while (read(pipe_[0], &tick, sizeof tick) == sizeof tick)
            tick_ = tick;
    }
    std::uint64_t tick() const { return tick_; } ///< the last that it told

private:
    [[noreturn]] void run(const std::filesystem::path& folder, double scale, std::uint64_t stand_at) const {
        Keeper keeper(folder);
        const auto kept = keeper.keep(kId, test::let_go_hash());
        LetGo exercise;
        exercise.look(kept.get());
        const auto begin = std::chrono::steady_clock::now();
        for (;;) {
            const std::uint64_t tick = exercise.session().now_tick();
            if (tick == stand_at) exercise.give(run::RunAction::pause);
            const double due = static_cast<double>(tick) / (300 * scale);
            std::this_thread::sleep_until(begin + std::chrono::duration<double>(due));
            exercise.go_to(tick + 1, kept.get());
            if (tick == stand_at) exercise.look(kept.get());
            if (tick != stand_at && write(pipe_[1], &tick, sizeof tick) < 0) _exit(1);
        }
    }

    int pipe_[2] = {-1, -1};
    pid_t pid_ = -1;
    std::uint64_t tick_ = 0;
};

/// The last tick that stands in the exercise's files.
std::uint64_t kept_tick(const std::filesystem::path& folder) {
    const auto files = kept_files(folder / (std::string("exercise-") + kId));
    if (files.empty()) return 0;
    std::uint64_t tick = 0;
    const KeptContents contents(files.back());
    for (const auto& [kind, at, payload] : contents.entries())
        if (kind == Record::reached || kind == Record::checkpoint)
            std::memcpy(&tick, payload.data() + 4, sizeof tick);
    return tick;
}

const TakeUp kByItsFile{.definition_hash = test::let_go_hash(), .check = {}};

struct Kill {
    double scale;
    std::uint64_t tick;
};

class KilledServer : public testing::TestWithParam<Kill> {};

// At rest on the brake, as the cable runs out, behind a fault, across the first checkpoint and behind it.
INSTANTIATE_TEST_SUITE_P(InALetGo, KilledServer,
                         testing::Values(Kill{1, 45}, Kill{1, 200}, Kill{1, 450}, Kill{8, 700}, Kill{8, 2990},
                                         Kill{8, 3600}),
                         [](const auto& info) {
                             return "AtX" + std::to_string(static_cast<int>(info.param.scale)) + "Tick" +
                                    std::to_string(info.param.tick);
                         });

TEST_P(KilledServer, TakesItsExerciseUpAndItGoesOnAsIfNothingHadHappened) {
    const windlass::test::Folder folder;
    KeepingProcess server(folder.path(), GetParam().scale, UINT64_MAX);
    server.wait_for(GetParam().tick);
    const std::uint64_t on_disk = kept_tick(folder.path());
    server.kill_9();

    Keeper keeper(folder.path());
    EXPECT_THAT(keeper.kept(), testing::ElementsAre(kId));
    const auto taken = keeper.take_up(kId, kByItsFile);
    ASSERT_TRUE(taken && taken->def);
    EXPECT_EQ(taken->how.refused, "");
    LetGo again(taken->how);
    run::Session& session = again.session();
    const std::uint64_t stopped = session.now_tick();
    std::printf("killed at tick %lu or later, %lu of it on the disk; taken up at %lu\n", server.tick(),
                on_disk, stopped);
    EXPECT_GE(stopped, on_disk);
    EXPECT_EQ(session.status().state, exercise::RunState::paused);

    LetGo undisturbed;
    undisturbed.go_to(stopped);
    const std::uint64_t before = undisturbed.session().snapshot().state_hash;
    const bool ordered = before != session.snapshot().state_hash; // the order of that tick was kept as well
    if (ordered) {
        undisturbed.order();
        ASSERT_EQ(undisturbed.hash(), session.snapshot().state_hash);
    }
    again.give(run::RunAction::start);
    if (ordered) {
        session.tick();
        undisturbed.session().tick();
    }
    again.go_to(stopped + 600);
    undisturbed.go_to(stopped + 600);
    EXPECT_EQ(again.hash(), undisturbed.hash());
    EXPECT_EQ(session.now_tick(), stopped + 600);
}

TEST(KilledServerThatStoodStill, TakesItsExerciseUpAtTheVeryTickWithTheOrdersOfThatTick) {
    const windlass::test::Folder folder;
    KeepingProcess server(folder.path(), 8, 630);
    // Once the disk has it, nothing of it is lost however the server ends.
    ASSERT_TRUE(rigs::eventually([&] { return kept_tick(folder.path()) == 630; }));
    server.kill_9();
    Keeper keeper(folder.path());
    const auto taken = keeper.take_up(kId, kByItsFile);
    ASSERT_TRUE(taken && taken->def) << (taken ? taken->how.refused : "nothing is kept");
    LetGo again(taken->how), undisturbed;
    undisturbed.go_to(630);
    EXPECT_EQ(again.session().now_tick(), 630U);
    EXPECT_EQ(again.session().snapshot().state_hash, undisturbed.session().snapshot().state_hash);
}

} // namespace
} // namespace windlass::keep
