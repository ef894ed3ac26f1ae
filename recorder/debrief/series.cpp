#include "recorder/debrief/series.hpp"

#include <algorithm>
#include <cmath>

namespace windlass::debrief {

void Series::add(double time, double value) {
    if (!std::isfinite(time) || !std::isfinite(value)) return;
    const Sample sample{time, value};
    if (intervals_.empty() ||
        std::floor(intervals_.back().last.time / interval_) != std::floor(time / interval_))
        intervals_.push_back({sample, sample, sample, sample});
    Interval& now = intervals_.back();
    now.last = sample;
    if (value < now.least.value) now.least = sample;
    if (value > now.largest.value) now.largest = sample;
    if (!largest_ || value > largest_->value) largest_ = sample;
    if (!least_ || value < least_->value) least_ = sample;
    last_ = sample;
}

std::vector<Sample> Series::samples() const {
    std::vector<Sample> all;
    for (const Interval& each : intervals_) {
        all.push_back(each.first);
        const bool falls = each.largest.time < each.least.time;
        all.push_back(falls ? each.largest : each.least);
        all.push_back(falls ? each.least : each.largest);
        all.push_back(each.last);
    }
    const auto alike = [](const Sample& a, const Sample& b) { return a.time == b.time; };
    all.erase(std::unique(all.begin(), all.end(), alike), all.end());
    return all;
}

std::optional<double> Series::at(double time) const {
    const auto after =
        std::ranges::upper_bound(intervals_, time, {}, [](const Interval& each) { return each.first.time; });
    if (after == intervals_.begin()) return std::nullopt;
    const Interval& found = *std::prev(after);
    const Sample* last = &found.first;
    for (const Sample* each : {&found.least, &found.largest, &found.last})
        if (each->time <= time && each->time >= last->time) last = each;
    return last->value;
}

} // namespace windlass::debrief
