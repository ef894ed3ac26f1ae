// kill -9 of each process in turn during a let-go: what the others do, how the killed one comes back, and
// what is left of what was recorded. Times are printed, for docs/failures.md; they decide nothing.

#include "recorder/recording/typed.hpp"
#include "tests/wire/recorder_rig.hpp"

#include "idl/wire.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <set>

namespace windlass::test {
using namespace rigs;

namespace {

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;
namespace topics = wire::topics;

double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

std::vector<std::string> member(std::vector<std::string> command) {
    command.insert(command.end(), {"--domain", std::to_string(own_domain())});
    return command;
}

std::vector<std::string> server_command() {
    return member({WINDLASS_SERVER, "--exercise", WINDLASS_CONFIG_DIR "/exercises/let_go_port_25m.json"});
}

std::vector<std::string> trainee_command() {
    const std::string script = WINDLASS_CONFIG_DIR "/scripts/let_go_port_25m.json";
    return member({TRAINEE_CLIENT, "--name", "trainee", "--view", "line", "--coach", "--script", script});
}

std::vector<std::string> console_command() {
    return member({INSTRUCTOR_CONSOLE, "watch"});
}

/// Hears what the server says, from a process that is not killed.
class Witness {
public:
    struct Heard {
        ExerciseStatus status;
        WindlassLoad load;
        Clock::time_point at{};
        double longest_gap = 0; ///< s between two loads since forget_gap()
        std::uint64_t loads = 0;
    };
    Heard heard() const {
        const std::lock_guard lock(mutex_);
        return heard_;
    }
    void forget_gap() {
        const std::lock_guard lock(mutex_);
        heard_.longest_gap = 0;
    }
    std::size_t events(const std::string& code) const {
        const std::lock_guard lock(mutex_);
        return static_cast<std::size_t>(std::count(events_.begin(), events_.end(), code));
    }
    bool runs_out() const { return heard().load.cable_speed() > 1; }

private:
    mutable std::mutex mutex_;
    Heard heard_;
    std::vector<std::string> events_;
    wire::Participant participant_{{own_domain(), "exercise/default", "witness"}};
    wire::Reader<ExerciseStatus> status_{participant_, topics::exercise_status,
                                         [this](const ExerciseStatus& s) {
                                             const std::lock_guard lock(mutex_);
                                             heard_.status = s;
                                         }};
    wire::Reader<WindlassLoad> load_{participant_, topics::windlass_load, [this](const WindlassLoad& s) {
                                         const std::lock_guard lock(mutex_);
                                         const auto now = Clock::now();
                                         if (heard_.loads++ > 0)
                                             heard_.longest_gap =
                                                 std::max(heard_.longest_gap, seconds(now - heard_.at));
                                         heard_.at = now;
                                         heard_.load = s;
                                     }};
    wire::Reader<Event> event_{participant_, topics::event, [this](const Event& e) {
                                   const std::lock_guard lock(mutex_);
                                   events_.push_back(e.code().to_string());
                               }};
};

/// Recorder, server, trainee and console, with the cable running out.
class KilledDuringALetGo : public ::testing::Test {
protected:
    void SetUp() override {
        recorder_ = std::make_unique<RecorderProcess>(folder_ / "before");
        server_ = std::make_unique<ChildProcess>(server_command());
        trainee_ = std::make_unique<ChildProcess>(trainee_command());
        console_ = std::make_unique<ChildProcess>(console_command());
        ASSERT_TRUE(eventually([&] { return witness_.runs_out(); }, std::chrono::seconds(60)))
            << server_->text() << trainee_->text();
        ASSERT_TRUE(eventually([&] { return begins(folder_ / "before"); }))
            << "a whole chunk of it is on the disk";
        witness_.forget_gap();
    }

    /// Kills it, and waits until it is gone and the others had time to notice.
    void kill_9(std::unique_ptr<ChildProcess>& process) {
        process->signal(SIGKILL);
        EXPECT_EQ(process->exit_code(), -1);
        killed_ = Clock::now();
    }
    static void tell(const char* what, double value) { std::printf("%s %.2f s\n", what, value); }
    /// A first chunk of the loads is in the recording that is being written.
    static bool begins(const std::filesystem::path& path) {
        try {
            return loads_in(path).first > 0;
        } catch (const std::exception&) { // its beginning is not on the disk yet
            return false;
        }
    }
    /// The exercise time up to which a recording holds loads, of the run that began last.
    static std::pair<std::uint64_t, double> loads_in(const std::filesystem::path& path) {
        recording::Recording recording({path});
        auto cursor = recording.messages({.topics = {"WindlassLoad"}});
        std::pair<std::uint64_t, double> found{0, 0};
        while (const auto message = cursor.next()) {
            ++found.first;
            found.second = std::max(found.second, recording::decode<WindlassLoad>(message->payload).time());
        }
        return found;
    }
    bool lives(ChildProcess& process) const { return kill(process.pid(), 0) == 0 && !process.ended(); }

    Folder folder_;
    Witness witness_;
    std::unique_ptr<ChildProcess> recorder_, server_, trainee_, console_;
    Clock::time_point killed_;
};

TEST_F(KilledDuringALetGo, ServerComesBackWithANewExerciseAndTheRecordingHasBoth) {
    const auto before = witness_.heard();
    kill_9(server_);

    const auto begin = Clock::now();
    server_ = std::make_unique<ChildProcess>(server_command());
    ASSERT_TRUE(eventually([&] {
        return witness_.heard().at > begin && witness_.heard().load.time() < before.load.time();
    })) << server_->text();
    tell("server: first load after the restart", seconds(Clock::now() - begin));
    EXPECT_TRUE(eventually([&] { return witness_.heard().status.state() == RUN_RUNNING; }));
    EXPECT_EQ(run(INSTRUCTOR_CONSOLE " status --domain " + std::to_string(own_domain())).code, 0);

    EXPECT_TRUE(eventually([&] { // the second run, behind the first
        const auto statuses = statuses_in(folder_ / "before");
        return !statuses.empty() && statuses.back().run() == witness_.heard().status.run();
    }));
    EXPECT_TRUE(lives(*recorder_));
    std::printf("trainee %s, console %s\n", lives(*trainee_) ? "lives" : "ended",
                lives(*console_) ? "lives" : "ended");
    recorder_->signal(SIGINT);
    EXPECT_EQ(recorder_->exit_code(), 0);
    const auto [loads, latest] = loads_in(folder_ / "before");
    EXPECT_GE(latest, before.load.time()); // all of the first run, and then some of the second
    EXPECT_GT(loads, static_cast<std::uint64_t>(before.load.time() * 90));
}

TEST_F(KilledDuringALetGo, TraineesLeversAreMadeSafeAndTakenAgain) {
    const auto taken = witness_.events("levers.taken");
    const auto raised = witness_.heard().status.tick();
    kill_9(trainee_);
    // The server goes on, and nobody holds the levers: a real windlass's lever springs to zero, brake and
    // clutch stay as they were.
    ASSERT_TRUE(eventually([&] { return witness_.events("levers.lost") > 0; })) << server_->text();
    tell("trainee: levers told lost", seconds(Clock::now() - killed_));
    EXPECT_EQ(witness_.heard().load.speed_lever(), 0);
    EXPECT_TRUE(eventually([&] { return witness_.heard().status.tick() > raised; }));

    // Its script would begin anew, with an anchor that hangs on the brake; what is wanted now is the brake.
    put(folder_ / "brake.json", R"({"title": "brake", "side": "port", "steps": [
        {"do": {"brake": 1}}, {"when": {"after": 60}, "say": "held"}]})");
    const auto begin = Clock::now();
    trainee_ = std::make_unique<ChildProcess>(member({TRAINEE_CLIENT, "--name", "trainee", "--view", "line",
                                                      "--script", (folder_ / "brake.json").string()}));
    ASSERT_TRUE(eventually([&] { return witness_.events("levers.taken") > taken; })) << trainee_->text();
    tell("trainee: levers taken after the restart", seconds(Clock::now() - begin));
    EXPECT_TRUE(eventually([&] { return witness_.heard().load.cable_speed() < 0.05; })) << trainee_->text();
    tell("trainee: longest gap of the load topic", witness_.heard().longest_gap);
    EXPECT_TRUE(lives(*server_) && lives(*console_) && lives(*recorder_));
}

TEST_F(KilledDuringALetGo, RecorderLosesItsLastSecondAndNothingBefore) {
    const double at = witness_.heard().load.time();
    const auto tick = witness_.heard().status.tick();
    // Chunks are written each second; on a loaded disk it may take longer until they are there.
    EXPECT_TRUE(eventually([&] { return loads_in(folder_ / "before").second >= at; }));
    const double heard = witness_.heard().load.time();
    kill_9(recorder_);
    const auto [loads, latest] = loads_in(folder_ / "before");
    EXPECT_GE(latest, at); // and a chunk that was half written takes none of it along
    EXPECT_GT(loads, static_cast<std::uint64_t>(latest * 90));
    tell("recorder: lost of what was heard", heard - latest);

    const auto begin = Clock::now();
    recorder_ = std::make_unique<RecorderProcess>(folder_ / "after");
    tell("recorder: recording again after", seconds(Clock::now() - begin));
    EXPECT_TRUE(eventually([&] { return begins(folder_ / "after"); }));
    EXPECT_TRUE(eventually([&] { return loads_in(folder_ / "after").first > 90; }));
    recorder_->signal(SIGINT);
    EXPECT_EQ(recorder_->exit_code(), 0) << recorder_->text();
    EXPECT_GT(loads_in(folder_ / "after").first, 90U);
    tell("recorder: longest gap of the load topic", witness_.heard().longest_gap);
    EXPECT_GT(witness_.heard().status.tick(), tick);
    EXPECT_TRUE(lives(*server_) && lives(*console_) && lives(*trainee_));
}

TEST_F(KilledDuringALetGo, ConsoleIsMissedByNobodyAndSeesAgain) {
    const auto tick = witness_.heard().status.tick();
    kill_9(console_);
    EXPECT_TRUE(eventually([&] { return witness_.heard().status.tick() > tick; }));
    const auto begin = Clock::now();
    EXPECT_EQ(run(INSTRUCTOR_CONSOLE " status --domain " + std::to_string(own_domain())).code, 0);
    tell("console: status after the restart", seconds(Clock::now() - begin));
    tell("console: longest gap of the load topic", witness_.heard().longest_gap);
    EXPECT_GT(witness_.heard().status.tick(), tick);
    EXPECT_TRUE(lives(*server_) && lives(*trainee_) && lives(*recorder_));
}

/// Files of shared memory that a process has mapped.
std::set<std::string> shared_memory_of(pid_t pid) {
    std::set<std::string> files;
    std::ifstream maps("/proc/" + std::to_string(pid) + "/maps");
    for (std::string line; std::getline(maps, line);)
        if (const auto at = line.find("/dev/shm/"); at != std::string::npos) files.insert(line.substr(at));
    return files;
}

TEST(KilledServers, LeaveNothingInSharedMemoryAndDoNoHarm) {
    const Witness witness;
    for (int round = 0; round < 5; ++round) {
        const auto begin = Clock::now();
        ChildProcess server(server_command());
        ASSERT_TRUE(eventually([&] { return witness.heard().at > begin; })) << server.text();
        std::printf("server %d: first load after %.2f s\n", round + 1, seconds(Clock::now() - begin));
        EXPECT_THAT(shared_memory_of(server.pid()), testing::IsEmpty());
        server.signal(SIGKILL);
        EXPECT_EQ(server.exit_code(), -1);
    }
    ServerProcess last({"--domain", std::to_string(own_domain()), "--duration", "1"});
    EXPECT_EQ(last.exit_code(), 0) << last.text();
}

} // namespace
} // namespace windlass::test
