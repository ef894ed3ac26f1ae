#pragma once
// Another program, run to its end.

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace windlass::test {

struct Ending {
    int code = -1;    ///< exit code; -1 when a signal ended it
    std::string text; ///< stdout and stderr
};

inline Ending run(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return {};
    Ending ending;
    std::array<char, 4096> part{};
    while (const std::size_t read = fread(part.data(), 1, part.size(), pipe))
        ending.text.append(part.data(), read);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) ending.code = WEXITSTATUS(status);
    return ending;
}

} // namespace windlass::test
