#pragma once
// The real windlass_server as a child process.

#include "rigs/child_process.hpp"

namespace windlass::rigs {

class ServerProcess : public ChildProcess {
public:
    /// Starts the server with these options.
    explicit ServerProcess(std::vector<std::string> options)
        : ChildProcess(with_program(std::move(options))) {}

private:
    static std::vector<std::string> with_program(std::vector<std::string> options) {
        options.insert(options.begin(), WINDLASS_SERVER);
        return options;
    }
};

} // namespace windlass::rigs
