#pragma once
// The commands of the program, and what they have in common.

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace windlass::recorder {

/// How the program ends; told in --help.
enum ExitCode {
    kOk = 0,
    kFailed = 1,
    kBadOption = 2,
    kDamaged = 3, ///< a recording could not be read, or not all of it, or is of another version of the wire
    kLiveServer = 4, ///< a replay does not go where a server is
    kDisk = 5,       ///< too little room, or the system refused to write
    kDiffers = 6     ///< what comes of the recorded orders is not what was recorded
};

/// What the command line asked for; called when it has been read.
using Command = std::function<int()>;

void add_record(CLI::App& app, Command& chosen);
void add_record_many(CLI::App& app, Command& chosen);
void add_info(CLI::App& app, Command& chosen);
void add_replay(CLI::App& app, Command& chosen);
void add_control(CLI::App& app, Command& chosen);
void add_debrief(CLI::App& app, Command& chosen);
void add_class(CLI::App& app, Command& chosen);
void add_export(CLI::App& app, Command& chosen);
void add_assess(CLI::App& app, Command& chosen);
void add_blind(CLI::App& app, Command& chosen);
void add_resimulate(CLI::App& app, Command& chosen);
void add_whatif(CLI::App& app, Command& chosen);

/// A number in the range; never NaN, which no comparison excludes by itself.
CLI::Validator number_in(double low, double high);

/// One line on stderr: "recorder: TEXT".
void tell(const std::string& text);

} // namespace windlass::recorder
