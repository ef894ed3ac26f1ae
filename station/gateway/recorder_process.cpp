#include "station/gateway/recorder_process.hpp"

#include <sys/wait.h>

#include <csignal>
#include <cstring>
#include <spawn.h>
#include <stdexcept>
#include <unistd.h>

namespace windlass::gateway {

RecorderProcess::RecorderProcess(const std::filesystem::path& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program.string());
    std::vector<char*> argv;
    for (auto& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    // What it tells goes where this program's warnings go: stdout is for addresses.
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    // It has none of our sockets: in it a connection that we close would stay open, and our port taken.
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    const int error = posix_spawn(&pid_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw std::runtime_error("cannot start " + program.string() + ": " + std::strerror(error));
}

RecorderProcess::~RecorderProcess() {
    stop();
    if (pid_ > 0) waitpid(pid_, nullptr, 0);
}

void RecorderProcess::stop() {
    if (!ended()) kill(pid_, SIGINT);
}

bool RecorderProcess::ended() {
    if (pid_ > 0 && waitpid(pid_, nullptr, WNOHANG) == pid_) pid_ = -1;
    return pid_ < 0;
}

} // namespace windlass::gateway
