#pragma once
// The recorder program at work as a child process: it records exercises, or replays a recording.

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace windlass::gateway {

class RecorderProcess {
public:
    /// Whose its stdin and stdout are: those of this program, what it tells going where this program's
    /// warnings go, or ours to speak with it.
    enum class Stdio { inherited, ours };

    /// Starts `program ARGUMENT...`, the first of which is its command. Throws std::runtime_error when it
    /// cannot be started.
    RecorderProcess(const std::filesystem::path& program, std::vector<std::string> arguments,
                    Stdio stdio = Stdio::inherited);
    /// Asks it to end and waits until its file is whole.
    ~RecorderProcess();
    RecorderProcess(const RecorderProcess&) = delete;
    RecorderProcess& operator=(const RecorderProcess&) = delete;

    /// It ends in order: a recorder from now on writes down what it has heard.
    void stop();
    bool ended();

    /// A line to it, where its stdio is ours; lost where it has ended. Never waits.
    void tell(const std::string& line);
    /// Whole lines that came from it since.
    std::vector<std::string> told();

private:
    pid_t pid_ = -1;
    int stdio_ = -1; ///< our end of a socket that is its stdin and stdout; -1: not ours
    std::string unread_;
};

} // namespace windlass::gateway
