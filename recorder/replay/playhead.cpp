#include "recorder/replay/playhead.hpp"

#include <algorithm>

namespace windlass::recorder {

using Seconds = std::chrono::duration<double>;

double Playhead::position(Time now) const {
    if (!playing_) return anchor_;
    return std::clamp(anchor_ + Seconds(now - anchor_time_).count() * speed_, 0.0, duration_);
}

Playhead::Time Playhead::due(double position) const {
    return anchor_time_ + std::chrono::duration_cast<Clock::duration>(Seconds((position - anchor_) / speed_));
}

void Playhead::play(Time now) {
    seek(position(now), now);
    playing_ = true;
}

void Playhead::pause(Time now) {
    seek(position(now), now);
    playing_ = false;
}

void Playhead::seek(double position, Time now) {
    anchor_ = std::clamp(position, 0.0, duration_);
    anchor_time_ = now;
}

void Playhead::set_speed(double speed, Time now) {
    seek(position(now), now);
    speed_ = std::clamp(speed, kSlowest, kFastest);
}

} // namespace windlass::recorder
