#pragma once
// A quantity over the time of exercise, thin enough to be drawn, with the extremes of all that was recorded.

#include <cstddef>
#include <optional>
#include <vector>

namespace windlass::debrief {

/// Of any quantity, in the unit of its curve.
struct Sample {
    double time = 0; ///< s of exercise
    double value = 0;
};

/// Of each interval the first, the least, the largest and the last sample are kept, so that no peak is lost.
class Series {
public:
    /// interval: s of exercise, positive.
    explicit Series(double interval) : interval_(interval) {}
    Series() = default;

    /// Times must not fall. A value that is no number is left out.
    void add(double time, double value);

    bool empty() const { return !last_; }
    std::optional<Sample> largest() const; ///< the first of equal ones
    std::optional<Sample> least() const;
    /// The same of what came at or before that time.
    std::optional<Sample> largest_until(double time) const;
    std::optional<Sample> least_until(double time) const;
    const std::optional<Sample>& last() const { return last_; }

    /// What is drawn, by time.
    std::vector<Sample> samples() const;
    /// The last of them at or before that time; nothing before the first.
    std::optional<double> at(double time) const;

private:
    struct Interval {
        Sample first, least, largest, last;
    };
    double interval_ = 1;
    std::vector<Interval> intervals_;
    std::vector<Sample> rises_, falls_; ///< each that was larger, or smaller, than all before it
    std::optional<Sample> last_;
};

} // namespace windlass::debrief
