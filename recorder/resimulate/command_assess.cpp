// recorder assess: the marks of a recorded lesson, computed again and held against the recorded ones.

#include "recorder/command.hpp"
#include "recorder/resimulate/reassessment.hpp"

#include <fmt/format.h>

#include <iostream>

namespace windlass::recorder {

namespace {

void print(const Reassessed& one) {
    const assess::Result& result = one.result;
    std::cout << fmt::format("run {}, lesson {}: {}.{} of 100 points, {}{}; hash {:016x}\n", one.run,
                             one.lesson, result.tenths / 10, result.tenths % 10,
                             result.finished ? assess::outcome_name(result.outcome) : "still running",
                             result.abort.empty() ? "" : ", ended: " + result.abort, result.assessment_hash);
    for (const assess::CriterionResult& criterion : result.criteria)
        std::cout << fmt::format("  {:<22} {:>4} of 1000, weight {:>3}  {}\n", criterion.code,
                                 criterion.milli, criterion.weight, criterion.reason);
}

int assess_again(const std::vector<std::filesystem::path>& paths) {
    recording::Recording recording(paths);
    Reassessment found;
    try {
        found = reassess(recording);
    } catch (const Gap& gap) {
        std::cout << gap.what() << std::endl;
        return kDamaged;
    }
    for (const auto& damage : recording.damage())
        tell(damage);
    if (found.runs.empty())
        throw std::runtime_error(fmt::format("{}: none of its runs has a lesson", recording.name()));
    for (const Reassessed& one : found.runs)
        print(one);
    std::cout << fmt::format("{} of {} recorded assessments come out again, bit for bit", found.equal,
                             found.recorded)
              << std::endl;
    if (found.equal != found.recorded) {
        std::cout << found.first_that_differs << std::endl;
        return kDiffers;
    }
    return recording.damage().empty() ? kOk : kDamaged;
}

} // namespace

void add_assess(CLI::App& app, Command& chosen) {
    auto paths = std::make_shared<std::vector<std::filesystem::path>>();
    CLI::App& sub = *app.add_subcommand(
        "assess", "mark a recorded lesson again, and hold the marks against the recorded ones");
    sub.add_option("recording", *paths, "folder of a recording, or its MCAP files")->required();
    sub.footer(
        "Exit codes: 0 bit for bit the recorded marks, 1 failed, 2 bad option, 3 an order or checkpoint\n"
        "that is needed is not in the recording, or not all of it can be read, 6 the marks differ.");
    sub.callback([&chosen, paths] { chosen = [paths] { return assess_again(*paths); }; });
}

} // namespace windlass::recorder
