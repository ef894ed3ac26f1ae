#pragma once
// The one part that knows wall time, pause and rate. Time is passed in; nothing here reads a clock.

#include <chrono>
#include <cstdint>

namespace windlass::host {

/// Says when the next beat is due. A beat is as many ticks as go into 10 ms, one at least. A beat
/// that ends after the next one was due is an overrun: it is counted and the time lost is not chased.
class Pacer {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// dt: s of exercise in a tick. scale: exercise seconds per wall second, 0 = as fast as possible.
    Pacer(double dt, double scale, Time now);

    void set_tick(double dt, Time now);
    void set_scale(double scale, Time now);

    /// While held back it goes no faster than real time; the scale stays as it is.
    void hold_back(bool held, Time now);

    /// While the exercise stands still, beats go on slowly, so that orders are heard.
    void set_standing(bool standing, Time now);

    /// Ticks to run in the next beat; 1 while standing, for a look at the orders.
    int ticks_per_beat() const;

    /// Beats have their times: it neither stands still nor goes as fast as it can.
    bool paced() const { return rate() > 0 && !standing_; }
    /// It goes faster than real time, or as fast as it can.
    bool hurried() const { return !standing_ && (rate() <= 0 || rate() > 1); }
    /// When the next beat is to start; when as fast as possible, the end of the last one.
    Time due() const { return due_; }

    /// To be told at the end of each beat, with the ticks that were run in it, which may be fewer than there
    /// were to run.
    void beat_ended(int ticks, Time now);

    double lateness() const { return lateness_; }        ///< s, of the last beat's end; 0 when in time
    std::uint64_t overruns() const { return overruns_; } ///< since the start
    double scale_achieved() const { return achieved_; }  ///< over the last second

private:
    double rate() const { return held_back_ && (scale_ <= 0 || scale_ > 1) ? 1 : scale_; }
    std::chrono::nanoseconds period(int ticks) const;
    void restart(Time now);
    void measure(int ticks, Time now);

    double dt_, scale_;
    bool standing_ = false, held_back_ = false;
    Time due_;

    double lateness_ = 0;
    std::uint64_t overruns_ = 0;
    Time measured_since_;
    std::int64_t ticks_measured_ = 0;
    double achieved_ = 0;
};

} // namespace windlass::host
