#pragma once
// A server that keeps its exercises, a trainee who works one of them, and who hears what becomes of it.

#include "idl/wire.hpp"
#include "rigs/server_process.hpp"
#include "tests/recorder/folder.hpp"

#include <gtest/gtest.h>

#include <map>
#include <mutex>

namespace windlass::test {
using namespace rigs;

using Clock = std::chrono::steady_clock;
namespace topics = wire::topics;

inline const char* const kExercise = WINDLASS_CONFIG_DIR "/exercises/let_go_port_25m.json";

inline double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

inline std::vector<std::string> server_command(const Folder& folder, double scale,
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

inline std::vector<std::string> trainee_command() {
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

class ServerThatKeeps : public testing::Test {
protected:
    static void kill_9(ChildProcess& process) {
        process.signal(SIGKILL);
        EXPECT_EQ(process.exit_code(), -1);
    }
    Folder folder_;
    Witness witness_;
};

} // namespace windlass::test
