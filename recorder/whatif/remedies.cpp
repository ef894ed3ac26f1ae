#include "recorder/remedies.hpp"

#include "lesson/whatif/two_courses.hpp"
#include "lesson/whatif/words.hpp"
#include "recorder/debrief/seat_units.hpp"
#include "recorder/whatif/recorded_attempt.hpp"
#include "server/assess/quantities.hpp"
#include "server/dds/convert.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <mutex>
#include <thread>

namespace windlass::recorder {

namespace {

std::optional<double> time_of(const whatif::Trials& trials, const whatif::Answer& answer) {
    if (answer.kept) return trials.seconds(answer.kept->change.tick);
    if (answer.taken_over) return answer.taken_over->time;
    return std::nullopt;
}

debrief::TwoCourses shown(const whatif::TwoCurves& curves) {
    const assess::Quantity& quantity = assess::quantity_at(curves.quantity);
    const std::string unit = quantity.unit;
    const debrief::SeatUnit as =
        unit == "yes" ? debrief::SeatUnit{"1: yes"} : debrief::seat_unit(unit, quantity.name);
    const auto value = [&](double si) { return si * as.factor + as.offset; };
    const auto samples = [&](const std::vector<whatif::Point>& points) {
        std::vector<debrief::Sample> all;
        for (const whatif::Point& point : points)
            all.push_back({point.time, value(point.value)});
        return all;
    };
    const auto limit = [&](double si) { return std::isfinite(si) ? std::optional(value(si)) : std::nullopt; };
    return {.title = quantity.text,
            .unit = as.name,
            .was = samples(curves.was),
            .would = samples(curves.would),
            .least = limit(curves.least),
            .most = limit(curves.most)};
}

debrief::SceneAt scene_of(const exercise::Snapshot& seen) {
    debrief::SceneAt scene{.time = seen.time, .ship = ShipState(), .chains = {}, .anchors = {}};
    dds::convert(seen, *scene.ship);
    for (const exercise::TackleView& tackle : seen.tackle) {
        const auto side = static_cast<std::size_t>(tackle.side);
        dds::convert(seen, tackle, scene.chains[side].emplace());
        dds::convert(seen, tackle, scene.anchors[side].emplace());
    }
    return scene;
}

/// Whose cable to look at: that of the lever that is moved otherwise, else the criterion's own.
int side_of(const whatif::Trials& trials, const whatif::Answer& answer) {
    const std::optional<whatif::Change> change = answer.kept         ? answer.kept->change
                                                 : answer.taken_over ? answer.taken_over->first
                                                                     : std::nullopt;
    return change && !change->lever.of_helm() ? static_cast<int>(change->lever.side)
                                              : trials.lesson().criteria[answer.criterion].side;
}

debrief::Remedy remedy_of(whatif::Trials& trials, const whatif::Answer& answer,
                          const std::string& criterion) {
    debrief::Remedy remedy{criterion, time_of(trials, answer), whatif::remedy_words(trials, answer)};
    const auto both = whatif::two_courses(trials, answer);
    if (!both) return remedy;
    remedy.changed = both->changed;
    remedy.lost = both->lost;
    remedy.only_said = both->curves.empty();
    remedy.side = side_of(trials, answer);
    if (both->was && both->would && !remedy.only_said) {
        remedy.was = scene_of(*both->was);
        remedy.would = scene_of(*both->would);
    }
    for (const whatif::TwoCurves& curves : both->curves)
        remedy.courses.push_back(shown(curves));
    return remedy;
}

} // namespace

std::vector<debrief::Remedy> remedies_of(recording::Recording& recording, std::size_t run,
                                         const std::filesystem::path& config, const Tell& tell,
                                         std::stop_token stop) {
    const whatif::Attempt attempt = recorded_attempt(recording, run);
    const whatif::Trials trials(attempt, model_of(attempt, config, tell), std::move(stop));
    const auto lost = whatif::lost_criteria(trials);
    std::vector<debrief::Remedy> remedies(lost.size());
    std::size_t next = 0;
    std::mutex telling;
    const auto search = [&] {
        whatif::Trials own = trials;
        while (true) {
            std::size_t place = 0;
            {
                const std::lock_guard lock(telling);
                if (next == lost.size()) return;
                place = next++;
                tell(fmt::format("what would have kept {} ({} of {})", lost[place], place + 1, lost.size()));
            }
            remedies[place] = remedy_of(own, whatif::what_if(own, lost[place]), lost[place]);
        }
    };
    std::vector<std::future<void>> threads(
        std::min<std::size_t>(lost.size(), std::max(1U, std::thread::hardware_concurrency())));
    for (std::future<void>& thread : threads)
        thread = std::async(std::launch::async, search);
    for (std::future<void>& thread : threads)
        thread.get();
    return remedies;
}

} // namespace windlass::recorder
