#pragma once
// Where a replay is: recorded time against wall time, with pause, seek and speed.

#include <chrono>

namespace windlass::recorder {

class Playhead {
public:
    using Clock = std::chrono::steady_clock;
    using Time = Clock::time_point;

    static constexpr double kSlowest = 0.1, kFastest = 10;

    /// Paused at the beginning. duration in s of recorded time.
    explicit Playhead(double duration) : duration_(duration) {}

    void play(Time now);
    void pause(Time now);
    void seek(double position, Time now); ///< s, held to 0..duration
    void set_speed(double speed, Time now);

    double position(Time now) const; ///< s, 0..duration
    /// When the position is reached, if nothing is ordered before. Playing only.
    Time due(double position) const;

    bool playing() const { return playing_; }
    double speed() const { return speed_; }
    double duration() const { return duration_; }

private:
    double duration_;
    double speed_ = 1;
    bool playing_ = false;
    double anchor_ = 0; // position at anchor_time_
    Time anchor_time_{};
};

} // namespace windlass::recorder
