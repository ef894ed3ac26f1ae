// How many exercises one server carries at 1 x real time. README.md says how to read it.

#include "bench/process_cpu.hpp"
#include "idl/wire.hpp"
#include "rigs/server_process.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <mutex>

namespace {

using namespace windlass;

struct Options {
    double seconds = 15; // of each row, exercise and wall alike
    int domain = 98;
    double swell = 0; // m
    std::vector<int> exercises{1, 8, 16, 32, 48, 64};
};

/// The anchor hangs 5 m out: a twentieth of the brake is more than its weight. swell: m, its
/// height; a wind sea of a third of it comes with it.
std::filesystem::path hanging_anchor(double swell) {
    const auto file =
        std::filesystem::temp_directory_path() / fmt::format("bench_classroom_{}.json", getpid());
    std::ofstream(file) << fmt::format(
        R"({{"from": "let_go_port_25m", "name": "bench",
        "environment": {{"swell_height": {}, "swell_period": 11, "wave_height": {}, "wave_period": 4.5}},
        "tackle": [{{"side": "port", "brake": 0.05, "windlass": {{"from": "electric_78mm"}},
        "chain": {{"from": "stud_link_78mm_k3"}}, "anchor": {{"from": "stockless_9900"}}, "cable_out": 5}}]}})",
        swell, 0.3 * swell);
    return file;
}

/// Hears all that the server says, in every partition, as one station beside each trainee would.
class Listener {
public:
    explicit Listener(int domain)
        : classroom_({domain, wire::kClassroomPartition, "bench", {}, {}}),
          exercises_(classroom_, wire::exercise_partition("*")) {}

    ClassroomStatus status() const {
        const std::lock_guard lock(mutex_);
        return last_;
    }
    int matched() const { return chains_.matched(); }

private:
    mutable std::mutex mutex_;
    ClassroomStatus last_;
    wire::Participant classroom_, exercises_;
    wire::Reader<ClassroomStatus> statuses_{classroom_, wire::topics::classroom_status,
                                            [this](const auto& status) {
                                                const std::lock_guard lock(mutex_);
                                                last_ = status;
                                            }};
    wire::Reader<ChainState> chains_{exercises_, wire::topics::chain_state, [](const auto&) {}};
    wire::Reader<WindlassLoad> loads_{exercises_, wire::topics::windlass_load, [](const auto&) {}};
    wire::Reader<ShipState> ships_{exercises_, wire::topics::ship_state, [](const auto&) {}};
};

struct Sum {
    std::uint64_t ticks = 0, overruns = 0;
    double load = 0, lateness = 0;
    double slowest = 1; // exercise seconds per second
};

Sum sum(const ClassroomStatus& status) {
    Sum sum;
    for (const auto& one : status.exercises()) {
        sum.ticks += one.tick();
        sum.overruns += one.overruns();
        sum.load += one.load();
        sum.lateness = std::max(sum.lateness, one.lateness());
        sum.slowest = std::min(sum.slowest, one.time_scale_achieved());
    }
    return sum;
}

void row(const Options& options, const std::filesystem::path& exercise, int count) {
    std::vector<std::string> arguments{"--domain",      std::to_string(options.domain),
                                       "--threads",     "1",
                                       "--config-root", WINDLASS_CONFIG_DIR,
                                       "--log-level",   "error"};
    for (int i = 0; i < count; ++i)
        arguments.insert(arguments.end(),
                         {"--exercise", exercise.string(), "--partition", fmt::format("e{}", i)});
    const Listener listener(options.domain);
    const test::ServerProcess server(arguments);
    if (!test::eventually([&] {
            return listener.matched() == count && listener.status().exercises().size() == std::size_t(count);
        }))
        throw std::runtime_error("no server: " + server.text());
    const auto wait = [&](double s) { std::this_thread::sleep_for(std::chrono::duration<double>(s)); };
    wait(1); // what is first met is slow
    const double from = bench::cpu_of(server.pid());
    const auto begin = std::chrono::steady_clock::now();
    const Sum before = sum(listener.status());
    double lateness = 0;
    for (double waited = 0; waited < options.seconds; waited += 0.5) {
        wait(0.5);
        lateness = std::max(lateness, sum(listener.status()).lateness);
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    const double cpu = (bench::cpu_of(server.pid()) - from) / elapsed.count();
    const Sum after = sum(listener.status());
    const auto ticks = static_cast<double>(after.ticks - before.ticks);
    fmt::print("| {} | {:.1f} % | {:.2f} % | {:.1f} % | {:.2f} | {:.1f} % | {:.1f} |\n", count, 100 * cpu,
               100 * cpu / count, 100 * after.load, after.slowest,
               100 * static_cast<double>(after.overruns - before.overruns) / ticks, 1000 * lateness);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("bench_classroom: exercises side by side at 1 x real time, ticked by one thread",
                 "bench_classroom");
    app.footer("\nExit codes: 0 done, 1 no server or no DDS, 2 bad option. Prints a Markdown table.");
    app.add_option("--seconds", options.seconds, "measured for each row")
        ->check(CLI::Range(1.0, 3600.0))
        ->capture_default_str();
    app.add_option("--exercises", options.exercises, "how many, one row each")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--swell", options.swell, "m, height of a swell of 11 s, with a wind sea of 0.3 of it")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    app.add_option("--domain", options.domain, "DDS domain, to itself")
        ->check(CLI::Range(0, 232))
        ->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    const auto exercise = hanging_anchor(options.swell);
    int code = 0;
    try {
        fmt::print("| exercises | server's CPU, of a core | for each | tick thread busy | slowest, x real "
                   "time | late "
                   "ticks | "
                   "latest, ms |\n|---|---|---|---|---|---|---|\n");
        for (const int count : options.exercises)
            row(options, exercise, count);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_classroom: {}\n", error.what());
        code = 1;
    }
    std::filesystem::remove(exercise);
    return code;
}
