// recorder whatif: for each lost point of a recorded lesson, the smallest change that would have kept it.

#include "lesson/whatif/words.hpp"
#include "recorder/command.hpp"
#include "recorder/resimulate/resimulation.hpp"
#include "recorder/whatif/recorded_attempt.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <ctime>
#include <iostream>

namespace windlass::recorder {

namespace {

namespace fs = std::filesystem;

struct WhatIfOptions {
    std::vector<fs::path> paths;
    std::size_t run = 0; // 1: the first; 0: the last
    std::string criterion;
    fs::path config = "config";
    bool json = false;
};

int what_if(const WhatIfOptions& options) {
    recording::Recording recording(options.paths);
    std::vector<whatif::Answer> answers;
    try {
        const whatif::Attempt attempt = recorded_attempt(recording, options.run);
        whatif::Trials trials(attempt, model_of(attempt, options.config, tell));
        const auto lost = whatif::lost_criteria(trials);
        if (!options.json)
            std::cout << fmt::format("lesson {}: {:.1f} points of 100, {} of its criteria lost points\n",
                                     trials.lesson().id, 0.1 * trials.recorded().tenths, lost.size());
        for (const std::string& criterion : lost) {
            if (!options.criterion.empty() && criterion != options.criterion) continue;
            const std::clock_t began = std::clock();
            answers.push_back(whatif::what_if(trials, criterion));
            if (!options.json)
                std::cout << whatif::answer_words(trials, answers.back()) << "\n" << std::flush;
            tell(fmt::format("{}: {} branches, {:.0f} s of exercise, {:.1f} s of the processor", criterion,
                             answers.back().tried, answers.back().gone_through,
                             static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC));
        }
        if (!options.criterion.empty() && answers.empty())
            throw std::runtime_error(options.criterion + ": nothing of it was lost");
        if (options.json) std::cout << whatif::json_of(trials, answers).dump(2) << std::endl;
    } catch (const Gap& gap) {
        std::cout << gap.what() << std::endl;
        return kDamaged;
    }
    for (const auto& damage : recording.damage())
        tell(damage);
    return recording.damage().empty() ? kOk : kDamaged;
}

} // namespace

void add_whatif(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<WhatIfOptions>();
    CLI::App& sub = *app.add_subcommand(
        "whatif", "for each lost point of a recorded lesson, the smallest change that would have kept it");
    sub.add_option("recording", options->paths, "folder of a recording, or its MCAP files")->required();
    sub.add_option("--run", options->run, "which attempt of the recording, 1: the first (default: the last)")
        ->check(CLI::Range(1, 1'000'000));
    sub.add_option("--criterion", options->criterion, "only this one, by its id");
    sub.add_option("--config", options->config, "folder with the scripts of the lesson's model run")
        ->capture_default_str();
    sub.add_flag("--json", options->json, "for programs");
    sub.footer(
        "docs/whatif.md says what is searched, how sure an answer is and what it cannot say.\n"
        "Exit codes: 0 done, 1 failed, 2 bad option, 3 an order or checkpoint that is needed is not in\n"
        "the recording, or not all of it can be read.");
    sub.callback([&chosen, options] { chosen = [options] { return what_if(*options); }; });
}

} // namespace windlass::recorder
