#include "recorder/remedies.hpp"

#include "lesson/whatif/two_courses.hpp"
#include "lesson/whatif/words.hpp"
#include "recorder/command.hpp"
#include "recorder/whatif/recorded_attempt.hpp"
#include "server/assess/quantities.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace windlass::recorder {

namespace {

std::optional<double> time_of(const whatif::Trials& trials, const whatif::Answer& answer) {
    if (answer.kept) return trials.seconds(answer.kept->change.tick);
    if (answer.taken_over) return answer.taken_over->time;
    return std::nullopt;
}

/// A factor and an offset from SI to what a seaman reads.
struct Shown {
    const char *si, *unit;
    double factor, offset;
};
constexpr std::array<Shown, 4> kShown{{{"N", "kN", 1e-3, 0},
                                       {"N/s", "kN/s", 1e-3, 0},
                                       {"K", "\u00b0C", 1, -words::limits::ice_point},
                                       {"yes", "1: yes", 1, 0}}};

debrief::TwoCourses shown(const whatif::TwoCurves& curves) {
    const assess::Quantity& quantity = assess::quantities()[static_cast<std::size_t>(curves.quantity)];
    Shown as{"", quantity.unit, 1, 0};
    for (const Shown& row : kShown)
        if (std::string_view(row.si) == quantity.unit) as = row;
    const auto value = [&](double si) { return si * as.factor + as.offset; };
    const auto samples = [&](const std::vector<whatif::Point>& points) {
        std::vector<debrief::Sample> all;
        for (const whatif::Point& point : points)
            all.push_back({point.time, value(point.value)});
        return all;
    };
    const auto limit = [&](double si) { return std::isfinite(si) ? std::optional(value(si)) : std::nullopt; };
    return {.title = quantity.text,
            .unit = as.unit,
            .was = samples(curves.was),
            .would = samples(curves.would),
            .least = limit(curves.least),
            .most = limit(curves.most)};
}

debrief::Remedy remedy_of(whatif::Trials& trials, const whatif::Answer& answer,
                          const std::string& criterion) {
    debrief::Remedy remedy{criterion, time_of(trials, answer), whatif::remedy_words(trials, answer)};
    const auto both = whatif::two_courses(trials, answer);
    if (!both) return remedy;
    remedy.changed = both->changed;
    remedy.lost = both->lost;
    remedy.only_said = both->curves.empty();
    for (const whatif::TwoCurves& curves : both->curves)
        remedy.courses.push_back(shown(curves));
    return remedy;
}

} // namespace

std::optional<std::vector<debrief::Remedy>> remedies_of(recording::Recording& recording, std::size_t run,
                                                        const std::filesystem::path& config) {
    try {
        const whatif::Attempt attempt = recorded_attempt(recording, run);
        whatif::Trials trials(attempt, model_of(attempt, config));
        const auto lost = whatif::lost_criteria(trials);
        std::vector<debrief::Remedy> remedies;
        for (const std::string& criterion : lost) {
            tell(fmt::format("what would have kept {} ({} of {})", criterion, remedies.size() + 1,
                             lost.size()));
            remedies.push_back(remedy_of(trials, whatif::what_if(trials, criterion), criterion));
        }
        return remedies;
    } catch (const std::runtime_error& error) {
        tell(fmt::format("what would have kept lost points is not searched for: {}", error.what()));
        return std::nullopt;
    }
}

} // namespace windlass::recorder
