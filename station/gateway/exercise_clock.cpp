#include "station/gateway/exercise_clock.hpp"

#include "idl/payload.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace windlass::gateway {

std::uint64_t nanoseconds(double exercise_time) {
    constexpr double kMost = 9e9; // s, within 64 bits with a sign, which the client library of Foxglove reads
    return exercise_time > 0 ? static_cast<std::uint64_t>(std::llround(std::min(exercise_time, kMost) * 1e9))
                             : 0;
}

bool ExerciseClock::hear_status(double time, std::uint64_t run) {
    const bool first = !run_, again = !first && (run != *run_ || time < status_);
    step_ = first || again ? 0 : time - status_;
    status_ = time;
    run_ = run;
    time_ = again ? time : std::max(time_, time);
    return again;
}

void ExerciseClock::hear_state(double time) {
    constexpr double kLate = 2; // a status that is as late as another step
    if (time <= status_ + kLate * step_) time_ = std::max(time_, time);
}

ClockWatch::ClockWatch(Source& feed, const std::vector<Channel>& channels, Told told)
    : feed_{feed},
      told_{std::move(told)},
      status_{number_of(channels, wire::topics::exercise_status)},
      ship_{number_of(channels, wire::topics::ship_state)} {
    for (const std::uint32_t channel : {status_, ship_})
        feed_.listen(channel, *this, [this](const std::vector<FramePtr>& kept) {
            if (!kept.empty()) hear(kept.back());
        });
}

ClockWatch::~ClockWatch() {
    feed_.leave(*this);
}

void ClockWatch::hear(const FramePtr& frame) {
    const std::scoped_lock lock{mutex_};
    bool again = false;
    if (frame->channel == ship_) {
        clock_.hear_state(frame->time);
    } else {
        try {
            const auto status = wire::decode<ExerciseStatus>(frame->payload);
            again = clock_.hear_status(status.time(), status.run());
        } catch (const std::exception&) {
            return; // of a writer that is no server of ours
        }
    }
    told_(clock_.time(), again);
}

} // namespace windlass::gateway
