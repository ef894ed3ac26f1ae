#include "station/gateway/recorder_process.hpp"

#include <sys/socket.h>
#include <sys/wait.h>

#include <csignal>
#include <cstring>
#include <spawn.h>
#include <stdexcept>
#include <unistd.h>

namespace windlass::gateway {

RecorderProcess::RecorderProcess(const std::filesystem::path& program, std::vector<std::string> arguments,
                                 Stdio stdio) {
    arguments.insert(arguments.begin(), program.string());
    std::vector<char*> argv;
    for (auto& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    int ends[2] = {-1, -1};
    // Closed in every other child process: what it must see to know that we have gone is that we have it.
    if (stdio == Stdio::ours && socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw std::runtime_error("cannot start " + program.string() + ": " + std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (stdio == Stdio::ours) {
        posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    } else { // stdout is for addresses
        posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    }
    // It has none of our sockets: in it a connection that we close would stay open, and our port taken.
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    const int error = posix_spawn(&pid_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (ends[1] >= 0) close(ends[1]);
    stdio_ = ends[0];
    if (error == 0) return;
    if (stdio_ >= 0) close(stdio_);
    throw std::runtime_error("cannot start " + program.string() + ": " + std::strerror(error));
}

RecorderProcess::~RecorderProcess() {
    stop();
    if (pid_ > 0) waitpid(pid_, nullptr, 0);
    if (stdio_ >= 0) close(stdio_);
}

void RecorderProcess::stop() {
    if (!ended()) kill(pid_, SIGINT);
}

bool RecorderProcess::ended() {
    if (pid_ > 0 && waitpid(pid_, nullptr, WNOHANG) == pid_) pid_ = -1;
    return pid_ < 0;
}

void RecorderProcess::tell(const std::string& line) {
    const std::string text = line + "\n";
    if (stdio_ >= 0) (void)!send(stdio_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

std::vector<std::string> RecorderProcess::told() {
    if (stdio_ < 0) return {};
    char buffer[4096];
    for (ssize_t count = 0; (count = recv(stdio_, buffer, sizeof buffer, MSG_DONTWAIT)) > 0;)
        unread_.append(buffer, static_cast<std::size_t>(count));
    std::vector<std::string> lines;
    for (auto end = unread_.find('\n'); end != std::string::npos; end = unread_.find('\n')) {
        lines.push_back(unread_.substr(0, end));
        unread_.erase(0, end + 1);
    }
    return lines;
}

} // namespace windlass::gateway
