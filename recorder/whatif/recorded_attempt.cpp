#include "recorder/whatif/recorded_attempt.hpp"

#include "recorder/resimulate/resimulation.hpp"
#include "server/config/config.hpp"

#include <fmt/format.h>

namespace windlass::recorder {

namespace {

/// What of a run goes into an attempt.
struct End {
    std::uint64_t tick = UINT64_MAX, last_order = UINT64_MAX;
};

/// What of a run has gone into the state in which the exercise was taken up, after its server was lost. The
/// rest was lost with the server: nearly always it is nothing.
End kept_of(const Run& run, const Mark& taken_up) {
    End end{.tick = taken_up.tick, .last_order = 0};
    for (const run::OrderView& order : run.orders)
        if (order.tick <= end.tick) end.last_order = order.number;
    if (run.marks.back().tick > end.tick) // set back to a checkpoint, or the power was cut
        for (const Mark& mark : run.marks)
            if (mark.checkpoint && mark.tick == end.tick) end.last_order = mark.orders_taken;
    return end;
}

/// Puts a run behind those before it, whose orders are as many.
void put_behind(whatif::Attempt& attempt, recording::Recording& recording, const Run& run, const End& end,
                std::uint64_t orders_before) {
    const Mark* const first = run.first_checkpoint();
    if (first == nullptr) throw Gap("no Checkpoint of the run is in the recording");
    const auto before_end = [&](const Mark& mark) {
        return mark.tick <= end.tick && mark.orders_taken <= end.last_order;
    };
    std::uint64_t last_order = end.last_order == UINT64_MAX ? 0 : end.last_order;
    for (const Mark& mark : run.marks) {
        if (!before_end(mark)) continue;
        attempt.last_tick = mark.tick;
        last_order = std::max(last_order, mark.orders_taken);
        if (mark.checkpoint)
            attempt.checkpoints.push_back({.tick = mark.tick,
                                           .time = mark.time,
                                           .state_hash = mark.state_hash,
                                           .run = run.number,
                                           .orders_taken = orders_before + mark.orders_taken,
                                           .data = checkpoint_bytes(recording, run, mark)});
    }
    std::uint64_t next = first->orders_taken + 1;
    for (const run::OrderView& order : run.orders) {
        if (order.number < next || order.number > end.last_order) continue;
        if (order.number > next) break;
        attempt.orders.push_back(order);
        attempt.orders.back().number += orders_before;
        ++next;
    }
    if (next <= last_order) throw Gap(fmt::format("order {} is not in the recording", next));
}

} // namespace

whatif::Attempt recorded_attempt(recording::Recording& recording, std::span<const Run> runs) {
    whatif::Attempt attempt;
    attempt.check = config::check_definition;
    std::uint64_t orders_before = 0;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        End end;
        if (k + 1 < runs.size()) end = kept_of(runs[k], *runs[k + 1].first_checkpoint());
        put_behind(attempt, recording, runs[k], end, orders_before);
        orders_before += end.last_order;
    }
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
    const auto attempts = attempts_of(runs);
    const std::size_t wanted = run == 0 ? attempts.size() : run;
    if (wanted == 0 || wanted > attempts.size())
        throw std::runtime_error(fmt::format("{}: has {} runs", recording.name(), attempts.size()));
    return recorded_attempt(recording, attempts[wanted - 1]);
}

} // namespace windlass::recorder
