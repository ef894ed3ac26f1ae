// A server that keeps its exercise is killed in a let-go and started again: with real orders of a trainee,
// over the wire. Times are printed, for docs/failures.md; they decide nothing.

#include "server/config/config.hpp"
#include "server/dds/order_taken.hpp"
#include "server/exercise/exercise.hpp"
#include "server/exercise/state_hash.hpp"
#include "server/keep/kept_exercise.hpp"

#include "idl/payload.hpp"
#include "tests/wire/keeping_server.hpp"
#include "tests/wire/run_program.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>

namespace windlass::test {
namespace {

using testing::HasSubstr;

/// What stands in the files of the killed server, by their payloads alone.
struct OnDisk {
    std::map<std::uint64_t, run::OrderView> orders; // by number
    std::uint64_t tick = 0;                         // reached

    /// keep: the folder of its server, or of its worker.
    explicit OnDisk(const std::filesystem::path& keep) {
        for (const auto& file : keep::kept_files(keep / "exercise-default")) {
            const keep::KeptContents contents(file);
            for (const auto& [kind, at, payload] : contents.entries()) {
                if (kind == keep::Record::order) {
                    const auto order = dds::order_view(wire::decode<OrderTaken>(payload));
                    orders[order.number] = order;
                    tick = std::max(tick, order.tick);
                } else if (kind == keep::Record::reached) {
                    tick = std::max<std::uint64_t>(tick, wire::decode<Checkpoint>(payload).tick());
                }
            }
        }
    }

    /// Of an exercise that nothing has disturbed, with the same orders.
    std::uint64_t undisturbed_hash() const {
        exercise::Exercise exercise(config::load_exercise(kExercise));
        auto next = orders.begin();
        for (;;) {
            for (; next != orders.end() && next->second.tick == exercise.tick(); ++next)
                exercise.apply(next->second.command);
            if (exercise.tick() == tick) break;
            exercise.step(1.0 / exercise.def().tick_rate_hz);
        }
        exercise::StateHash hash;
        exercise.visit_state(hash);
        return hash.value();
    }
};

struct Kill {
    double scale, time; ///< time: s of exercise, before 20: all orders are in the files then
};

class KilledServerThatKeeps : public ServerThatKeeps, public testing::WithParamInterface<Kill> {};

// As the cable runs out, and behind the first checkpoint.
INSTANTIATE_TEST_SUITE_P(InALetGo, KilledServerThatKeeps,
                         testing::Values(Kill{1, 9.5}, Kill{1, 12}, Kill{8, 9.5}, Kill{8, 14}),
                         [](const auto& info) {
                             return "AtX" + std::to_string(static_cast<int>(info.param.scale)) + "Time" +
                                    std::to_string(static_cast<int>(info.param.time));
                         });

TEST_P(KilledServerThatKeeps, TakesItsExerciseUpAtTheTickAtWhichItStopped) {
    auto server = std::make_unique<ChildProcess>(server_command(folder_, GetParam().scale));
    {
        ChildProcess trainee(trainee_command());
        ASSERT_TRUE(eventually([&] { return witness_.status().time() >= GetParam().time; }))
            << server->text() << trainee.text();
        kill_9(*server);
        kill_9(trainee);
    }
    const OnDisk kept(folder_ / "keep");
    EXPECT_GT(kept.orders.size(), 0U);
    std::printf("last heard at tick %lu, kept up to %lu\n", witness_.status().tick(), kept.tick);

    const auto first_run = witness_.status().run();
    const auto begin = Clock::now();
    server = std::make_unique<ChildProcess>(server_command(folder_, GetParam().scale));
    ASSERT_TRUE(eventually([&] { return witness_.truth().run() > first_run && witness_.load_at() > begin; }))
        << server->text();
    EXPECT_EQ(witness_.truth().tick(), kept.tick);
    EXPECT_EQ(witness_.truth().state_hash(), kept.undisturbed_hash());
    EXPECT_TRUE(eventually([&] { return witness_.status().state() == RUN_PAUSED; }));
    EXPECT_TRUE(eventually([&] { return !witness_.told("exercise.taken_up").empty(); }));
    EXPECT_THAT(witness_.told("exercise.taken_up"), HasSubstr("taken up again at 0:"));

    EXPECT_EQ(run(INSTRUCTOR_CONSOLE " start --domain " + std::to_string(own_domain())).code, 0);
    EXPECT_TRUE(eventually([&] { return witness_.status().tick() > kept.tick; }));
    server->signal(SIGTERM);
    EXPECT_EQ(server->exit_code(), 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "keep" / "exercise-default")) << "ended in order";
}

TEST_F(ServerThatKeeps, HasTheFolderToItself) {
    const ChildProcess first(server_command(folder_, 1));
    ASSERT_TRUE(eventually([&] { return witness_.status().tick() > 0; })) << first.text();
    ChildProcess second(server_command(folder_, 1));
    EXPECT_EQ(second.exit_code(), 6);
    EXPECT_THAT(second.text(),
                HasSubstr("process " + std::to_string(first.pid()) + " keeps its exercises here"));
}

TEST_F(ServerThatKeeps, BringsBackWhatInstructorsHadCreatedWhenItWasKilled) {
    const std::string domain = " --domain " + std::to_string(own_domain());
    const std::vector<std::string> command{
        WINDLASS_SERVER, "--classroom",          "--keep",   (folder_ / "keep").string(),
        "--config-root", WINDLASS_CONFIG_DIR,    "--domain", std::to_string(own_domain()),
        "--fault-dir",   folder_.path().string()};
    auto server = std::make_unique<ChildProcess>(command);
    for (const char* id : {"anna", "ben"})
        ASSERT_EQ(run(std::string(INSTRUCTOR_CONSOLE " classroom create ") + id +
                      " --exercise let_go_port_25m" + domain)
                      .code,
                  0)
            << server->text();
    const auto on_disk = [&](const char* id) {
        return !keep::kept_files(folder_ / "keep" / (std::string("exercise-") + id)).empty();
    };
    ASSERT_TRUE(eventually([&] { return on_disk("anna") && on_disk("ben"); }));
    kill_9(*server);
    server = std::make_unique<ChildProcess>(command);
    ASSERT_TRUE(eventually([&] {
        const auto list = run(INSTRUCTOR_CONSOLE " classroom list" + domain).text;
        return list.find("anna") != std::string::npos && list.find("ben") != std::string::npos &&
               list.find("paused") != std::string::npos;
    })) << server->text();
}

/// Ticks are counted, not timed: with a tick that waits for its disk the exercise would stand still.
TEST_F(ServerThatKeeps, GoesOnTickByTickWhileItsDiskTakesNothing) {
    const auto command = server_command(folder_, 8);
    std::vector<std::string> held{"/usr/bin/env", "LD_PRELOAD=" WINDLASS_HELD_DISK,
                                  "WINDLASS_HELD=" + folder_.path().string()};
    held.insert(held.end(), command.begin(), command.end());
    auto server = std::make_unique<ChildProcess>(held);
    const ChildProcess trainee(trainee_command());
    const auto kept = [&] { return !keep::kept_files(folder_ / "keep" / "exercise-default").empty(); };
    ASSERT_TRUE(eventually([&] { return kept() && witness_.status().time() > 1; })) << server->text();

    std::ofstream(folder_ / "hold").close();
    const auto from = witness_.status().tick();
    ASSERT_TRUE(eventually([&] { return !witness_.told("exercise.not_kept").empty(); })) << server->text();
    EXPECT_THAT(witness_.told("exercise.not_kept"), HasSubstr("does not come to the disk within 3 s"));
    ASSERT_TRUE(eventually([&] { return witness_.status().tick() > from + 9000; }));
    EXPECT_EQ(witness_.told("exercise.kept"), "") << "the disk has been held throughout";

    std::filesystem::remove(folder_ / "hold");
    EXPECT_TRUE(eventually([&] { return !witness_.told("exercise.kept").empty(); }));
    kill_9(*server);
    const auto run = witness_.status().run();
    server = std::make_unique<ChildProcess>(command);
    ASSERT_TRUE(eventually([&] { return witness_.truth().run() > run; })) << server->text();
    EXPECT_GT(witness_.truth().tick(), from + 9000);
}

TEST_F(ServerThatKeeps, DISABLED_PrintTimes) {
    std::vector<double> heard, standing;
    auto server = std::make_unique<ChildProcess>(server_command(folder_, 1));
    const ChildProcess trainee(trainee_command());
    for (int round = 0; round < 10; ++round) {
        const double from = witness_.status().time();
        ASSERT_TRUE(eventually([&] { return witness_.status().time() > from + 5; })) << server->text();
        kill_9(*server);
        // Ten kills within the first seconds are what a server gives up at; here they are meant.
        keep::forget_attempts(folder_ / "keep" / "exercise-default");
        const OnDisk kept(folder_ / "keep");
        standing.push_back(static_cast<double>(witness_.status().tick()) - static_cast<double>(kept.tick));
        const auto begin = Clock::now();
        server = std::make_unique<ChildProcess>(server_command(folder_, 1, {"--resume-running"}));
        ASSERT_TRUE(eventually([&] { return witness_.load_at() > begin; })) << server->text();
        heard.push_back(seconds(witness_.load_at() - begin));
    }
    std::ranges::sort(heard);
    std::ranges::sort(standing);
    std::printf("first load after the restart: median %.2f s, worst %.2f s\n", heard[5], heard[9]);
    std::printf("ticks that were heard and not kept: median %.0f, worst %.0f\n", standing[5], standing[9]);
}

/// What a process has used and written.
struct Used {
    double processor = 0; // s
    double keeping = 0;   // s of it, by the threads that keep
    double written = 0;   // bytes, to files
    double to_disk = 0;   // bytes

    explicit Used(pid_t pid) {
        const std::string folder = "/proc/" + std::to_string(pid);
        for (const auto& task : std::filesystem::directory_iterator(folder + "/task")) {
            double ns = 0;
            std::ifstream(task.path() / "schedstat") >> ns;
            processor += 1e-9 * ns;
            std::string name;
            std::ifstream(task.path() / "comm") >> name;
            if (name.starts_with("keep")) keeping += 1e-9 * ns;
        }
        std::ifstream io(folder + "/io");
        std::string name;
        for (double bytes = 0; io >> name >> bytes;) {
            if (name == "wchar:") written = bytes;
            if (name == "write_bytes:") to_disk = bytes;
        }
    }
};

// A trainee works the first of them; the others lie with nobody at their levers.
TEST_F(ServerThatKeeps, DISABLED_PrintCost) {
    constexpr double kMeasured = 30; // s
    for (const int exercises : {1, 32}) {
        for (const bool keeps : {false, true}) {
            std::vector<std::string> command{WINDLASS_SERVER, "--domain", std::to_string(own_domain())};
            for (int i = 0; i < exercises; ++i)
                command.insert(command.end(), {"--exercise", kExercise, "--partition",
                                               i == 0 ? "default" : "other-" + std::to_string(i)});
            if (keeps) command.insert(command.end(), {"--keep", (folder_ / "keep").string()});
            const auto before = witness_.status().run();
            ChildProcess server(command);
            const ChildProcess trainee(trainee_command());
            ASSERT_TRUE(
                eventually([&] { return witness_.status().run() > before && witness_.status().time() > 5; }));
            const Used from(server.pid());
            const auto began = Clock::now();
            pace(std::chrono::seconds(static_cast<int>(kMeasured)));
            const Used until(server.pid());
            const double time = seconds(Clock::now() - began);
            std::printf(
                "%2d exercises, %s: %.2f %% of a core, %.2f of it to keep, written %.1f kB/s, to the disk "
                "%.1f kB/s\n",
                exercises, keeps ? "kept    " : "not kept", 100 * (until.processor - from.processor) / time,
                100 * (until.keeping - from.keeping) / time, 1e-3 * (until.written - from.written) / time,
                1e-3 * (until.to_disk - from.to_disk) / time);
            server.signal(SIGTERM);
            EXPECT_EQ(server.exit_code(), 0);
        }
    }
}

} // namespace
} // namespace windlass::test
