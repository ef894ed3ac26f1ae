#pragma once
// How an exercise gets on where this program runs. Time is passed in.

#include "station/picture.hpp"

#include <optional>
#include <string>

namespace windlass::trainee {

/// Holds the time of an exercise that runs against a clock. What is asked of an exercise goes by its own
/// time, however slow the machine: the clock tells only that it gets on no more, and how fast it does.
class Progress {
public:
    using Time = station::Clock::time_point;

    /// s of wall time that a running exercise may stand still.
    static constexpr double kStandstill = 60;

    /// time: s of exercise, the newest heard. time_scale: as asked for; 0: as fast as possible. To be called
    /// every second or more often; what goes by between is not told apart.
    void look(double time, double time_scale, bool running, Time now);

    /// It runs, and its time has not moved for kStandstill.
    bool stands_still() const { return stood_ > kStandstill; }

    /// It ran for a second at least, at less than 0.9 of what was asked.
    bool slow() const;

    /// "this machine runs at x6.2 of the x10 asked"; of one that has not run for a second: "this machine has
    /// not run the exercise for a second yet".
    std::string speed() const;

private:
    struct Look {
        double time;
        Time at;
    };
    std::optional<Look> last_; // while it runs
    double scale_ = 1;
    double stood_ = 0;               // s of wall time since its time moved
    double time_run_ = 0, wall_ = 0; // s, of exercise and of wall, while it ran
};

} // namespace windlass::trainee
