// Session: an exercise taken up again from a state that was kept, here or in a recording.

#include "server/run/session.hpp"

#include "common/text.hpp"
#include "server/exercise/checkpoint.hpp"
#include "server/exercise/picture/published.hpp"

#include <spdlog/fmt/fmt.h>

namespace windlass::run {

using exercise::RunState;

/// The exercise in the bytes, fit to be run. Throws exercise::CheckpointError.
Session::Kept Session::read_state(const std::vector<std::uint8_t>& checkpoint) {
    assess::Assessor assessor;
    exercise::Exercise read = exercise::read_checkpoint(checkpoint, options_.check, &assessor);
    exercise::Snapshot seen;
    read.view(seen);
    if (!is_finite(seen)) throw exercise::CheckpointError("a checkpoint of a state that is not finite");
    return {std::move(read), std::move(assessor)};
}

/// Runs on from that exercise, paused: nothing moves until somebody starts it.
void Session::go_on_from(Kept kept) {
    exercise_ = std::move(kept.exercise);
    assessor_ = std::move(kept.assessor);
    begin_run();
    lever_pickup_.hold();
    alerts_.rectify(kStopped, -1, tick_, time_);
    watch_what_stands();
    status_.state = RunState::paused;
    if (assessor_.assesses()) new_assessment_ = assessor_.result();
    tell_questions();
    take_checkpoint(); // a recording of this branch begins with it
}

void Session::carry_out(const StateOrder& order, const ReceivedOrder& from) {
    try {
        Kept brought = read_state(order.checkpoint);
        checkpoints_.clear(); // of another exercise, or another past of this one
        go_on_from(std::move(brought));
        look_for_the_beginning();
    } catch (const exercise::CheckpointError& error) {
        refuse("RestoreCommand", from.source, "checkpoint",
               fmt::format("{} bytes from {}", order.checkpoint.size(), order.from), printable(error.what()));
        return;
    }
    log("exercise.restored",
        fmt::format("exercise restored to {}, paused, from {} by {}", clock_text(time_),
                    order.from.empty() ? "a checkpoint" : order.from, from.source),
        -1, time_);
    brief();
}

} // namespace windlass::run
