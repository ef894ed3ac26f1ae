#pragma once
// Identities as make_identities makes them, gone with the test.

#include "tests/wire/run_program.hpp"

#include <string>

namespace windlass::test {

/// A folder with an identity for each role, and its authorities beside it.
class Identities {
public:
    Identities() { made_ = make("").code == 0; }

    /// Whether all were made.
    bool made() const { return made_; }

    /// make_identities with the folder, and what comes after it; before: a command, an assignment to the
    /// environment.
    Ending make(const std::string& more, const std::string& command = "",
                const std::string& before = "") const {
        return run(before + " " WINDLASS_SECURITY_DIR "/make_identities " + command + " " +
                   folder().string() + " " + more + " </dev/null");
    }
    std::filesystem::path folder() const { return place_ / "identities"; }
    std::filesystem::path authorities() const { return place_ / "identities.ca"; }
    std::string of(const std::string& name) const { return (folder() / name).string(); }

private:
    Folder place_;
    bool made_ = false;
};

} // namespace windlass::test
