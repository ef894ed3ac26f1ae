#include "recorder/debrief/attempt.hpp"

#include <algorithm>

namespace windlass::debrief {

const Truth* Side::truth_at(double time) const {
    const auto after = std::ranges::upper_bound(truths, time, {}, &Truth::time);
    return after == truths.begin() ? nullptr : &*std::prev(after);
}

std::optional<double> Attempt::lesson_over() const {
    constexpr double kAtItsEnd = 1; // s: an exercise that is ended as soon as its lesson is over
    if (!assessment || !assessment->finished() || assessment->time() > ended - kAtItsEnd) return std::nullopt;
    return assessment->time();
}

double Attempt::position_of(double time) const {
    if (positions.empty()) return 0;
    const auto after =
        std::ranges::upper_bound(positions, time, {}, [](const auto& each) { return each.first; });
    if (after == positions.begin()) return after->second;
    const auto before = std::prev(after);
    if (after == positions.end()) return before->second;
    const double part = (time - before->first) / (after->first - before->first);
    return before->second + part * (after->second - before->second);
}

const Event* Attempt::event(std::string_view code, int side, double from) const {
    const auto found = std::ranges::find_if(events, [&](const Event& each) {
        return std::string_view(each.code().c_str()) == code && each.time() >= from &&
               (side < 0 || each.side() == side);
    });
    return found == events.end() ? nullptr : &*found;
}

} // namespace windlass::debrief
