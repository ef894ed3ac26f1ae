// Session: alerts that the state of the exercise raises and ends.

#include "server/exercise/watch/model_watch.hpp"
#include "server/run/session.hpp"

#include <spdlog/fmt/fmt.h>

namespace windlass::run {

namespace {

constexpr const char* kWatchCircle = "watch.circle";
constexpr const char* kOwnShipLost = "own_ship.lost";
constexpr const char* kModelInDoubt = "model.in_doubt";

/// One of the whole ship, raised now.
AlertView alert(const char* code, const exercise::Snapshot& now, AlertPriority priority, double value,
                std::string text, std::string explanation) {
    return {.code = code,
            .side = -1,
            .tick = now.tick,
            .time = now.time,
            .raised_time = now.time,
            .priority = priority,
            .condition = AlertCondition::active_unacknowledged,
            .value = value,
            .text = std::move(text),
            .explanation = std::move(explanation)};
}

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
    const double radius = snapshot_.watch_circle.radius;
    AlertView left =
        alert(kWatchCircle, snapshot_, AlertPriority::warning, radius, "Outside anchor circle",
              fmt::format("Part of the ship is outside the circle of {:.0f} m. Take bearings; call "
                          "the master; engine and second anchor ready.",
                          radius));
    left.bridge_panel = true;
    alerts_.raise(std::move(left));
}

/// A foreign ship model that falls silent leaves the ship adrift: somebody must take the helm.
void Session::watch_the_foreign_ship() {
    for (const auto& event : snapshot_.events) {
        const std::string_view code = event.code;
        if (code == "own_ship.foreign" || code == "own_ship.handed_back")
            alerts_.rectify(kOwnShipLost, -1, snapshot_.tick, snapshot_.time);
        if (code == kOwnShipLost)
            alerts_.raise(
                alert(kOwnShipLost, snapshot_, AlertPriority::warning, 0, "Foreign ship model lost",
                      "Nothing is heard of the simulator that moves the ship. She lies still; move the helm "
                      "to sail her by the server's own model."));
    }
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
        alert(kModelInDoubt, snapshot_, AlertPriority::caution,
              static_cast<double>(snapshot_.model_steps.steps), "Figures of the cable are in doubt",
              fmt::format("In the last 10 s {}. Loads may err by more than is shown: judge nobody by them.",
                          exercise::words(snapshot_.model_steps))));
}

} // namespace windlass::run
