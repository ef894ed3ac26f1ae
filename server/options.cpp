#include "server/options.hpp"

#include "idl/network_options.hpp"
#include "server/keep/kept_folders.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace windlass::server {

namespace {

const char* const kFooter = R"(
Exit codes:
  0  ended in order: stopped by a signal, or the set duration was run
  1  the exercise was stopped by a fault of the simulation (a dump was written)
  2  bad option
  3  bad configuration: the exercise or a file it refers to cannot be used
  4  DDS could not start
  5  another server of the domain has an exercise of that --partition, or that --name
  6  the folder of --keep cannot be used, or another server keeps its exercises there
  7  asked by SIGUSR1 to begin anew: all is kept, start it again; with --workers they begin anew by themselves

Several exercises: as many --partition as --exercise, in the same order. Without any --exercise, each partition
gets the built-in one. Every exercise is on its own; they share the threads.

With --keep, exercises come back by themselves when the server was lost (killed, power cut) and is started again with
the same folder: at the tick at which they stopped, paused. One that was ended in order (by a signal, an instructor, a
set duration) is kept no longer (docs/failures.md).

All programs with the same --domain and --partition belong together. On one host nothing else is needed;
between hosts, give all of them --lan or the same --discovery-server (docs/network.md).)";

/// Accepts a number in the range, or zero; never nan, which no comparison excludes by itself.
CLI::Validator zero_or_range(double low, double high) {
    return {[low, high](std::string& text) -> std::string {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) &&
                    (value == 0 || (value >= low && value <= high))) {
                    return {};
                }
                return text + " is not allowed: 0 or " + CLI::detail::to_string(low) + ".." +
                       CLI::detail::to_string(high);
            },
            ""};
}

CLI::Validator plain_name() {
    return {[](std::string& name) -> std::string {
                return wire::is_exercise_name(name)
                           ? ""
                           : '"' + name + "\" is not allowed: letters, digits, - _ . only, 1..64 of them";
            },
            ""};
}

/// Files and partitions in their order; a single one of either need not be given. Throws
/// CLI::ValidationError when they cannot be told apart.
std::vector<Options::Exercise> pair_up(const std::vector<std::filesystem::path>& files,
                                       std::vector<std::string> ids) {
    if (ids.empty()) ids = {"default"};
    if (!files.empty() && files.size() != ids.size()) {
        throw CLI::ValidationError(
            "--partition", fmt::format("{} given for {} --exercise: one for each", ids.size(), files.size()));
    }
    std::vector<Options::Exercise> exercises;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (std::find(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(i), ids[i]) !=
            ids.begin() + static_cast<std::ptrdiff_t>(i)) {
            throw CLI::ValidationError("--partition", ids[i] + " is given twice: each exercise has its own");
        }
        exercises.push_back({files.empty() ? "" : files[i], ids[i]});
    }
    return exercises;
}

} // namespace

std::variant<Options, int> read_options(int argc, char** argv) {
    Options options;
    std::vector<std::filesystem::path> files;
    std::vector<std::string> ids;
    CLI::App app("windlass_server: runs anchoring exercises and publishes them over DDS", "windlass_server");
    app.set_version_flag("--version", std::string("windlass_server ") + WINDLASS_VERSION);
    app.footer(kFooter);
    app.add_option("--exercise", files,
                   "exercise file (JSON), one for each exercise to begin with; without it, the built-in "
                   "exercise: let go the port anchor in 25 m")
        ->type_name("FILE")
        ->allow_extra_args(false);
    app.add_option(
           "--config-root", options.config_root,
           "folder with ships, windlasses, anchors, exercises (default: two levels above the exercise file)")
        ->type_name("DIR");
    app.add_option("--domain", options.domain, "DDS domain")
        ->check(CLI::Range(0, 232))
        ->capture_default_str();
    app.add_option("--partition", ids,
                   "name of the exercise, one for each; the DDS partition is exercise/NAME [default]")
        ->type_name("NAME")
        ->check(plain_name())
        ->allow_extra_args(false);
    app.add_flag("--classroom", options.classroom,
                 "begin without an exercise: instructors create and remove them");
    app.add_option("--name", options.name, "name of this server in the classroom (default: HOST-PROCESS)")
        ->type_name("NAME")
        ->check(plain_name());
    auto* workers =
        app.add_option(
               "--workers", options.workers,
               "share the exercises among N processes: one that dies or hangs takes no other's along, and "
               "is started again; 0: one process for all")
            ->type_name("N")
            ->check(CLI::Range(0, 64))
            ->capture_default_str();
    app.add_option("--worker-memory", options.worker_memory_mb,
                   "with --workers: MB that each may come to; one that grows beyond is started again; 0: any")
        ->type_name("MB")
        ->check(zero_or_range(128, 1e6))
        ->capture_default_str()
        ->needs(workers);
    app.add_option("--threads", options.threads, "threads that tick the exercises; 0: one a core")
        ->check(CLI::Range(0, 64))
        ->capture_default_str();
    app.add_option("--time-scale", options.time_scale,
                   "exercise seconds per wall second, 0.1..20; 0: as fast as possible")
        ->type_name("X")
        ->check(zero_or_range(0.1, 20))
        ->capture_default_str();
    app.add_option("--duration", options.duration, "end after S seconds of exercise; 0: run until stopped")
        ->type_name("S")
        ->check(zero_or_range(1e-3, 1e7))
        ->capture_default_str();
    app.add_flag("--practice", options.practice,
                 "play the lessons of --exercise for practice: with hints, and not as a test");
    app.add_flag("--wait", options.wait, "begin ready, and start when an instructor orders it");
    auto* realtime =
        app.add_flag("--realtime", options.realtime,
                     "run under SCHED_FIFO with memory locked (needs the right to; warns if refused)");
    app.add_option("--fault-dir", options.fault_folder,
                   "folder for the dump of an exercise that had to be stopped")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory)
        ->capture_default_str();
    auto* keep = app.add_option("--keep", options.keep,
                                "folder in which the state of the exercises is kept on disk, of this server "
                                "alone; made when missing. Without it a server that is lost begins anew")
                     ->type_name("DIR");
    app.add_flag("--resume-running", options.resume_running,
                 "with --keep: what ran when the server was lost runs on at once, and does not stand paused")
        ->needs(keep);
    app.add_option("--security", options.security, "folder with the server's identity (docs/security.md)")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory);
    wire::add_network_options(app, options.network);
    app.add_option("--log-level", options.log_level, "how much is told on stderr")
        ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}))
        ->capture_default_str();
    app.final_callback([&] {
        if (options.classroom && !(files.empty() && ids.empty()))
            throw CLI::ValidationError("--classroom", "not together with --exercise or --partition");
        if (!options.classroom) options.exercises = pair_up(files, ids);
        if (realtime->count() > 0 && options.time_scale == 0) {
            throw CLI::ValidationError("--realtime",
                                       "not together with --time-scale 0: it would starve the host");
        }
    });
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? kOk : kBadOption;
    }
    return options;
}

std::filesystem::path exercise_folder(const Options& options) {
    if (!options.exercise_folder.empty()) return options.exercise_folder;
    if (!options.config_root.empty()) return options.config_root / "exercises";
    for (const auto& one : options.exercises)
        if (!one.file.empty()) return one.file.parent_path();
    return std::filesystem::path("config") / "exercises";
}

std::vector<Options> shares(const Options& options, const std::map<std::string, unsigned>& kept) {
    std::vector<Options> all(options.workers, options);
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::size_t> has(options.workers, 0);
    for (const auto& [id, worker] : kept)
        ++has.at(worker - 1);
    for (unsigned k = 0; k < options.workers; ++k) {
        Options& one = all[k];
        one.workers = 0;
        one.exercise_folder = exercise_folder(options);
        one.exercises.clear();
        one.name = fmt::format("{}-{}", options.name, k + 1);
        if (!options.keep.empty()) one.keep = keep::folder_of_worker(options.keep, k + 1);
        if (options.threads == 0) one.threads = (cores + options.workers - 1) / options.workers;
    }
    for (const Options::Exercise& exercise : options.exercises) {
        const auto found = kept.find(exercise.id);
        const auto to = found != kept.end() ? static_cast<std::ptrdiff_t>(found->second) - 1
                                            : std::ranges::min_element(has) - has.begin();
        all[static_cast<std::size_t>(to)].exercises.push_back(exercise);
        if (found == kept.end()) ++has[static_cast<std::size_t>(to)];
    }
    for (Options& one : all)
        one.classroom = one.exercises.empty();
    return all;
}

} // namespace windlass::server
