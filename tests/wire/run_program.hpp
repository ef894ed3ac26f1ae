#pragma once
// Another program, run to its end.

#include "tests/recorder/folder.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace windlass::test {

struct Ending {
    int code = -1;      ///< exit code; -1 when a signal ended it
    std::string output; ///< stdout
    std::string text;   ///< stdout, then stderr
};

/// Runs a line of the shell to its end. What a program, or Fast DDS within it, may say on stderr at any time
/// is not in the output, which others read.
inline Ending run(const std::string& command) {
    const Folder folder;
    const auto errors = folder / "stderr";
    FILE* pipe = popen(("{ " + command + "\n} 2>" + errors.string()).c_str(), "r");
    if (!pipe) return {};
    Ending ending;
    std::array<char, 4096> part{};
    while (const std::size_t read = fread(part.data(), 1, part.size(), pipe))
        ending.output.append(part.data(), read);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) ending.code = WEXITSTATUS(status);
    ending.text = ending.output + content(errors);
    return ending;
}

} // namespace windlass::test
