#pragma once
// The exercise's time for a client whose own clock follows it (Foxglove's `time`).

#include "station/gateway/feed.hpp"

namespace windlass::gateway {

/// ns of exercise time, as times go over the Foxglove protocol; 0 for what is no time (negative, not finite).
std::uint64_t nanoseconds(double exercise_time);

/// Goes forward within a run and back where ExerciseStatus does: topics overtake each other, and a client
/// takes each step back for a jump in time and forgets what it drew. Pure.
class ExerciseClock {
public:
    /// ExerciseStatus was heard; time in s. True: another run begins, or time went back.
    bool hear_status(double time, std::uint64_t run);
    /// A state between two of those. One that is further ahead than the next of them may be is of a run that
    /// was left, and is not heard.
    void hear_state(double time);

    double time() const { return time_; } ///< s; 0 before the first ExerciseStatus

private:
    std::optional<std::uint64_t> run_;
    double time_ = 0;
    double status_ = 0; ///< s, of the last ExerciseStatus
    double step_ = 0;   ///< s, from the one before it
};

/// Tells the time of the exercise that a feed hears, as long as it lives.
class ClockWatch final : private Ear {
public:
    /// s of exercise time; again: another run begins, or time went back.
    using Told = std::function<void(double time, bool again)>;

    /// channels: the feed's, which outlives this. told: at each ExerciseStatus, a pause's among them, and,
    /// where ShipState is heard, at each of those; one call at a time, from any thread, quick.
    ClockWatch(Source& feed, const std::vector<Channel>& channels, Told told);
    ~ClockWatch() override;

private:
    void hear(const FramePtr& frame) override;

    Source& feed_;
    const Told told_;
    std::uint32_t status_ = 0, ship_ = 0; ///< numbers of channels; 0: not heard
    std::mutex mutex_;                    ///< of what follows
    ExerciseClock clock_;
};

} // namespace windlass::gateway
