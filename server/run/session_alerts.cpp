// Session: alerts that the state of the exercise raises and ends.

#include "server/exercise/watch/model_watch.hpp"
#include "server/run/session.hpp"

#include <spdlog/fmt/fmt.h>

#include <string_view>
#include <utility>

namespace windlass::run {

namespace {

constexpr const char* kRunaway = "cable.runaway";
constexpr const char* kMotorTripped = "motor.trip";
constexpr const char* kWatchCircle = "watch.circle";
constexpr const char* kOwnShipLost = "own_ship.lost";
constexpr const char* kModelInDoubt = "model.in_doubt";

} // namespace

/// An alert raised now, in the words of words.json; said: what they leave to be filled in.
AlertView Session::alert(words::AlertCode code, int side, double value,
                         const std::vector<std::string>& said) const {
    const words::Alert& row = code.row();
    return {.code = std::string(row.name),
            .side = side,
            .tick = tick_,
            .time = time_,
            .raised_time = time_,
            .priority = row.priority,
            .condition = AlertCondition::active_unacknowledged,
            .value = value,
            .text = words::filled(row.said, said),
            .explanation = words::filled(row.explanation, said),
            .deck_panel = row.deck,
            .bridge_panel = row.bridge};
}

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
    alerts_.raise(alert(kWatchCircle, -1, radius, {fmt::format("{:.0f}", radius)}));
}

/// A cable that runs away, until it is no faster than practice lets it run.
void Session::watch_for_a_runaway() {
    for (const auto& event : snapshot_.events)
        if (event.code == kRunaway) alerts_.raise(alert(kRunaway, event.side, event.value));
    for (const auto& tackle : snapshot_.tackle)
        if (tackle.windlass.cable_speed < words::limits::cable_fast)
            alerts_.rectify(kRunaway, static_cast<int>(tackle.side), tick_, time_);
}

/// A windlass motor that its protection has cut off, until the trip lamp is dark: reset, it runs again. That
/// lamp is lit by an emergency stop and a lost supply, too, which are no trips.
void Session::watch_the_motors() {
    for (const auto& event : snapshot_.events) {
        const std::string_view code = event.code;
        if (code != "motor.overload_trip" && code != "motor.overspeed_trip") continue;
        if (std::exchange(motor_tripped_.at(static_cast<std::size_t>(event.side)), true)) continue;
        alerts_.raise(alert(kMotorTripped, event.side, 0));
    }
    for (const auto& tackle : snapshot_.tackle) {
        bool& tripped = motor_tripped_.at(static_cast<std::size_t>(tackle.side));
        if (tackle.windlass.tripped || !std::exchange(tripped, false)) continue;
        alerts_.rectify(kMotorTripped, static_cast<int>(tackle.side), tick_, time_);
    }
}

/// A foreign ship model that falls silent leaves the ship adrift: somebody must take the helm.
void Session::watch_the_foreign_ship() {
    for (const auto& event : snapshot_.events) {
        const std::string_view code = event.code;
        if (code == "own_ship.foreign" || code == "own_ship.handed_back")
            alerts_.rectify(kOwnShipLost, -1, snapshot_.tick, snapshot_.time);
        if (code == kOwnShipLost) alerts_.raise(alert(kOwnShipLost, -1, 0));
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
    alerts_.raise(alert(kModelInDoubt, -1, static_cast<double>(snapshot_.model_steps.steps),
                        {exercise::words(snapshot_.model_steps)}));
}

} // namespace windlass::run
