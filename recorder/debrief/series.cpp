#include "recorder/debrief/series.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace windlass::debrief {

namespace {

std::optional<Sample> newest(const std::vector<Sample>& extremes) {
    return extremes.empty() ? std::nullopt : std::optional(extremes.back());
}

std::optional<Sample> newest_until(const std::vector<Sample>& extremes, double time) {
    const auto after = std::ranges::upper_bound(extremes, time, {}, &Sample::time);
    return after == extremes.begin() ? std::nullopt : std::optional(*std::prev(after));
}

} // namespace

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
    if (rises_.empty() || value > rises_.back().value) rises_.push_back(sample);
    if (falls_.empty() || value < falls_.back().value) falls_.push_back(sample);
    last_ = sample;
}

std::optional<Sample> Series::largest() const {
    return newest(rises_);
}

std::optional<Sample> Series::least() const {
    return newest(falls_);
}

std::optional<Sample> Series::largest_until(double time) const {
    return newest_until(rises_, time);
}

std::optional<Sample> Series::least_until(double time) const {
    return newest_until(falls_, time);
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
