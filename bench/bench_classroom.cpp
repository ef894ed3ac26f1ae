// How many exercises one server carries at 1 x real time. README.md says how to read it.

#include "bench/measured_server.hpp"
#include "bench/process_cpu.hpp"
#include "bench/program.hpp"
#include "bench/where.hpp"
#include "idl/wire.hpp"
#include "rigs/server_process.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <regex>

namespace {

using namespace windlass;
using Clock = std::chrono::steady_clock;

constexpr int kMost = 448; // that a process takes

struct Options {
    double seconds = 15;            // of each row, exercise and wall alike
    std::filesystem::path exercise; // empty: an anchor that hangs on its brake
    double swell = 0;               // m, about that
    bench::MeasuredServer server;
    std::string hear = "truth";
    bool predict = false; // a minute ahead, for each exercise
    bool where = false;
    std::vector<int> exercises{1, 8, 64, 200};
};

/// An anchor that hangs 5 m out on its brake, beside the ship's side: a twentieth of the brake is more than
/// its weight. swell: m, its height; a wind sea of a third of it comes with it.
std::filesystem::path hanging_anchor(double swell) {
    auto file = std::filesystem::temp_directory_path() / fmt::format("bench_classroom_{}.json", getpid());
    std::ofstream(file) << fmt::format(
        R"({{"from": "let_go_port_25m", "name": "bench",
        "environment": {{"swell_height": {}, "swell_period": 11, "wave_height": {}, "wave_period": 4.5}},
        "tackle": [{{"side": "port", "brake": 0.6, "windlass": {{"from": "electric_78mm"}},
        "chain": {{"from": "stud_link_78mm_k3"}}, "anchor": {{"from": "stockless_9900"}}, "cable_out": 5}}]}})",
        swell, 0.3 * swell);
    return file;
}

/// Hears the list of exercises, and in every partition what one station for each exercise would.
class Listener {
public:
    /// hear: "seats", the views of forecastle and bridge; "truth", chain, load and ship, as an instructor's
    /// page; "nobody".
    Listener(int domain, const std::string& hear)
        : classroom_({domain, wire::kClassroomPartition, "bench", {}, {}}),
          exercises_(classroom_, wire::exercise_partition("*")) {
        const auto count = [this](const auto&) { ++samples_; };
        if (hear == "seats") {
            forecastles_.emplace(exercises_, wire::topics::forecastle_view, count);
            bridges_.emplace(exercises_, wire::topics::bridge_view, count);
        } else if (hear == "truth") {
            chains_.emplace(exercises_, wire::topics::chain_state, count);
            loads_.emplace(exercises_, wire::topics::windlass_load, count);
            ships_.emplace(exercises_, wire::topics::ship_state, count);
        }
    }

    /// Of all servers that the process is.
    std::vector<ClassroomExercise> exercises() const {
        const std::lock_guard lock(mutex_);
        std::vector<ClassroomExercise> all;
        for (const auto& [server, status] : last_)
            all.insert(all.end(), status.exercises().begin(), status.exercises().end());
        return all;
    }
    bool hears(int count) const {
        return exercises().size() == static_cast<std::size_t>(count) && orders_.matched() == count &&
               (!bridges_ || bridges_->matched() == count) && (!ships_ || ships_->matched() == count);
    }
    std::uint64_t samples() const { return samples_; }
    std::uint64_t predictions() const { return predictions_; }
    /// Has every exercise look a minute ahead from now on.
    void predict() {
        ExerciseCommand order;
        order.origin().source("bench");
        order.origin().serial(1);
        order.action(EXERCISE_PREDICT);
        order.predict(true);
        orders_.write(order);
    }

private:
    mutable std::mutex mutex_;
    std::map<std::string, ClassroomStatus> last_; // by server
    std::atomic<std::uint64_t> samples_{0}, predictions_{0};
    wire::Participant classroom_, exercises_;
    wire::Reader<ClassroomStatus> statuses_{classroom_, wire::topics::classroom_status,
                                            [this](const auto& status) {
                                                const std::lock_guard lock(mutex_);
                                                last_[status.server().to_string()] = status;
                                            }};
    wire::Writer<ExerciseCommand> orders_{exercises_, wire::topics::exercise_command};
    wire::Reader<Prediction> told_{exercises_, wire::topics::prediction, [this](const Prediction& told) {
                                       if (!told.moments().empty()) ++predictions_;
                                   }};
    std::optional<wire::Reader<ForecastleView>> forecastles_;
    std::optional<wire::Reader<BridgeView>> bridges_;
    std::optional<wire::Reader<ChainState>> chains_;
    std::optional<wire::Reader<WindlassLoad>> loads_;
    std::optional<wire::Reader<ShipState>> ships_;
};

struct Sum {
    std::uint64_t ticks = 0, overruns = 0;
    double slowest = 1; // exercise seconds per second
};

Sum sum(const std::vector<ClassroomExercise>& exercises) {
    Sum sum;
    for (const auto& one : exercises) {
        sum.ticks += one.tick();
        sum.overruns += one.overruns();
        sum.slowest = std::min(sum.slowest, one.time_scale_achieved());
    }
    return sum;
}

/// What the server says of how late beats began, in ms: the worst 5 s of all that it says in the text.
struct Late {
    double half = 0, most = 0, all = 0;
};

Late late(const std::string& text) {
    static const std::regex line(
        R"(half within ([\d.]+) ms of their time, 99 % within ([\d.]+), all within ([\d.]+))");
    Late worst;
    for (std::sregex_iterator at(text.begin(), text.end(), line), end; at != end; ++at) {
        worst.half = std::max(worst.half, std::stod((*at)[1]));
        worst.most = std::max(worst.most, std::stod((*at)[2]));
        worst.all = std::max(worst.all, std::stod((*at)[3]));
    }
    return worst;
}

void wait(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

double since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
}

/// Of all processes that the server is.
struct Processes {
    std::vector<pid_t> all;

    explicit Processes(const rigs::ServerProcess& server) : all(bench::family_of(server.pid())) {}
    template <class Of>
    auto sum(Of of) const {
        decltype(of(pid_t())) sum = 0;
        for (const pid_t pid : all)
            sum += of(pid);
        return sum;
    }
    double cpu() const { return sum(bench::cpu_of); }
    std::map<std::string, double> cpu_by_thread() const {
        std::map<std::string, double> sum;
        for (const pid_t pid : all)
            for (const auto& [name, seconds] : bench::cpu_by_thread(pid))
                sum[name] += seconds;
        return sum;
    }
};

/// Where the server's log is now; what is said from here on may begin with what was before.
std::size_t said_by(const rigs::ServerProcess& server) {
    const std::string text = server.text();
    const auto told = text.rfind("beats begun");
    return told == std::string::npos ? text.size() : text.find('\n', told);
}

void row(const Options& options, const std::filesystem::path& exercise, int count) {
    std::vector<std::string> arguments = options.server.arguments();
    arguments.insert(arguments.end(), {"--log-level", "debug"});
    for (int i = 0; i < count; ++i)
        arguments.insert(arguments.end(),
                         {"--exercise", exercise.string(), "--partition", fmt::format("e{}", i)});
    Listener listener(options.server.domain, options.hear);
    const auto started = Clock::now();
    const rigs::ServerProcess server(arguments);
    while (!listener.hears(count)) {
        if (since(started) > 120) throw std::runtime_error("no server: " + server.text());
        wait(0.05);
    }
    const double heard = since(started);
    if (options.predict) listener.predict();
    wait(6); // what is first met is slow; and of the lateness there is a line every 5 s
    const std::size_t said = said_by(server);
    const Processes processes(server);
    const auto from = processes.cpu_by_thread();
    const double cpu_from = processes.cpu();
    const auto begin = Clock::now();
    const Sum before = sum(listener.exercises());
    const std::uint64_t samples = listener.samples(), predictions = listener.predictions();
    wait(options.seconds);
    const double elapsed = since(begin);
    const double cpu = (processes.cpu() - cpu_from) / elapsed;
    const auto threads = processes.cpu_by_thread();
    const auto per_exercise = [&](const char* name) { // ms a second
        const auto was = from.find(name), is = threads.find(name);
        return was == from.end() || is == threads.end() ? 0
                                                        : 1000 * (is->second - was->second) / elapsed / count;
    };
    const Sum after = sum(listener.exercises());
    const auto ticks = static_cast<double>(after.ticks - before.ticks);
    const Late lateness = late(server.text().substr(said));
    fmt::print(
        "| {} | {:.1f} % | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} "
        "% | {:.1f} | {:.0f} | {:.1f} | {:.0f} | {} |",
        count, 100 * cpu, 1000 * cpu / count, per_exercise("tick"), per_exercise("publish"),
        per_exercise("dds"), lateness.half, lateness.most, lateness.all, after.slowest,
        100 * static_cast<double>(after.overruns - before.overruns) / ticks, heard,
        static_cast<double>(listener.samples() - samples) / elapsed / count,
        processes.sum(bench::memory_of) / count, processes.sum(bench::share_of_memory),
        processes.sum([&](pid_t pid) { return bench::participants_of(pid, options.server.domain); }));
    if (options.predict)
        fmt::print(" {:.1f} | {:.2f} |", per_exercise("lookout"),
                   static_cast<double>(listener.predictions() - predictions) / elapsed / count);
    fmt::print("\n");
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("bench_classroom: exercises side by side at 1 x real time", "bench_classroom");
    app.footer("\nExit codes: 0 done, 1 no server or no DDS, 2 bad option. Prints a Markdown table.");
    app.add_option("--seconds", options.seconds, "measured for each row")
        ->check(CLI::Range(5.0, 3600.0))
        ->capture_default_str();
    app.add_option("--exercises", options.exercises, "how many, one row each")
        ->check(CLI::Range(1, kMost))
        ->capture_default_str();
    app.add_flag("--predict", options.predict, "each exercise looks a minute ahead, again and again");
    app.add_option("--hear", options.hear, "what is heard of each exercise: seats, truth or nobody")
        ->check(CLI::IsMember({"seats", "truth", "nobody"}))
        ->capture_default_str();
    app.add_flag(
        "--where", options.where,
        "what each millisecond of a tick thread goes to, of one exercise alone, in place of the rows");
    app.add_option("--exercise", options.exercise, "in place of an anchor that hangs on its brake")
        ->type_name("FILE")
        ->check(CLI::ExistingFile);
    app.add_option("--swell", options.swell, "m, about the anchor that hangs on its brake")
        ->check(CLI::Range(0.0, 4.0))
        ->excludes("--exercise");
    options.server.add_options(app);
    std::filesystem::path own;
    const int code = bench::run_program(app, argc, argv, [&] {
        own = hanging_anchor(options.swell);
        const auto exercise = options.exercise.empty() ? own : options.exercise;
        if (options.where) {
            bench::tell_where(exercise, options.seconds, options.server.domain);
        } else {
            fmt::print("| exercises | server's CPU, of a core | ms/s each | ticks | publishing | DDS | half "
                       "late, ms | 99 % | all | slowest, x real time | overruns | heard after, s | samples/s "
                       "each | MB each | MB in all (PSS) | DDS participants "
                       "|{}\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|{}\n",
                       options.predict ? " ahead, ms/s each | predictions/s each |" : "",
                       options.predict ? "---|---|" : "");
            for (const int count : options.exercises)
                row(options, exercise, count);
        }
    });
    std::filesystem::remove(own);
    return code;
}
