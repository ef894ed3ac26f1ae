#pragma once
// The recorder of one exercise, as a child process.

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace windlass::gateway {

class RecorderProcess {
public:
    /// Starts `program record ARGUMENT...`. Throws std::runtime_error when it cannot be started.
    RecorderProcess(const std::filesystem::path& program, std::vector<std::string> arguments);
    /// Asks it to end and waits until its file is whole.
    ~RecorderProcess();
    RecorderProcess(const RecorderProcess&) = delete;
    RecorderProcess& operator=(const RecorderProcess&) = delete;

    /// From now on it writes down what it has heard, and ends.
    void stop();
    bool ended();

private:
    pid_t pid_ = -1;
};

} // namespace windlass::gateway
