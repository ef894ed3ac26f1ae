#pragma once
// Programs around a recording: server, recorder, replay, each a process of its own.

#include "recorder/recording/recording.hpp"
#include "recorder/recording/typed.hpp"

#include "rigs/server_process.hpp"
#include "tests/recorder/folder.hpp"
#include "tests/wire/run_program.hpp"

#include <csignal>

namespace windlass::test {

inline std::vector<std::string> recorder_command(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), WINDLASS_RECORDER);
    if (arguments[1] == "record" || arguments[1] == "replay") {
        arguments.insert(arguments.end(), {"--domain", std::to_string(rigs::own_domain())});
    }
    return arguments;
}

/// `recorder record` into a folder, and ready: the server may start.
class RecorderProcess : public rigs::ChildProcess {
public:
    explicit RecorderProcess(const std::filesystem::path& output, std::vector<std::string> more = {})
        : rigs::ChildProcess(command(output, std::move(more))) {
        rigs::eventually([&] { return text().find("recording partition") != std::string::npos; });
    }

private:
    static std::vector<std::string> command(const std::filesystem::path& output,
                                            std::vector<std::string> more) {
        more.insert(more.begin(),
                    {"record", "--output", output.string(), "--config-root", WINDLASS_CONFIG_DIR});
        return recorder_command(std::move(more));
    }
};

/// The let-go exercise for so many seconds of exercise.
inline std::vector<std::string> let_go(const std::string& seconds, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--exercise", WINDLASS_CONFIG_DIR "/exercises/let_go_port_25m.json", "--domain",
                             std::to_string(rigs::own_domain()), "--duration", seconds});
    return more;
}

/// Runs the recorder to its end: what it told, and its exit code.
inline Ending run_recorder(const std::string& arguments) {
    return run(std::string(WINDLASS_RECORDER) + " " + arguments);
}

/// Every status of an exercise that a recording holds so far, also one that is being written.
inline std::vector<ExerciseStatus> statuses_in(const std::filesystem::path& path) {
    std::vector<ExerciseStatus> found;
    try {
        recording::Recording recording({path});
        auto cursor = recording.messages({.topics = {"ExerciseStatus"}});
        while (const auto message = cursor.next())
            found.push_back(recording::decode<ExerciseStatus>(message->payload));
    } catch (const std::exception&) { // its beginning is not on the disk yet
    }
    return found;
}

/// The exercise's last word is in the recording, and so is what was sent before it: to one socket, in order.
inline bool has_the_end(const std::filesystem::path& path) {
    return rigs::eventually([&] {
        const auto statuses = statuses_in(path);
        return !statuses.empty() && statuses.back().state() == RUN_FINISHED;
    });
}

/// What `recorder record` makes of some seconds of exercise, and of what is said `before` it begins. Exit
/// codes are checked by the caller.
inline int record_exercise(
    const std::filesystem::path& output, const std::string& seconds, std::vector<std::string> more = {},
    void (*before)() = [] {}) {
    RecorderProcess recorder(output, std::move(more));
    before();
    rigs::ServerProcess server(let_go(seconds));
    if (server.exit_code() != 0) return -1;
    if (!has_the_end(output)) return -1;
    recorder.signal(SIGINT);
    return recorder.exit_code();
}

} // namespace windlass::test
