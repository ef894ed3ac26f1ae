#include "instructor_console/recording_position.hpp"

#include "common/text.hpp"
#include "recorder/resimulate/resimulation.hpp"
#include "server/assess/lesson.hpp"
#include "server/exercise/checkpoint.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace windlass::console {

namespace {

/// The whole text as a number that is not negative.
std::optional<double> number_in(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) && value >= 0 ? std::optional(value) : std::nullopt;
}

std::optional<double> time_in(std::string_view text) {
    const auto colon = text.find(':');
    if (colon == std::string_view::npos) return number_in(text);
    const auto minutes = number_in(text.substr(0, colon)), seconds = number_in(text.substr(colon + 1));
    if (!minutes || !seconds || *seconds >= 60) return std::nullopt;
    return 60 * *minutes + *seconds;
}

} // namespace

std::optional<RecordingPosition> moment_in(const std::string& text) {
    const auto at = text.rfind('@'); // a folder may have one in its name
    if (at == std::string::npos || at == 0) return std::nullopt;
    const auto time = time_in(std::string_view(text).substr(at + 1));
    return time ? std::optional(RecordingPosition{text.substr(0, at), *time}) : std::nullopt;
}

namespace {

ServerOrder<RestoreCommand> go_on_from(recording::Recording& recording, const recorder::Run& meant,
                                       double time) {
    const std::string when = recorder::clock_text(time);
    ServerOrder<RestoreCommand> order;
    order.sample.from() = std::string(clipped(fmt::format("{} at {}", recording.name(), when), 128));
    // Who goes on from a moment that was there before is no longer tested.
    order.sample.checkpoint(exercise::with_lesson(
        recorder::Resimulation(recording, meant, *meant.checkpoint_before(time)).state_at(time),
        assess::for_practice));
    order.done = fmt::format("restored to {} of {}, paused", when, recording.name());
    order.carried_out = logged("exercise.restored");
    return order;
}

} // namespace

ServerOrder<RestoreCommand> restore_order(const RecordingPosition& moment, std::size_t run) {
    recording::Recording recording({moment.recording});
    const auto runs = recorder::runs_of(recording);
    return go_on_from(recording, recorder::find_run(runs, run, moment.time), moment.time);
}

ServerOrder<RestoreCommand> restore_order_at(const std::filesystem::path& path, double position) {
    recording::Recording recording({path});
    const auto runs = recorder::runs_of(recording);
    const recorder::Moment shown = recorder::shown_at(recording, runs, position);
    return go_on_from(recording, *shown.run, shown.time);
}

} // namespace windlass::console
