// Session: checkpoints, taken as the exercise goes on and gone back to.

#include "server/run/session.hpp"

#include "server/exercise/checkpoint.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace windlass::run {

using exercise::RunState;

namespace {

constexpr double kCheckpointPeriod = 10;      // s of exercise time
constexpr std::size_t kCheckpointsKept = 360; // an hour, some 10 MB

} // namespace

bool Session::checkpoint_due(std::uint64_t tick) const {
    const auto period = static_cast<std::uint64_t>(std::llround(kCheckpointPeriod * def().tick_rate_hz));
    return tick % period == 0;
}

void Session::take_checkpoint() {
    if (!checkpoints_.empty() && checkpoints_.back().tick == tick_) checkpoints_.pop_back();
    if (checkpoints_.size() == kCheckpointsKept) checkpoints_.pop_front();
    checkpoints_.push_back({.tick = tick_,
                            .time = time_,
                            .state_hash = snapshot_.state_hash,
                            .definition_hash = status_.definition_hash,
                            .run = status_.run,
                            .orders_taken = status_.orders_taken,
                            .format = exercise::kCheckpointFormat,
                            .data = state()});
    new_checkpoint_ = true;
}

std::vector<std::uint8_t> Session::state() const {
    return exercise::write_checkpoint(exercise_, &assessor_);
}

void Session::take_checkpoint_now() {
    look();
    take_checkpoint();
}

void Session::restore(double time, const std::string& source) {
    if (time > time_) { // a slip of the finger would else drop all that came after the last checkpoint
        refuse("ExerciseCommand", source, "restore_time", fmt::format("{}", time),
               fmt::format("up to {:.2f} s, the exercise's time now", time_));
        return;
    }
    const auto later = std::upper_bound(checkpoints_.begin(), checkpoints_.end(), time,
                                        [](double t, const CheckpointView& c) { return t < c.time; });
    if (later == checkpoints_.begin()) {
        refuse("ExerciseCommand", source, "restore_time", fmt::format("{}", time),
               checkpoints_.empty()
                   ? "no checkpoint has been taken"
                   : fmt::format("{:g} s or later, the oldest checkpoint kept", checkpoints_.front().time));
        return;
    }
    try {
        Kept kept = read_state(std::prev(later)->data);
        checkpoints_.erase(later, checkpoints_.end()); // what came after did not happen in this branch
        go_on_from(std::move(kept));
        forget_for_the_model();
    } catch (const exercise::CheckpointError& error) {
        refuse("ExerciseCommand", source, "restore_time", fmt::format("{}", time), error.what());
        return;
    }
    log("exercise.restored", fmt::format("exercise restored to {}, paused, by {}", clock_text(time_), source),
        -1, time_);
    brief();
}

} // namespace windlass::run
