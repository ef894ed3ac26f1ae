// A server that is several processes, one of which is lost: with real orders, over the wire. Times are
// printed, for docs/failures.md; they decide nothing.

#include "server/config/config.hpp"
#include "server/dds/order_taken.hpp"
#include "server/exercise/exercise.hpp"
#include "server/exercise/state_hash.hpp"
#include "server/keep/kept_exercise.hpp"

#include "tests/wire/keeping_server.hpp"
#include "tests/wire/run_program.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <functional>
#include <random>

namespace windlass::test {
namespace {

using testing::HasSubstr;

class ServerOfWorkers : public ServerThatKeeps {};

/// The process that keeps its exercises there.
pid_t holder_of(const std::filesystem::path& folder) {
    pid_t process = 0;
    std::ifstream(folder / "lock") >> process;
    return process;
}

TEST_F(ServerOfWorkers, LosesAWorkerAndHasItsExerciseBackWhileItsNeighbourRunsOn) {
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
    EXPECT_GT(kept_up_to, 2700U); // ticks of 9 s
    EXPECT_TRUE(eventually([&] {  // a topic of its own
        return witness_.status().run() > first_run && witness_.status().state() == RUN_PAUSED;
    }));
    EXPECT_THAT(server.text(), HasSubstr("worker 1 was killed by signal 9; it is started again"));

    const auto there = tick.load();
    EXPECT_TRUE(eventually([&] { return tick > there + 300; })) << "the neighbour runs on";
    EXPECT_EQ(runs, 1U) << "in the run that it was in";
    server.signal(SIGTERM);
    EXPECT_EQ(server.exit_code(), 0) << server.text();
    EXPECT_FALSE(std::filesystem::exists(keep / "exercise-default")) << "ended in order";
}

TEST_F(ServerOfWorkers, BeginsAnewWhenItIsAskedAndNoMomentIsLost) {
    ChildProcess server(server_command(
        folder_, 1,
        {"--partition", "default", "--exercise", kExercise, "--partition", "other", "--workers", "2"}));
    ChildProcess trainee(trainee_command());
    ASSERT_TRUE(eventually([&] { return witness_.status().time() >= 3; })) << server.text();
    std::uint64_t stands = 0;
    for (int round = 0; round < 4; ++round) { // three losses would set the exercise back
        ExerciseTruth last = witness_.truth();
        const auto run = last.run();
        server.signal(SIGUSR1);
        auto heard = Clock::now();
        ASSERT_TRUE(eventually([&] {
            const ExerciseTruth truth = witness_.truth();
            if (truth.run() == run && truth.tick() > last.tick()) heard = Clock::now();
            if (truth.run() == run) last = truth;
            return truth.run() > run;
        })) << server.text();
        if (round == 0) std::printf("away for %.2f s\n", seconds(Clock::now() - heard));
        EXPECT_GE(witness_.truth().tick(), last.tick());
        if (round > 0) {
            EXPECT_EQ(witness_.truth().tick(), stands) << "it stands paused";
        }
        stands = witness_.truth().tick();
        ASSERT_TRUE(eventually([&] { // both workers are through
            const std::string text = server.text();
            std::ptrdiff_t anew = 0;
            for (auto at = text.find("worker 2 begins anew"); at != std::string::npos;
                 at = text.find("worker 2 begins anew", at + 1))
                ++anew;
            return anew == round + 1;
        })) << server.text();
    }
    EXPECT_TRUE(eventually([&] { return witness_.status().state() == RUN_PAUSED; }));
    EXPECT_GE(stands, 900U);
    server.signal(SIGTERM);
    EXPECT_EQ(server.exit_code(), 0) << server.text();
}

TEST_F(ServerOfWorkers, BringsBackWhatWorkersKeptWhenAllOfItWasKilled) {
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
TEST_F(ServerOfWorkers, DISABLED_TwentyKillsOfAWorker) {
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
            keep::forget_attempts(keep / "exercise-default");
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

/// By how much ticks ended late (ms), the worst of each second of each exercise, as servers tell it.
class Lateness {
public:
    /// From now on it is of that phase; nothing: of none.
    void phase(const std::string& what) {
        const std::lock_guard lock(mutex_);
        phase_ = what;
    }
    void print() {
        const std::lock_guard lock(mutex_);
        for (auto& [what, late] : late_) {
            std::ranges::sort(late);
            const auto part = [&](double share) {
                return late[static_cast<std::size_t>(share * static_cast<double>(late.size() - 1))];
            };
            std::printf("%-70s half %5.2f ms, 99 %% %6.2f ms, all %7.2f ms (%zu seconds of an exercise)\n",
                        what.c_str(), part(0.5), part(0.99), part(1), late.size());
        }
    }

private:
    void hear(const ClassroomStatus& status) {
        const std::lock_guard lock(mutex_);
        if (phase_.empty()) return;
        const bool beside = status.server().to_string().ends_with("-1");
        for (const ClassroomExercise& each : status.exercises())
            if (each.id().to_string() != "s1")
                late_[phase_ + (beside ? ": fifteen in its worker" : ": forty-eight in other workers")]
                    .push_back(1e3 * each.lateness());
    }

    std::mutex mutex_;
    std::string phase_;
    std::map<std::string, std::vector<double>> late_;
    wire::Participant participant_{{own_domain(), wire::kClassroomPartition, "witness"}};
    wire::Reader<ClassroomStatus> reader_{participant_, topics::classroom_status,
                                          [this](const ClassroomStatus& s) { hear(s); }};
};

// Prints what 64 exercises in four workers feel of what becomes of one of them, or of its worker, by turns
// with rounds in which nothing happens: docs/failures.md. Under SCHED_FIFO, so that other work on the machine
// is not what is measured.
TEST_F(ServerOfWorkers, DISABLED_PrintNeighbours) {
    std::vector<std::string> command{WINDLASS_SERVER,
                                     "--workers",
                                     "4",
                                     "--name",
                                     "room",
                                     "--keep",
                                     (folder_ / "keep").string(),
                                     "--resume-running",
                                     "--realtime",
                                     "--domain",
                                     std::to_string(own_domain())};
    for (int k = 1; k <= 64; ++k)
        command.insert(command.end(), {"--partition", "s" + std::to_string(k)});
    Lateness late;
    ChildProcess server(command);
    // Losses within 10 s of the exercise are what a server gives up at; here they are meant.
    const auto lose = [&](int signal) {
        const auto keep = folder_ / "keep" / "worker-1";
        for (int k = 1; k <= 64; k += 4)
            keep::forget_attempts(keep / ("exercise-s" + std::to_string(k)));
        kill(holder_of(keep), signal);
    };
    const auto say = [](const std::string& what) {
        return run(INSTRUCTOR_CONSOLE + what + " --domain " + std::to_string(own_domain())).text;
    };
    ASSERT_TRUE(eventually([&] { return say(" classroom list").find("room-4") != std::string::npos; }))
        << server.text();
    pace(std::chrono::seconds(20));
    const auto phase = [&](const std::string& what, const std::function<void(int second)>& each_second) {
        for (int second = 0; second < 23; ++second) {
            each_second(second);
            if (second == 3) late.phase(what); // of what it was before, in the first seconds
            pace(std::chrono::seconds(1));
        }
        late.phase("");
    };
    for (int round = 0; round < 2; ++round) {
        phase("nothing happens", [](int) {});
        phase("its worker is killed every 5 s", [&](int second) {
            if (second % 5 == 4) lose(SIGKILL);
        });
        pace(std::chrono::seconds(12)); // is settled again
        phase("nothing happens", [](int) {});
        phase("its worker hangs, and is killed after 10 s", [&](int second) {
            if (second == 4) lose(SIGSTOP);
        });
        pace(std::chrono::seconds(12));
        phase("nothing happens", [](int) {});
        phase("it goes at x20", [&](int second) {
            if (second == 0) say(" time-scale 20 --timeout 20 --partition s1");
        });
        say(" time-scale 1 --timeout 20 --partition s1");
    }
    late.print();
    server.signal(SIGTERM);
    EXPECT_EQ(server.exit_code(), 0);
}

} // namespace
} // namespace windlass::test
