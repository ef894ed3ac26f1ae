#pragma once
// Options that both station programs have, and how they start and stop.

#include "idl/wire.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace windlass::station {

/// Exit codes of both programs.
enum ExitCode { kOk = 0, kFailed = 1, kBadOption = 2, kBadScript = 3, kNoServer = 4 };

/// --domain, --partition, --name, --security, --lan, --discovery-server.
struct SessionOptions {
    int domain = 0;
    std::string partition = "default";
    std::string name;
    std::filesystem::path security = {}; ///< empty: without
    wire::Network network = {};

    void add_to(CLI::App& app);
    wire::JoinOptions session() const; ///< partition NAME becomes "exercise/NAME"
    /// The same domain, identity and network as options of another program of ours.
    std::vector<std::string> arguments() const;
};

/// Reads the command line. From now on a reader of our output that goes away ends the program no more:
/// writing fails, which stop_asked() and leave() tell. Returns the exit code to leave with at once (--help,
/// bad option), or nothing.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// From now on SIGINT and SIGTERM only set what stop_asked() tells.
void catch_stop_signals();
/// By a signal, or because nobody reads the output any more.
bool stop_asked();

/// The exit code of a program that has done its work: kFailed in place of kOk when not all of its output
/// could be written.
int leave(int code);

} // namespace windlass::station
