#pragma once
// The command line of windlass_server.

#include "idl/wire.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace windlass::server {

/// How the program ends; told in --help.
enum ExitCode {
    kOk = 0,
    kStoppedByFault = 1,
    kBadOption = 2,
    kBadConfiguration = 3,
    kNoDds = 4,
    kNameTaken = 5,
    kCannotKeep = 6,
    kBeginsAnew = 7 ///< asked by SIGUSR1: its exercises are kept, and it is to be started again
};

struct Options {
    /// The exercises to begin with, each with its file (empty: the built-in one) and its partition's name.
    struct Exercise {
        std::filesystem::path file;
        std::string id;
    };
    std::vector<Exercise> exercises;
    std::filesystem::path config_root;     ///< empty: two folders above the exercise file, else ./config
    std::filesystem::path exercise_folder; ///< of a worker: the whole server's; else empty
    bool classroom = false;                ///< begin with none
    std::string name;                      ///< of the server; empty: made of host and process
    int domain = 0;
    unsigned workers = 0;          ///< processes that share the exercises; 0: this one has them
    unsigned worker_memory_mb = 0; ///< of each, at most; 0: any
    unsigned threads = 0;          ///< that tick the exercises; 0: one a core
    double time_scale = 1;         ///< 0: as fast as possible
    double duration = 0;           ///< s of exercise, 0: until stopped
    bool wait = false;
    bool practice = false; ///< the exercises to begin with are played for practice: each has a lesson
    bool realtime = false;
    std::filesystem::path fault_folder = ".";
    std::filesystem::path security; ///< folder with the server's identity; empty: without
    std::filesystem::path keep;     ///< folder in which exercises are kept; empty: they are not
    bool resume_running = false;    ///< what ran when the server was lost runs on
    wire::Network network;
    std::string log_level = "info";
};

/// Where the exercises are that an instructor may load: of the configuration, or beside the first exercise
/// that has a file.
std::filesystem::path exercise_folder(const Options& options);

/// What each worker is to do: its exercises, its own name (NAME-1, NAME-2, ...), its folder to keep them in,
/// its share of the cores. kept: which worker has what is kept already; the others go to those that have
/// fewest.
std::vector<Options> shares(const Options& options, const std::map<std::string, unsigned>& kept);

/// The options, or the exit code when the program is to end here (--help, --version, bad option: told on
/// stdout or stderr).
std::variant<Options, int> read_options(int argc, char** argv);

} // namespace windlass::server
