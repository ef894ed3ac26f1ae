#include "recorder/remedies.hpp"

#include "lesson/whatif/words.hpp"
#include "recorder/command.hpp"
#include "recorder/whatif/recorded_attempt.hpp"

#include <fmt/format.h>

namespace windlass::recorder {

namespace {

std::optional<double> time_of(const whatif::Trials& trials, const whatif::Answer& answer) {
    if (answer.kept) return trials.seconds(answer.kept->change.tick);
    if (answer.taken_over) return answer.taken_over->time;
    return std::nullopt;
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
            const whatif::Answer answer = whatif::what_if(trials, criterion);
            remedies.push_back({criterion, time_of(trials, answer), whatif::remedy_words(trials, answer)});
        }
        return remedies;
    } catch (const std::runtime_error& error) {
        tell(fmt::format("what would have kept lost points is not searched for: {}", error.what()));
        return std::nullopt;
    }
}

} // namespace windlass::recorder
