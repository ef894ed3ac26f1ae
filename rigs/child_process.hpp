#pragma once
// A program of ours as a child process.

#include "rigs/own_domain.hpp"
#include "rigs/wait.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace windlass::rigs {

class ChildProcess {
public:
    /// Starts the program (its path first) with these arguments. What it tells goes into a file, read by
    /// text().
    explicit ChildProcess(std::vector<std::string> command) {
        static int started = 0;
        log_ = std::filesystem::temp_directory_path() /
               ("windlass_child_test_" + std::to_string(getpid()) + "_" + std::to_string(++started));
        std::vector<char*> argv;
        for (auto& argument : command)
            argv.push_back(argument.data());
        argv.push_back(nullptr);
        pid_ = fork();
        if (pid_ < 0) throw std::runtime_error("fork failed");
        if (pid_ == 0) {
            const int file = open(log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
            dup2(file, STDOUT_FILENO);
            dup2(file, STDERR_FILENO);
            execv(argv[0], argv.data());
            _exit(127);
        }
    }
    ~ChildProcess() {
        if (!code_) {
            kill(pid_, SIGKILL);
            waitpid(pid_, nullptr, 0);
        }
        std::filesystem::remove(log_);
    }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    void signal(int number) const { kill(pid_, number); }
    pid_t pid() const { return pid_; }

    /// Exit code, once it ends by itself; -1 when it does not, or ends by a signal.
    int exit_code() {
        eventually([&] {
            int status = 0;
            if (!code_ && waitpid(pid_, &status, WNOHANG) == pid_)
                code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
            return code_.has_value();
        });
        return code_.value_or(-1);
    }

    /// It has come to its end, by itself or by a signal.
    bool ended() {
        int status = 0;
        if (!code_ && waitpid(pid_, &status, WNOHANG) == pid_)
            code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return code_.has_value();
    }

    /// Everything told on stdout and stderr so far.
    std::string text() const {
        std::ifstream file(log_);
        return {std::istreambuf_iterator<char>(file), {}};
    }

private:
    std::filesystem::path log_;
    pid_t pid_ = -1;
    std::optional<int> code_;
};

} // namespace windlass::rigs
