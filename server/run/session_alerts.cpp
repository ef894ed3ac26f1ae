// Session: alerts that the state of the exercise raises and ends.

#include "server/exercise/model_watch.hpp"
#include "server/run/session.hpp"

#include <spdlog/fmt/fmt.h>

namespace windlass::server {

namespace {

constexpr const char* kWatchCircle = "watch.circle";
constexpr const char* kModelInDoubt = "model.in_doubt";

} // namespace

/// The bridge's anchor watch: the ship's outline has left the circle, or is back in it.
void Session::watch_the_circle() {
    const bool outside = snapshot_.outside_watch_circle;
    if (outside == outside_watch_circle_) return;
    outside_watch_circle_ = outside;
    if (!outside) {
        alerts_.rectify(kWatchCircle, -1, tick_, time_);
        return;
    }
    alerts_.raise(
        {.code = kWatchCircle,
         .side = -1,
         .tick = tick_,
         .time = time_,
         .raised_time = time_,
         .priority = AlertPriority::warning,
         .condition = AlertCondition::active_unacknowledged,
         .value = snapshot_.watch_circle.radius,
         .text = "Outside anchor circle",
         .explanation = fmt::format("Part of the ship is outside the circle of {:.0f} m. Take bearings; call "
                                    "the master; engine and second anchor ready.",
                                    snapshot_.watch_circle.radius),
         .bridge_panel = true});
}

/// The model's steps are no longer what they should be: for the instructor, who judges by its figures.
void Session::watch_the_model() {
    const bool in_doubt = snapshot_.model_in_doubt;
    if (in_doubt == model_in_doubt_) return;
    model_in_doubt_ = in_doubt;
    if (!in_doubt) {
        alerts_.rectify(kModelInDoubt, -1, tick_, time_);
        return;
    }
    alerts_.raise(
        {.code = kModelInDoubt,
         .side = -1,
         .tick = tick_,
         .time = time_,
         .raised_time = time_,
         .priority = AlertPriority::caution,
         .condition = AlertCondition::active_unacknowledged,
         .value = static_cast<double>(snapshot_.model_steps.steps),
         .text = "Figures of the cable are in doubt",
         .explanation = fmt::format("In the last 10 s {}. Loads may err by more than is shown: judge "
                                    "nobody by them.",
                                    exercise::words(snapshot_.model_steps))});
}

} // namespace windlass::server
