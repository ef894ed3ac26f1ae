// What the wire costs: from a command to the load topic that shows it, and what publishing asks of the
// exercise thread. README.md says how to read it.

#include "bench/process_cpu.hpp"
#include "bench/program.hpp"
#include "rigs/server_process.hpp"
#include "server/dds/publisher.hpp"
#include "server/exercise/exercise.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <mutex>

namespace {

using namespace windlass;
using Clock = std::chrono::steady_clock;

struct Options {
    double seconds = 20; // of each row
    int domain = 99;
    std::string security; // folder with identities, for rows under DDS Security
    bool realtime = false;
};

double percentile(std::vector<double>& values, double p) {
    if (values.empty()) return 0;
    const auto at = static_cast<std::size_t>(p * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    return values[at];
}

double ms(Clock::duration time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

/// Calls that many times a second, for so long; never catches up.
void paced(double rate, double seconds, const std::function<void()>& call) {
    const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / rate));
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    for (auto due = Clock::now(); due < end; due = std::max(due + period, Clock::now())) {
        std::this_thread::sleep_until(due);
        call();
    }
}

/// Commands that number themselves by the speed lever, and the loads that show them.
class Probe {
public:
    explicit Probe(const wire::JoinOptions& session) : participant_(session) {}

    bool ready() const { return levers_.matched() > 0 && loads_.matched() > 0; }
    void send() {
        WindlassCommand command;
        command.side(SIDE_PORT);
        command.brake(1);
        command.origin().source("bench");
        command.origin().serial(++sent_);
        command.origin().sent_unix_ns(std::chrono::system_clock::now().time_since_epoch().count());
        command.speed_lever(static_cast<double>(sent_) * kStep);
        {
            const std::lock_guard lock(mutex_);
            waiting_.push_back(Clock::now());
        }
        levers_.write(command);
    }
    /// From each command to the first load that shows it or a later one, ms; forgotten then.
    std::vector<double> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(latencies_, {});
    }

private:
    static constexpr double kStep = 1e-6; // the lever stays within its range for a million commands

    void hear(const WindlassLoad& load) {
        const auto now = Clock::now();
        const auto shown = static_cast<std::uint64_t>(std::llround(load.speed_lever() / kStep));
        const std::lock_guard lock(mutex_);
        for (; shown_ < shown && !waiting_.empty(); ++shown_) {
            latencies_.push_back(ms(now - waiting_.front()));
            waiting_.pop_front();
        }
    }

    std::mutex mutex_;
    std::uint64_t sent_ = 0, shown_ = 0;
    std::deque<Clock::time_point> waiting_;
    std::vector<double> latencies_;
    wire::Participant participant_;
    wire::Writer<WindlassCommand> levers_{participant_, wire::topics::windlass_command, 10};
    wire::Reader<WindlassLoad> loads_{participant_, wire::topics::windlass_load,
                                      [this](const WindlassLoad& load) { hear(load); }};
};

void fail(const std::string& text) {
    throw std::runtime_error(text);
}

void command_to_load(const Options& options, double rate, bool secure, bool realtime) {
    std::vector<std::string> arguments{
        "--domain", std::to_string(options.domain), "--partition", "bench", "--log-level", "error"};
    if (secure) arguments.insert(arguments.end(), {"--security", options.security + "/server"});
    if (realtime) arguments.emplace_back("--realtime");
    const rigs::ServerProcess server(arguments);
    Probe probe({.domain = options.domain,
                 .partition = "exercise/bench",
                 .name = "bench",
                 .security = secure ? options.security + "/trainee" : ""});
    if (!rigs::eventually([&] { return probe.ready(); })) fail("no server: " + server.text());
    const double idle_from = bench::cpu_of(server.pid());
    paced(1, 5, [] {});
    const double idle = (bench::cpu_of(server.pid()) - idle_from) / 5;
    paced(rate, 1, [&] { probe.send(); }); // what is first met is slow
    probe.take();
    const double from = bench::cpu_of(server.pid());
    const auto begin = Clock::now();
    std::size_t sent = 0;
    paced(rate, options.seconds, [&] {
        probe.send();
        ++sent;
    });
    const double busy = (bench::cpu_of(server.pid()) - from) / (ms(Clock::now() - begin) / 1000);
    auto latencies = probe.take();
    fmt::print("| {} Hz{}{} | {} of {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} % | {:.1f} % |\n", rate,
               secure ? ", secure" : "", realtime ? ", --realtime" : "", latencies.size(), sent,
               percentile(latencies, 0.5), percentile(latencies, 0.99), percentile(latencies, 1), 100 * busy,
               100 * idle);
}

/// How often this thread gave the processor up to wait for something, and how often it was taken from it.
std::pair<long, long> switches() {
    rusage used{};
    getrusage(RUSAGE_THREAD, &used);
    return {used.ru_nvcsw, used.ru_nivcsw};
}

/// What handing a snapshot over costs the exercise thread, while so many stations listen.
void hand_over(const Options& options, int stations) {
    const wire::JoinOptions session{options.domain, "exercise/bench", "bench", {}};
    wire::Participant owner(session);
    dds::PublishingPool pool(1);
    dds::Publisher publisher(owner, pool);
    std::vector<wire::Participant> members;
    std::vector<wire::Reader<ChainState>> readers;
    std::vector<wire::Reader<WindlassLoad>> loads;
    members.reserve(static_cast<std::size_t>(stations));
    for (int i = 0; i < stations; ++i) {
        auto& member = members.emplace_back(session);
        readers.emplace_back(member, wire::topics::chain_state, [](const ChainState&) {});
        loads.emplace_back(member, wire::topics::windlass_load, [](const WindlassLoad&) {});
    }
    if (!rigs::eventually([&] {
            return std::all_of(loads.begin(), loads.end(), [](const auto& r) { return r.matched() > 0; });
        }))
        fail("no match");

    exercise::Exercise exercise{exercise::ExerciseDef()};
    const double tick_rate = exercise.def().tick_rate_hz;
    exercise::Snapshot snapshot;
    exercise.view(snapshot);
    publisher.prepare(1, 2048);
    run::RunStatus run;
    run.state = exercise::RunState::running;
    run.tick_rate_hz = exercise.def().tick_rate_hz;
    std::vector<double> costs;
    long waits = 0, taken = 0;
    const auto begin = Clock::now();
    paced(tick_rate, options.seconds, [&] {
        exercise.step(1 / tick_rate);
        exercise.view(snapshot);
        const auto before = switches();
        const auto at = Clock::now();
        publisher.offer(snapshot, run, std::chrono::duration<double>(at - begin).count());
        pool.call();
        costs.push_back(ms(Clock::now() - at));
        const auto after = switches();
        waits += after.first - before.first;
        taken += after.second - before.second;
    });
    fmt::print("| {} | {} | {:.1f} | {:.1f} | {} | {} | {} |\n", stations, costs.size(),
               1000 * percentile(costs, 0.5), 1000 * percentile(costs, 0.99), waits, taken,
               publisher.dropped());
}

void report(const Options& options) {
    fmt::print("| commands | shown | p50, ms | p99, ms | max, ms | server's CPU | without commands |\n"
               "|---|---|---|---|---|---|---|\n");
    for (const double rate : {60.0, 240.0}) {
        command_to_load(options, rate, false, false);
        if (options.realtime) command_to_load(options, rate, false, true);
        if (!options.security.empty()) command_to_load(options, rate, true, false);
    }
    fmt::print("\n| stations | offers | p50, us | p99, us | waits | taken off | dropped |\n"
               "|---|---|---|---|---|---|---|\n");
    for (const int stations : {0, 1, 4})
        hand_over(options, stations);
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("bench_wire: latency from command to load topic, and the cost of publishing", "bench_wire");
    app.footer("\nExit codes: 0 done, 1 no server or no DDS, 2 bad option. Prints Markdown tables.");
    app.add_option("--seconds", options.seconds, "measured for each row")
        ->check(CLI::Range(1.0, 3600.0))
        ->capture_default_str();
    app.add_option("--domain", options.domain, "DDS domain, to itself")
        ->check(CLI::Range(0, 232))
        ->capture_default_str();
    app.add_option("--security", options.security, "folder of identities: rows under DDS Security as well")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory);
    app.add_flag("--realtime", options.realtime, "rows with the server under SCHED_FIFO as well");
    return bench::run_program(app, argc, argv, [&] { report(options); });
}
