// A server that keeps its exercise is killed in a let-go and started again: with real orders of a trainee,
// over the wire. Times are printed, for docs/failures.md; they decide nothing.

#include "server/config/config.hpp"
#include "server/dds/order_taken.hpp"
#include "server/exercise/exercise.hpp"
#include "server/exercise/state_hash.hpp"
#include "server/keep/kept_exercise.hpp"

#include "idl/payload.hpp"
#include "idl/wire.hpp"
#include "rigs/server_process.hpp"
#include "tests/recorder/folder.hpp"
#include "tests/wire/run_program.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <map>
#include <mutex>
#include <random>

namespace windlass::test {
using namespace rigs;

namespace {

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;
namespace topics = wire::topics;

const char* const kExercise = WINDLASS_CONFIG_DIR "/exercises/let_go_port_25m.json";

double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

std::vector<std::string> server_command(const Folder& folder, double scale,
                                        std::vector<std::string> more = {}) {
    std::vector<std::string> command{WINDLASS_SERVER,
                                     "--exercise",
                                     kExercise,
                                     "--time-scale",
                                     std::to_string(scale),
                                     "--keep",
                                     (folder / "keep").string(),
                                     "--fault-dir",
                                     folder.path().string(),
                                     "--domain",
                                     std::to_string(own_domain())};
    command.insert(command.end(), more.begin(), more.end());
    return command;
}

std::vector<std::string> trainee_command() {
    return {TRAINEE_CLIENT, "--name",
            "trainee",      "--view",
            "line",         "--coach",
            "--script",     WINDLASS_CONFIG_DIR "/scripts/let_go_port_25m.json",
            "--domain",     std::to_string(own_domain())};
}

/// Hears what the server says, from a process that is not killed.
class Witness {
public:
    ExerciseTruth truth() const {
        const std::lock_guard lock(mutex_);
        return truth_;
    }
    ExerciseStatus status() const {
        const std::lock_guard lock(mutex_);
        return status_;
    }
    WindlassLoad load() const {
        const std::lock_guard lock(mutex_);
        return load_;
    }
    std::string told(const std::string& code) const {
        const std::lock_guard lock(mutex_);
        const auto found = told_.find(code);
        return found == told_.end() ? "" : found->second;
    }
    Clock::time_point load_at() const {
        const std::lock_guard lock(mutex_);
        return load_at_;
    }

private:
    mutable std::mutex mutex_;
    ExerciseTruth truth_;
    ExerciseStatus status_;
    WindlassLoad load_;
    Clock::time_point load_at_{};
    std::map<std::string, std::string> told_; // by code, the last
    wire::Participant participant_{{own_domain(), "exercise/default", "witness"}};
    wire::Reader<ExerciseTruth> truths_{participant_, topics::exercise_truth, [this](const ExerciseTruth& s) {
                                            const std::lock_guard lock(mutex_);
                                            truth_ = s;
                                        }};
    wire::Reader<ExerciseStatus> statuses_{participant_, topics::exercise_status,
                                           [this](const ExerciseStatus& s) {
                                               const std::lock_guard lock(mutex_);
                                               status_ = s;
                                           }};
    wire::Reader<WindlassLoad> loads_{participant_, topics::windlass_load, [this](const WindlassLoad& s) {
                                          const std::lock_guard lock(mutex_);
                                          load_ = s;
                                          load_at_ = Clock::now();
                                      }};
    wire::Reader<Event> events_{participant_, topics::event, [this](const Event& e) {
                                    const std::lock_guard lock(mutex_);
                                    told_[e.code().to_string()] = e.text().to_string();
                                }};
};

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

class ServerThatKeeps : public testing::Test {
protected:
    static void kill_9(ChildProcess& process) {
        process.signal(SIGKILL);
        EXPECT_EQ(process.exit_code(), -1);
    }
    Folder folder_;
    Witness witness_;
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

/// The process that keeps its exercises there.
pid_t holder_of(const std::filesystem::path& folder) {
    pid_t process = 0;
    std::ifstream(folder / "lock") >> process;
    return process;
}

TEST_F(ServerThatKeeps, LosesAWorkerAndHasItsExerciseBackWhileItsNeighbourRunsOn) {
    auto command = server_command(
        folder_, 1,
        {"--partition", "default", "--exercise", kExercise, "--partition", "other", "--workers", "2"});
    ChildProcess server(command);
    ChildProcess trainee(trainee_command());
    wire::Participant participant({own_domain(), "exercise/other", "neighbour"});
    std::atomic<std::uint64_t> run = 0, tick = 0, runs = 0;
    const wire::Reader<ExerciseStatus> neighbour(participant, topics::exercise_status,
                                                 [&](const ExerciseStatus& status) {
                                                     if (run.exchange(status.run()) != status.run()) ++runs;
                                                     tick = status.tick();
                                                 });
    ASSERT_TRUE(eventually([&] { return witness_.status().time() >= 9.5 && tick > 0; }))
        << server.text() << trainee.text();
    const auto keep = folder_ / "keep" / "worker-1";
    const auto first_run = witness_.status().run();
    ASSERT_EQ(kill(holder_of(keep), SIGKILL), 0);
    const auto begin = Clock::now();
    ASSERT_TRUE(eventually([&] { return witness_.truth().run() > first_run; })) << server.text();
    std::printf("first truth %.2f s after the worker was killed\n", seconds(Clock::now() - begin));
    EXPECT_TRUE(eventually([&] { return !witness_.told("exercise.taken_up").empty(); }));
    const auto kept_up_to = witness_.truth().tick();
    EXPECT_GT(kept_up_to, 9 * 300U); // 300 ticks a second
    EXPECT_EQ(witness_.status().state(), RUN_PAUSED);
    EXPECT_THAT(server.text(), HasSubstr("worker 1 was killed by signal 9; it is started again"));

    const auto there = tick.load();
    EXPECT_TRUE(eventually([&] { return tick > there + 300; })) << "the neighbour runs on";
    EXPECT_EQ(runs, 1U) << "in the run that it was in";
    server.signal(SIGTERM);
    EXPECT_EQ(server.exit_code(), 0) << server.text();
    EXPECT_FALSE(std::filesystem::exists(keep / "exercise-default")) << "ended in order";
}

TEST_F(ServerThatKeeps, BringsBackWhatWorkersKeptWhenAllOfItWasKilled) {
    const std::vector<std::string> both{"--partition", "default",     "--exercise",
                                        kExercise,     "--partition", "other"};
    auto more = both;
    more.insert(more.end(), {"--workers", "2"});
    auto server = std::make_unique<ChildProcess>(server_command(folder_, 1, more));
    ASSERT_TRUE(eventually([&] { return witness_.status().time() >= 2; })) << server->text();
    const auto keep = folder_ / "keep";
    const std::vector<pid_t> workers{holder_of(keep / "worker-1"), holder_of(keep / "worker-2")};
    kill_9(*server);
    EXPECT_TRUE(eventually([&] { // they go with it, and leave their folders
        return std::ranges::all_of(workers, [](pid_t worker) { return kill(worker, 0) != 0; });
    }));
    const auto first_run = witness_.status().run();
    server = std::make_unique<ChildProcess>(server_command(folder_, 1, both)); // one process now
    ASSERT_TRUE(eventually([&] { return witness_.status().run() > first_run; })) << server->text();
    EXPECT_TRUE(eventually([&] { return witness_.status().state() == RUN_PAUSED; }));
    EXPECT_GE(witness_.status().time(), 1.5);
    server->signal(SIGTERM);
    EXPECT_EQ(server->exit_code(), 0);
}

/// Every order that a server took, as anybody hears it, but for those that were lost with it.
class OrdersHeard {
public:
    /// State hashes that an exercise nobody has disturbed comes to at that tick with these orders: with those
    /// of the tick itself, and without. What was taken later in that run has not happened, and is forgotten.
    std::vector<std::uint64_t> undisturbed(std::uint64_t run, std::uint64_t tick) {
        const std::lock_guard lock(mutex_);
        std::erase_if(orders_,
                      [&](const auto& each) { return each.first.first == run && each.second.tick > tick; });
        std::vector<std::uint64_t> hashes;
        for (const bool of_the_tick : {true, false}) {
            exercise::Exercise exercise(config::load_exercise(kExercise));
            auto next = orders_.begin();
            for (;;) {
                for (; next != orders_.end() && next->second.tick == exercise.tick() &&
                       (of_the_tick || next->second.tick < tick);
                     ++next)
                    exercise.apply(next->second.command);
                if (exercise.tick() == tick) break;
                exercise.step(1.0 / exercise.def().tick_rate_hz);
            }
            exercise::StateHash hash;
            exercise.visit_state(hash);
            hashes.push_back(hash.value());
        }
        return hashes;
    }

private:
    std::mutex mutex_;
    std::map<std::pair<std::uint64_t, std::uint64_t>, run::OrderView> orders_; // by run and number
    wire::Participant participant_{{own_domain(), "exercise/default", "auditor"}};
    wire::Reader<OrderTaken> reader_{participant_, topics::order_taken, [this](const OrderTaken& sample) {
                                         const std::lock_guard lock(mutex_);
                                         orders_[{sample.run(), sample.number()}] = dds::order_view(sample);
                                     }};
};

/// Drill, for ./check --long: the worker that has the exercise is killed at random instants of a let-go, ten
/// at x1 and ten at x8; each time its state is that of an exercise that nobody has disturbed, with the same
/// orders.
TEST_F(ServerThatKeeps, DISABLED_TwentyKillsOfAWorker) {
    std::mt19937 random(20261126);
    for (const double scale : {1.0, 8.0}) {
        OrdersHeard heard;
        std::vector<double> back;
        const auto keep = folder_ / "keep" / "worker-1";
        ChildProcess server(server_command(folder_, scale, {"--workers", "1"}));
        for (int kill_number = 0; kill_number < 10; ++kill_number) {
            const ChildProcess trainee(trainee_command());
            const double from = witness_.status().time(),
                         wait = 0.5 + 4e-3 * scale * static_cast<double>(random() % 1000);
            ASSERT_TRUE(eventually([&] { return witness_.status().time() > from + wait; })) << server.text();
            const auto run = witness_.status().run();
            // Kills within 10 s of the exercise are what a server gives up at; here they are meant.
            std::filesystem::remove(keep::attempts_file(keep / "exercise-default"));
            ASSERT_EQ(kill(holder_of(keep), SIGKILL), 0);
            const auto begin = Clock::now();
            ASSERT_TRUE(eventually([&] {
                return witness_.truth().run() > run && witness_.load_at() > begin;
            })) << server.text();
            back.push_back(seconds(witness_.load_at() - begin));
            const ExerciseTruth truth = witness_.truth();
            EXPECT_THAT(heard.undisturbed(run, truth.tick()), testing::Contains(truth.state_hash()))
                << "x" << scale << ", kill " << kill_number << ", tick " << truth.tick();
            ASSERT_TRUE(eventually([&] { return witness_.status().state() == RUN_PAUSED; }));
            EXPECT_EQ(
                test::run(INSTRUCTOR_CONSOLE " start --timeout 20 --domain " + std::to_string(own_domain()))
                    .code,
                0);
        }
        std::ranges::sort(back);
        std::printf("x%.0f: first load after the kill: median %.2f s, worst %.2f s\n", scale, back[5],
                    back[9]);
        server.signal(SIGTERM);
        EXPECT_EQ(server.exit_code(), 0);
    }
}

/// By how much ticks ended late, the worst of each second of each exercise of the workers but the first, as
/// servers tell it.
class Lateness {
public:
    void begin() {
        const std::lock_guard lock(mutex_);
        late_.clear();
    }
    void print(const char* what) {
        const std::lock_guard lock(mutex_);
        std::ranges::sort(late_);
        const auto part = [&](double share) {
            return late_.empty()
                       ? -1
                       : 1e3 * late_[static_cast<std::size_t>(share * static_cast<double>(late_.size() - 1))];
        };
        std::printf("%-44s half %5.2f ms, 99 %% %6.2f ms, all %7.2f ms (%zu seconds of an exercise)\n", what,
                    part(0.5), part(0.99), part(1), late_.size());
    }

private:
    std::mutex mutex_;
    std::vector<double> late_; // s
    wire::Participant participant_{{own_domain(), wire::kClassroomPartition, "witness"}};
    wire::Reader<ClassroomStatus> reader_{participant_, topics::classroom_status,
                                          [this](const ClassroomStatus& s) {
                                              if (s.server().to_string().ends_with("-1")) return;
                                              const std::lock_guard lock(mutex_);
                                              for (const ClassroomExercise& each : s.exercises())
                                                  late_.push_back(each.lateness());
                                          }};
};

// Prints what 48 exercises of three workers feel of what becomes of the fourth, with 16: docs/failures.md.
TEST_F(ServerThatKeeps, DISABLED_PrintNeighbours) {
    std::vector<std::string> command{WINDLASS_SERVER,
                                     "--workers",
                                     "4",
                                     "--name",
                                     "room",
                                     "--keep",
                                     (folder_ / "keep").string(),
                                     "--domain",
                                     std::to_string(own_domain())};
    for (int k = 1; k <= 64; ++k)
        command.insert(command.end(), {"--partition", "s" + std::to_string(k)});
    Lateness others;
    ChildProcess server(command);
    const auto worker = [&] { return holder_of(folder_ / "keep" / "worker-1"); };
    ASSERT_TRUE(eventually([&] {
        return run(INSTRUCTOR_CONSOLE " classroom list --domain " + std::to_string(own_domain()))
                   .text.find("room-4") != std::string::npos;
    })) << server.text();
    pace(std::chrono::seconds(20));
    const auto phase = [&](const char* what, const std::function<void(int second)>& each_second) {
        others.begin();
        for (int second = 0; second < 30; ++second) {
            each_second(second);
            pace(std::chrono::seconds(1));
        }
        others.print(what);
    };
    phase("nothing happens", [](int) {});
    phase("a worker is killed every 5 s", [&](int second) {
        if (second % 5 == 0) kill(worker(), SIGKILL);
    });
    pace(std::chrono::seconds(5));
    phase("a worker hangs, and is killed after 10 s", [&](int second) {
        if (second == 0) kill(worker(), SIGSTOP);
    });
    pace(std::chrono::seconds(5));
    phase("its sixteen exercises go at x20", [&](int second) {
        if (second > 0) return;
        for (int k = 1; k <= 64; k += 4)
            for (const char* order : {" start", " time-scale 20"})
                run(std::string(INSTRUCTOR_CONSOLE) + order + " --timeout 20 --partition s" +
                    std::to_string(k) + " --domain " + std::to_string(own_domain()));
    });
    server.signal(SIGTERM);
    EXPECT_EQ(server.exit_code(), 0);
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
        std::filesystem::remove(keep::attempts_file(folder_ / "keep" / "exercise-default"));
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
