#pragma once

#include "station/gateway/history.hpp"
#include "station/gateway/recorder_process.hpp"

#include <functional>
#include <map>
#include <memory>

namespace windlass::gateway {

/// Recordings that are shown, each in an exercise of its own: one shows it to all who look at it, whatever
/// gateway of this program they came by. One thread.
class Replays {
public:
    /// recorder: the program. arguments: of it, beside what is replayed where.
    Replays(std::filesystem::path recorder, std::vector<std::string> arguments,
            std::function<void(const std::string&)> log)
        : recorder_(std::move(recorder)), arguments_(std::move(arguments)), log_(std::move(log)) {}

    /// The exercise in which that recording is shown, from now on where it was not. Throws Refused.
    std::string show(const std::filesystem::path& recording);

    /// Somebody has that exercise.
    void looked_at(const std::string& exercise, Clock::time_point now);

    /// Those end that nobody has looked at for a minute.
    void tick(Clock::time_point now);

private:
    struct Replay {
        std::unique_ptr<RecorderProcess> process;
        Clock::time_point used;
    };
    std::filesystem::path recorder_;
    std::vector<std::string> arguments_;
    std::function<void(const std::string&)> log_;
    std::map<std::string, Replay> all_; // by exercise
};

} // namespace windlass::gateway
