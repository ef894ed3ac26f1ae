// windlass_server: takes orders, steps the exercise, publishes it, waits.

#include "server/dds/command_readers.hpp"
#include "server/dds/publisher.hpp"
#include "server/exercise/config.hpp"
#include "server/options.hpp"
#include "server/pacer.hpp"
#include "server/realtime.hpp"
#include "server/session.hpp"

#include <spdlog/async.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>

namespace {

using namespace windlass;
using namespace windlass::server;
using Clock = std::chrono::steady_clock;

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
    if (!options.exercise.empty()) return options.exercise.parent_path();
    return std::filesystem::path("config") / "exercises";
}

SessionOptions session_options(const Options& options) {
    return {.time_scale = options.time_scale,
            .duration = options.duration,
            .wait = options.wait,
            .realtime = options.realtime,
            .fault_folder = options.fault_folder,
            .load = [&options](const std::string& name) {
                std::filesystem::path file = exercise_folder(options) / name;
                if (!file.has_extension()) file += ".json";
                return load(options, file);
            }};
}

void tell(const exercise::ExerciseEvent& event) {
    constexpr std::array levels{spdlog::level::info, spdlog::level::warn, spdlog::level::warn,
                                spdlog::level::err};
    spdlog::log(levels.at(static_cast<std::size_t>(event.severity)), "{:8.2f} s {}: {}", event.time,
                event.code, event.text);
}

void publish(Session& session, Publisher& publisher, double now) {
    for (const auto& event : session.events()) {
        tell(event);
        publisher.offer(event);
    }
    for (const auto& alert : session.alerts())
        publisher.offer(alert);
    if (const CheckpointView* checkpoint = session.checkpoint()) publisher.offer(*checkpoint);
    session.clear_news();
    publisher.offer(session.snapshot(), session.status(), now);
}

/// Room for the whole cable, so that paying out never makes the publisher's slots grow.
void prepare(Publisher& publisher, const exercise::ExerciseDef& def) {
    std::size_t nodes = 0;
    for (const auto& tackle : def.tackle) {
        const double spacing = exercise::modelled_chain(def, tackle).node_spacing;
        nodes = std::max(nodes, static_cast<std::size_t>(tackle.chain.length / spacing) + 16);
    }
    publisher.prepare(def.tackle.size(), nodes);
}

/// Runs until a signal comes or the set duration is over.
void run(Session& session, Mailbox& mailbox, Publisher& publisher) {
    const auto start = Clock::now();
    const auto seconds = [start](Clock::time_point t) {
        return std::chrono::duration<double>(t - start).count();
    };
    Pacer pacer(session.dt(), session.status().time_scale, start);
    Inbox inbox;
    unsigned setups = 0;
    double scale = session.status().time_scale;
    while (stop_signal == 0 && !session.ended()) {
        std::this_thread::sleep_until(pacer.due());
        int ticks = 0;
        for (int i = pacer.ticks_per_beat(); i > 0; --i) {
            const double now = seconds(Clock::now());
            mailbox.drain(session.limits(), inbox);
            session.take(inbox, now);
            if (session.tick()) ++ticks;
            publish(session, publisher, now);
        }
        const auto now = Clock::now();
        pacer.beat_ended(ticks, now);
        session.report_pace(pacer.lateness(), pacer.overruns(), pacer.scale_achieved(), publisher.dropped());
        if (setups != session.setups()) {
            setups = session.setups();
            prepare(publisher, session.def());
            pacer.set_tick(session.dt(), Clock::now());
        }
        if (scale != session.status().time_scale) pacer.set_scale(scale = session.status().time_scale, now);
        pacer.set_standing(!session.running(), now);
    }
    if (stop_signal != 0) session.finish(stop_signal == SIGINT ? "interrupted" : "terminated");
    publisher.flush(std::chrono::milliseconds(200)); // room for the last picture
    publish(session, publisher, seconds(Clock::now()));
    publisher.flush(std::chrono::milliseconds(1000));
}

int serve(const Options& options) {
    exercise::ExerciseDef def;
    try {
        if (!options.exercise.empty()) def = load(options, options.exercise);
    } catch (const exercise::ConfigError& error) {
        spdlog::error("{}", error.what());
        return kBadConfiguration;
    }
    try {
        if (options.realtime) {
            for (const auto& refused : enter_realtime())
                spdlog::warn("--realtime: {}", refused);
        }
        Session session(def, session_options(options));
        wire::Participant participant({options.domain, wire::exercise_partition(options.partition),
                                       "windlass_server", options.security});
        Mailbox mailbox;
        Publisher publisher(participant);
        const CommandReaders readers(participant, mailbox);
        spdlog::info("exercise {} in DDS domain {}, partition exercise/{}", def.name, options.domain,
                     options.partition);
        run(session, mailbox, publisher);
        return session.status().state == exercise::RunState::stopped_by_fault ? kStoppedByFault : kOk;
    } catch (const std::invalid_argument& error) {
        spdlog::error("exercise {}: {}", def.name, error.what());
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
