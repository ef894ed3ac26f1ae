// windlass_sim: centres drawn from seeds, each with its floods, losses and crashes, and what must hold of
// them.

#include "server/config/config.hpp"
#include "server/exercise/prelude.hpp"
#include "sim/centre.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <iostream>

namespace {

constexpr int kFailed = 1, kBadExercise = 2;

std::string line(std::uint64_t seed, const windlass::sim::Outcome& found) {
    return fmt::format(
        "seed {}: {} ticks in {:.0f} s, {} kills, {} power cuts, {} taken up, {} set back, {} begun anew, "
        "{} rotten, {} left, {} predictions, {} takings, {} questions, {} answered, {} passed over, {} stood "
        "again, {} recordings, {} recorder kills, {} pages, {} sent away, {} taken from pages, "
        "{} stations killed, digest {:016x}",
        seed, found.ticks, found.simulated, found.kills, found.power_cuts, found.taken_up, found.set_back,
        found.anew, found.rotten, found.left, found.predictions, found.takings, found.questions,
        found.answered, found.passed_over, found.stood_again, found.recordings, found.recorder_kills,
        found.pages, found.sent_away, found.taken, found.stations, found.digest);
}

} // namespace

int main(int argc, char** argv) {
    using namespace windlass;
    std::uint64_t seed = 1, seeds = 1;
    std::filesystem::path exercise;
    sim::Plan plan;
    CLI::App app("Runs simulated centres, each drawn from its seed: a server that keeps its exercise, "
                 "stations and a recorder, on a simulated clock, network and disks. Prints a line for each; "
                 "ends with the first that fails a check.",
                 "windlass_sim");
    app.add_option("SEED", seed, "The first seed")->required()->check(CLI::NonNegativeNumber);
    app.add_option("--seeds", seeds, "How many, one after the other")
        ->check(CLI::Range(1, 100'000'000))
        ->capture_default_str();
    app.add_option("--exercise", exercise, "Exercise file; without it, one that is drawn")
        ->check(CLI::ExistingFile);
    app.add_option("--minutes", plan.minutes, "Minutes of exercise for each seed")
        ->check(CLI::Range(0.1, 600.0))
        ->capture_default_str();
    app.add_flag_callback(
        "--story",
        [&] {
            plan.story = [](double at, const std::string& what) {
                std::cout << fmt::format("{:9.3f} {}\n", at, what);
            };
        },
        "Also what is drawn, and when");
    CLI11_PARSE(app, argc, argv);
    try {
        if (!exercise.empty()) plan.def = exercise::with_prelude_played(config::load_exercise(exercise));
        const auto began = std::chrono::steady_clock::now();
        double exercised = 0;
        for (std::uint64_t k = 0; k < seeds; ++k) {
            plan.seed = seed + k;
            const sim::Outcome found = sim::run(plan);
            std::cout << line(plan.seed, found) << std::endl;
            exercised += found.exercised;
            if (!found.failed) continue;
            const auto& [what, tick, at] = *found.failed;
            std::cout << fmt::format(
                             "FAILED, seed {} at tick {}, {:.3f} s: {}\n  expected {}\n  found    {}\n"
                             "again with: windlass_sim {} --minutes {}{}",
                             plan.seed, tick, at, what.check, what.expected, what.found, plan.seed,
                             plan.minutes, exercise.empty() ? "" : " --exercise " + exercise.string())
                      << std::endl;
            return kFailed;
        }
        const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        std::cout << fmt::format("{} seeds, {:.0f} s of exercise in {:.1f} s: {:.0f} times real time", seeds,
                                 exercised, took, exercised / took)
                  << std::endl;
    } catch (const std::exception& error) {
        std::cerr << "windlass_sim: " << error.what() << std::endl;
        return kBadExercise;
    }
    return 0;
}
