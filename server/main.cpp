// windlass_server: opens the exercises, and looks after them until it is told to stop.

#include "server/exercise/config.hpp"
#include "server/host/host.hpp"
#include "server/options.hpp"
#include "server/realtime.hpp"

#include <spdlog/async.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>

namespace {

using namespace windlass;
using namespace windlass::server;

volatile std::sig_atomic_t stop_signal = 0;

void on_signal(int number) {
    stop_signal = number;
}

/// Text for people on stderr, written by a thread of its own: a slow terminal must not hold up a tick.
void set_up_log(const std::string& level) {
    spdlog::init_thread_pool(8192, 1);
    auto logger = spdlog::create_async_nb<spdlog::sinks::stderr_color_sink_mt>("windlass_server");
    spdlog::set_default_logger(logger);
    spdlog::set_level(spdlog::level::from_str(level));
    spdlog::set_pattern("%H:%M:%S.%e %^%-5l%$ %v");
}

exercise::ExerciseDef load(const Options& options, const std::filesystem::path& file) {
    return options.config_root.empty() ? exercise::load_exercise(file)
                                       : exercise::load_exercise(file, options.config_root);
}

/// Where the exercises are that an instructor may load.
std::filesystem::path exercise_folder(const Options& options) {
    if (!options.config_root.empty()) return options.config_root / "exercises";
    if (const auto& first = options.exercises.front().file; !first.empty()) return first.parent_path();
    return std::filesystem::path("config") / "exercises";
}

SessionOptions session_options(const Options& options) {
    return {.id = {},
            .time_scale = options.time_scale,
            .duration = options.duration,
            .wait = options.wait,
            .realtime = options.realtime,
            .fault_folder = options.fault_folder,
            .load =
                [&options](const std::string& name) {
                    std::filesystem::path file = exercise_folder(options) / name;
                    if (!file.has_extension()) file += ".json";
                    return load(options, file);
                },
            .check = exercise::check_definition,
            // Servers that were not started in the same millisecond never come to the same number.
            .first_run = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(
                                                        std::chrono::system_clock::now().time_since_epoch())
                                                        .count())};
}

int serve(const Options& options) {
    std::vector<exercise::ExerciseDef> defs;
    try {
        for (const auto& wanted : options.exercises)
            defs.push_back(wanted.file.empty() ? exercise::ExerciseDef() : load(options, wanted.file));
    } catch (const exercise::ConfigError& error) {
        spdlog::error("{}", error.what());
        return kBadConfiguration;
    }
    try {
        if (options.realtime) {
            for (const auto& refused : enter_realtime())
                spdlog::warn("--realtime: {}", refused);
        }
        const auto& exercises = options.exercises;
        const wire::Participant member({options.domain, wire::exercise_partition(exercises.front().id),
                                        "windlass_server", options.security});
        Host host(member, options.threads > 0 ? options.threads : std::thread::hardware_concurrency());
        for (std::size_t i = 0; i < exercises.size(); ++i) {
            host.open(exercises[i].id, defs[i], session_options(options));
            spdlog::info("exercise {} in DDS domain {}, partition exercise/{}", defs[i].name, options.domain,
                         exercises[i].id);
        }
        while (stop_signal == 0 && !host.all_ended())
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        const bool failed = host.any_stopped_by_fault();
        host.close_all(stop_signal == SIGINT ? "interrupted" : "terminated");
        return failed ? kStoppedByFault : kOk;
    } catch (const std::invalid_argument& error) {
        spdlog::error("{}", error.what());
        return kBadConfiguration;
    } catch (const std::runtime_error& error) {
        spdlog::error("{}", error.what());
        return kNoDds;
    }
}

} // namespace

int main(int argc, char** argv) {
    const auto options = read_options(argc, argv);
    if (const int* code = std::get_if<int>(&options)) return *code;
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    set_up_log(std::get<Options>(options).log_level);
    const int code = serve(std::get<Options>(options));
    spdlog::shutdown();
    return code;
}
