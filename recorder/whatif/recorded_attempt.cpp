#include "recorder/whatif/recorded_attempt.hpp"

#include "recorder/resimulate/resimulation.hpp"
#include "server/config/config.hpp"

#include <fmt/format.h>

namespace windlass::recorder {

whatif::Attempt recorded_attempt(recording::Recording& recording, const Run& run) {
    whatif::Attempt attempt;
    attempt.check = config::check_definition;
    for (const Mark& mark : run.marks)
        if (mark.checkpoint)
            attempt.checkpoints.push_back({.tick = mark.tick,
                                           .time = mark.time,
                                           .state_hash = mark.state_hash,
                                           .run = run.number,
                                           .orders_taken = mark.orders_taken,
                                           .data = checkpoint_bytes(recording, run, mark)});
    if (attempt.checkpoints.empty()) throw Gap("no Checkpoint of the run is in the recording");
    std::uint64_t next = attempt.checkpoints.front().orders_taken + 1;
    for (const run::OrderView& order : run.orders) {
        if (order.number < next) continue;
        if (order.number > next) throw Gap(fmt::format("order {} is not in the recording", next));
        attempt.orders.push_back(order);
        ++next;
    }
    if (next <= run.marks.back().orders_taken)
        throw Gap(fmt::format("order {} is not in the recording", next));
    attempt.last_tick = run.marks.back().tick;
    return attempt;
}

std::vector<std::string> model_scripts(const whatif::Attempt& attempt) {
    assess::Assessor assessor;
    exercise::read_checkpoint(attempt.checkpoints.front().data, attempt.check, &assessor);
    return assessor.lesson() == nullptr ? std::vector<std::string>() : assessor.lesson()->model_run.scripts;
}

std::vector<trainee::Script> model_of(const whatif::Attempt& attempt, const std::filesystem::path& config,
                                      const Tell& tell) {
    std::vector<trainee::Script> model;
    for (const std::string& script : model_scripts(attempt)) {
        const std::filesystem::path file = config / script;
        if (!std::filesystem::exists(file)) {
            tell(fmt::format("{}: is not there, so that the model run is not tried; --config says where the "
                             "lesson's scripts are",
                             file.string()));
            return {};
        }
        model.push_back(trainee::load_script(file, trainee::Eyes::seat));
    }
    return model;
}

whatif::Attempt recorded_attempt(recording::Recording& recording, std::size_t run) {
    const auto runs = runs_of(recording);
    const std::size_t wanted = run == 0 ? runs.size() : run;
    if (wanted == 0 || wanted > runs.size())
        throw std::runtime_error(fmt::format("{}: has {} runs", recording.name(), runs.size()));
    return recorded_attempt(recording, runs[wanted - 1]);
}

} // namespace windlass::recorder
