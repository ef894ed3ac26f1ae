#pragma once
// The recorder program at work as a child process: it records an exercise, or replays a recording.

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace windlass::gateway {

class RecorderProcess {
public:
    /// Starts `program ARGUMENT...`, the first of which is its command. Throws std::runtime_error when it
    /// cannot be started.
    RecorderProcess(const std::filesystem::path& program, std::vector<std::string> arguments);
    /// Asks it to end and waits until its file is whole.
    ~RecorderProcess();
    RecorderProcess(const RecorderProcess&) = delete;
    RecorderProcess& operator=(const RecorderProcess&) = delete;

    /// It ends in order: a recorder from now on writes down what it has heard.
    void stop();
    bool ended();

private:
    pid_t pid_ = -1;
};

} // namespace windlass::gateway
