// recorder resimulate: whether the recorded states come of the recorded orders, bit for bit.

#include "recorder/command.hpp"
#include "recorder/resimulate/resimulation.hpp"

#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <limits>

namespace windlass::recorder {

namespace {

struct ResimulateOptions {
    std::vector<std::filesystem::path> paths;
    std::size_t run = 0; // 1: the first; 0: all
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
};

/// Where to begin with a run; nullptr: nothing of it lies between the times.
const Mark* beginning(const Run& run, const ResimulateOptions& options) {
    const Mark* first = run.checkpoint_before(options.from);
    if (first == nullptr) first = run.first_checkpoint();
    return first != nullptr && first->time <= options.to && run.marks.back().time >= options.from ? first
                                                                                                  : nullptr;
}

int resimulate(recording::Recording& recording, const Run& run, const Mark& first, double to) {
    const auto began = std::chrono::steady_clock::now();
    Agreement found;
    try {
        found = Resimulation(recording, run, first).compare(to);
    } catch (const Gap& gap) {
        std::cout << gap.what() << std::endl;
        return kDamaged;
    }
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    std::cout << fmt::format("{} to {}, {} orders: {} state hashes and {} checkpoints are as recorded, bit "
                             "for bit ({:.0f} times real time)",
                             clock_text(found.from_time), clock_text(found.to_time), found.orders,
                             found.hashes, found.checkpoints, (found.to_time - found.from_time) / took)
              << std::endl;
    if (!found.parting) return kOk;
    std::cout << found.parting->text() << std::endl;
    return kDiffers;
}

int resimulate(const ResimulateOptions& options) {
    recording::Recording recording(options.paths);
    const auto runs = runs_of(recording);
    int code = kOk;
    std::size_t gone_through = 0;
    for (std::size_t k = 1; k <= runs.size(); ++k) {
        const Run& run = runs[k - 1];
        const Mark* first = options.run == 0 || options.run == k ? beginning(run, options) : nullptr;
        if (first == nullptr) continue;
        std::cout << fmt::format("run {} of {}, {}: ", k, runs.size(), run.exercise);
        code = std::max(code, resimulate(recording, run, *first, options.to));
        ++gone_through;
    }
    for (const auto& damage : recording.damage())
        tell(damage);
    if (gone_through == 0)
        throw std::runtime_error(
            fmt::format("{}: none of its runs ({}) has a checkpoint and states where they "
                        "were asked for",
                        recording.name(), runs.size()));
    return code == kOk && !recording.damage().empty() ? kDamaged : code;
}

} // namespace

void add_resimulate(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ResimulateOptions>();
    CLI::App& sub = *app.add_subcommand(
        "resimulate", "go through the recorded orders again, and hold what comes of them against what was");
    sub.add_option("recording", options->paths, "folder of a recording, or its MCAP files")->required();
    sub.add_option("--from", options->from,
                   "s of exercise: begin at the last checkpoint up to then, else at the first")
        ->check(number_in(0, 1e9));
    sub.add_option("--to", options->to, "s of exercise")->check(number_in(0, 1e9));
    sub.add_option("--run", options->run, "only this one, 1 for the first; default: every run");
    sub.footer(
        "A run is what lies between a set-up, load, reset or restore and the next.\n"
        "Exit codes: 0 bit for bit the recorded states, 1 failed, 2 bad option, 3 an order or\n"
        "checkpoint that is needed is not in the recording, or not all of it can be read, 6 the states\n"
        "differ; the text says from which tick on, and in which fields.");
    sub.callback([&chosen, options] { chosen = [options] { return resimulate(*options); }; });
}

} // namespace windlass::recorder
