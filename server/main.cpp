// windlass_server: opens the exercises, and looks after them until it is told to stop.

#include "common/thread_name.hpp"
#include "lesson/beside.hpp"
#include "server/config/config.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/exercise/prelude.hpp"
#include "server/host/read_aside.hpp"
#include "server/host/realtime.hpp"
#include "server/host/server_group.hpp"
#include "server/keep/keeper.hpp"
#include "server/keep/kept_folders.hpp"
#include "server/options.hpp"
#include "server/run/briefing.hpp"
#include "server/workers/supervisor.hpp"

#include <spdlog/async.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <unistd.h>

#include <csignal>
#include <optional>

namespace {

using namespace windlass;
using namespace windlass::server;

constexpr const char* kLogPattern = "%H:%M:%S.%e %^%-5l%$ %v";

volatile std::sig_atomic_t stop_signal = 0, anew_wanted = 0;

void on_signal(int number) {
    stop_signal = number;
}

void on_anew(int) {
    anew_wanted = 1;
}

/// Somebody wants the server to begin anew, as it is to read its identity and the list of the revoked again;
/// true: it may, since its exercises are kept.
bool is_to_begin_anew(const Options& options) {
    if (anew_wanted == 0) return false;
    anew_wanted = 0;
    if (options.keep.empty())
        spdlog::error("SIGUSR1: without --keep the exercises would be lost; it goes on");
    return !options.keep.empty();
}

/// Text for people on stderr, written by a thread of its own: a slow terminal must not hold up a tick.
void set_up_log(const std::string& level) {
    spdlog::init_thread_pool(8192, 1);
    auto logger = spdlog::create_async_nb<spdlog::sinks::stderr_color_sink_mt>("windlass_server");
    spdlog::set_default_logger(logger);
    spdlog::set_level(spdlog::level::from_str(level));
    spdlog::set_pattern(kLogPattern);
}

exercise::ExerciseDef load(const Options& options, const std::filesystem::path& file) {
    return options.config_root.empty() ? config::load_exercise(file)
                                       : config::load_exercise(file, options.config_root);
}

std::filesystem::path config_root(const Options& options) {
    return options.config_root.empty() ? exercise_folder(options).parent_path() : options.config_root;
}

run::SessionOptions session_options(const Options& options) {
    return {
        .id = {},
        .time_scale = options.time_scale,
        .duration = options.duration,
        .wait = options.wait,
        .realtime = options.realtime,
        .fault_folder = options.fault_folder,
        .load =
            [options](const std::string& name) {
                return host::read_aside([options, name] {
                    std::filesystem::path file = exercise_folder(options) / name;
                    if (!file.has_extension()) file += ".json";
                    return load(options, file);
                });
            },
        .prepare = [](const exercise::ExerciseDef& def) { return host::read_aside([def] { return def; }); },
        .check = config::check_definition,
        .model_hands =
            [options](const run::Beginning& beginning) {
                return lesson::model_beside(beginning, config_root(options));
            },
        // Servers that were not started in the same millisecond never come to the same number.
        .first_run = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(
                                                    std::chrono::system_clock::now().time_since_epoch())
                                                    .count())};
}

host::ExerciseSource exercise_source(const Options& options) {
    return {.load = session_options(options).load,
            .parse =
                [options](const std::string& text, const std::string& source) {
                    return host::read_aside([options, text, source] { // it may refer to files
                        return config::parse_exercise(text, source, config_root(options));
                    });
                },
            .options =
                [&options](bool wait) {
                    auto session = session_options(options);
                    session.wait = wait;
                    return session;
                }};
}

std::string server_name(const Options& options) {
    if (!options.name.empty()) return options.name;
    std::array<char, 50> host{}; // leaves room for the process in 64
    if (gethostname(host.data(), host.size() - 1) != 0 || !wire::is_exercise_name(host.data()))
        return fmt::format("server-{}", getpid());
    return fmt::format("{}-{}", host.data(), getpid());
}

/// Joins the domain; what Fast DDS does for itself is then done by threads of that name.
wire::Participant join(const Options& options) {
    const ThreadName name("dds");
    return wire::Participant({.domain = options.domain,
                              .partition = wire::kClassroomPartition,
                              .name = "windlass_server",
                              .security = options.security,
                              .network = options.network,
                              .ignore_own_process = true});
}

/// Tells now and then how late ticks begin.
void tell_timekeeping(host::ServerGroup& servers) {
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds kEvery{5};
    static Clock::time_point told = Clock::now();
    if (Clock::now() - told < kEvery) return;
    told = Clock::now();
    const auto kept = servers.timekeeping();
    spdlog::debug(
        "{} beats begun: half within {:.2f} ms of their time, 99 % within {:.2f}, all within {:.2f}",
        kept.beats, 1000 * kept.half, 1000 * kept.most, 1000 * kept.all);
}

/// What was kept of an exercise when the server was lost.
std::optional<keep::TakenUp> take_up(const Options& options, const keep::Keeper* keeper,
                                     const std::string& id, std::optional<std::uint64_t> definition_hash) {
    if (keeper == nullptr) return std::nullopt;
    return keeper->take_up(id, {.definition_hash = definition_hash,
                                .check = config::check_definition,
                                .running = options.resume_running});
}

/// Exercises that are kept and were not named: instructors had created them, and they come back as well.
void open_created(const Options& options, const keep::Keeper* keeper, host::ServerGroup& servers) {
    if (keeper == nullptr) return;
    for (const std::string& id : keeper->kept()) {
        if (!wire::is_exercise_name(id) ||
            std::ranges::find(options.exercises, id, &Options::Exercise::id) != options.exercises.end())
            continue;
        if (const auto other = servers.server_of(id); !other.empty()) {
            spdlog::error("exercise {} does not come back: server {} has one of this name", id, other);
            continue;
        }
        const auto taken = take_up(options, keeper, id, std::nullopt);
        if (taken && taken->def) {
            auto session = session_options(options);
            session.resumption = taken->how;
            servers.open(id, *taken->def, session);
        } else if (taken) {
            spdlog::error("exercise {} does not come back: {}", id, taken->how.refused);
        }
    }
}

/// Runs until a signal comes or the set duration is over. Returns the exit code.
int host_exercises(const Options& options, const std::vector<exercise::ExerciseDef>& defs,
                   keep::Keeper* keeper, workers::Pulse& pulse) {
    constexpr std::chrono::seconds kHangs{10}; // a beat that takes so long does not end
    const std::string name = server_name(options);
    const unsigned threads = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
    const auto join_domain = [&] { // also where exercises are being opened
        const host::SchedulingKept before;
        if (options.realtime) host::go_before_other_programs();
        return join(options);
    };
    host::ServerGroup servers(join_domain, name, threads, exercise_source(options), keeper);
    const auto name_taken = [&](const std::string& taken) {
        spdlog::error(
            "server {} ends: another server of this name is in DDS domain {}; choose another --name "
            "or --domain",
            taken, options.domain);
        return kNameTaken;
    };
    if (const auto taken = servers.name_taken(); !taken.empty()) return name_taken(taken);
    std::optional<host::SchedulingKept> opening(std::in_place);
    host::leave_realtime(); // seconds of work, which ticks of other workers do not wait for
    for (std::size_t i = 0; i < defs.size(); ++i) {
        const std::string& id = options.exercises[i].id;
        if (const auto other = servers.server_of(id); !other.empty()) {
            spdlog::error(
                "exercise {} is not opened: server {} in DDS domain {} has one of this name; choose "
                "another --partition or --domain",
                id, other, options.domain);
            return kNameTaken;
        }
        auto session = session_options(options);
        if (const auto taken = take_up(options, keeper, id, exercise::definition_hash(defs[i])))
            session.resumption = taken->how;
        servers.open(id, defs[i], session);
        pulse.starting();
        if (const auto taken = servers.name_taken(); !taken.empty()) return name_taken(taken);
        spdlog::info("exercise {} in DDS domain {}, partition exercise/{}", defs[i].name, options.domain, id);
    }
    open_created(options, keeper, servers);
    opening.reset();
    spdlog::info("server {} in the classroom of DDS domain {}", name, options.domain);
    while (stop_signal == 0 && !servers.all_ended()) {
        servers.serve();
        if (servers.longest_beat() < kHangs) pulse.serving();
        tell_timekeeping(servers);
        if (const auto taken = servers.name_taken(); !taken.empty()) {
            servers.close_all("another server has the name " + taken);
            return name_taken(taken);
        }
        if (servers.gave_all_way() && !options.classroom) return kNameTaken;
        if (is_to_begin_anew(options)) {
            servers.leave_all();
            return kBeginsAnew;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    const bool failed = servers.any_stopped_by_fault();
    if (keeper != nullptr) keeper->end_in_order();
    servers.close_all(stop_signal == SIGINT ? "interrupted" : "terminated");
    return failed ? kStoppedByFault : kOk;
}

/// The folder in which exercises are kept is of no use; the error says why, and which.
int cannot_keep(const std::exception& error) {
    spdlog::error("--keep: {}", error.what());
    return kCannotKeep;
}

int serve(const Options& options, workers::Pulse pulse) {
    std::vector<exercise::ExerciseDef> defs;
    try {
        for (const auto& wanted : options.exercises) {
            pulse.starting();
            defs.push_back(wanted.file.empty() ? exercise::ExerciseDef()
                                               : exercise::with_prelude_played(load(options, wanted.file)));
            if (options.practice) run::put_to_practice(defs.back());
        }
    } catch (const ConfigError& error) {
        spdlog::error("{}", error.what());
        return kBadConfiguration;
    } catch (const std::invalid_argument& error) { // no lesson to practise
        spdlog::error("{}", error.what());
        return kBadConfiguration;
    }
    try {
        if (options.realtime) {
            for (const auto& refused : host::enter_realtime())
                spdlog::warn("--realtime: {}", refused);
        }
        std::optional<keep::Keeper> keeper;
        if (!options.keep.empty()) {
            keeper.emplace(options.keep);
            keep::settle(options.keep, 0); // workers may have kept there
        }
        return host_exercises(options, defs, keeper ? &*keeper : nullptr, pulse);
    } catch (const keep::KeptError& error) {
        return cannot_keep(error);
    } catch (const std::filesystem::filesystem_error& error) { // of what is kept there
        return cannot_keep(error);
    } catch (const std::invalid_argument& error) {
        spdlog::error("{}", error.what());
        return kBadConfiguration;
    } catch (const std::runtime_error& error) {
        spdlog::error("{}", error.what());
        return kNoDds;
    }
}

int work(const Options& options, workers::Pulse pulse) {
    set_up_log(options.log_level);
    const int code = serve(options, pulse);
    spdlog::shutdown();
    return code;
}

/// Shares the exercises among processes and looks after these. No thread may have been started.
int supervise(Options options) {
    spdlog::set_default_logger(spdlog::stderr_color_st("supervisor"));
    spdlog::set_level(spdlog::level::from_str(options.log_level));
    spdlog::set_pattern(kLogPattern);
    options.name = server_name(options);
    std::optional<keep::FolderLock> lock;
    std::map<std::string, unsigned> kept;
    try {
        if (!options.keep.empty()) {
            lock.emplace(options.keep);
            kept = keep::settle(options.keep, options.workers);
        }
    } catch (const keep::KeptError& error) {
        return cannot_keep(error);
    } catch (const std::filesystem::filesystem_error& error) {
        return cannot_keep(error);
    }
    const std::vector<Options> all = shares(options, kept);
    const auto share_of = [&](unsigned number, workers::Pulse pulse) {
        if (lock) lock->leave_to_parent();
        return work(all.at(number - 1), pulse);
    };
    return workers::supervise(
        options.workers, {.memory = std::uint64_t{options.worker_memory_mb} << 20U}, share_of,
        [] { return static_cast<int>(stop_signal); }, [&] { return is_to_begin_anew(options); });
}

} // namespace

int main(int argc, char** argv) {
    const auto options = read_options(argc, argv);
    if (const int* code = std::get_if<int>(&options)) return *code;
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    std::signal(SIGUSR1, on_anew);
    std::signal(SIGXFSZ, SIG_IGN); // a limit on file size is told by write(), like a full disk
    std::signal(SIGPIPE, SIG_IGN); // who reads the log may go away; the exercises go on
    if (std::get<Options>(options).workers > 0) return supervise(std::get<Options>(options));
    return work(std::get<Options>(options), workers::Pulse());
}
