// Session: alerts that the state of the exercise raises and ends. Each goes by what stands in the state and
// by no event, so that a state which is brought back has its alerts.

#include "server/exercise/watch/model_watch.hpp"
#include "server/run/session.hpp"

#include <spdlog/fmt/fmt.h>

#include <string_view>

namespace windlass::run {

namespace {

constexpr const char* kRunaway = "cable.runaway";
constexpr const char* kRunsFast = "cable.fast";
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

/// Looks at what stands now, in a tick or where a run begins.
void Session::watch_what_stands() {
    watch_the_circle();
    watch_for_a_fast_cable();
    watch_for_a_runaway();
    watch_the_motors();
    watch_the_foreign_ship();
    watch_the_model();
}

/// Whether an alert is to be raised; ends it where what it tells of does not stand. One that was raised later
/// than now is of a course that was gone back before, and is told anew.
bool Session::comes_up(words::AlertCode code, int side, bool stands) {
    const std::string_view name = code.row().name;
    if (!stands) alerts_.rectify(name, side, tick_, time_);
    return stands && !alerts_.stands(name, side, time_);
}

/// The bridge's anchor watch: the ship's outline has left the circle, or is back in it.
void Session::watch_the_circle() {
    if (!comes_up(kWatchCircle, -1, snapshot_.outside_watch_circle)) return;
    const double radius = snapshot_.watch_circle.radius;
    alerts_.raise(alert(kWatchCircle, -1, radius, {fmt::format("{:.0f}", radius)}));
}

/// A cable that nobody checks, and that does not run away yet: faster than practice ever lets it run, until
/// it is no faster than it likes it. For instructors: on deck it is seen and heard.
void Session::watch_for_a_fast_cable() {
    for (const auto& tackle : snapshot_.tackle) {
        const int side = static_cast<int>(tackle.side);
        const double limit = alerts_.stands(kRunsFast, side, time_) ? words::limits::cable_fast
                                                                    : words::limits::cable_unchecked;
        const double speed = tackle.windlass.cable_speed;
        if (comes_up(kRunsFast, side, speed > limit && !exercise_.runs_away(tackle.side)))
            alerts_.raise(alert(kRunsFast, side, speed));
    }
}

/// A cable that runs away, until it is no faster than practice lets it run.
void Session::watch_for_a_runaway() {
    for (const auto& tackle : snapshot_.tackle) {
        const int side = static_cast<int>(tackle.side);
        if (comes_up(kRunaway, side, exercise_.runs_away(tackle.side)))
            alerts_.raise(alert(kRunaway, side, tackle.windlass.cable_speed));
    }
}

/// A windlass motor that its protection has cut off, until it is reset. An emergency stop and a lost supply,
/// which cut it off, too, are no trips.
void Session::watch_the_motors() {
    for (const auto& tackle : snapshot_.tackle) {
        const int side = static_cast<int>(tackle.side);
        if (comes_up(kMotorTripped, side, exercise_.motor_tripped(tackle.side)))
            alerts_.raise(alert(kMotorTripped, side, 0));
    }
}

/// A foreign ship model that falls silent leaves the ship adrift: somebody must take the helm.
void Session::watch_the_foreign_ship() {
    if (comes_up(kOwnShipLost, -1, exercise_.foreign_lost())) alerts_.raise(alert(kOwnShipLost, -1, 0));
}

/// The model's steps are no longer what they should be: for the instructor, who judges by its figures.
void Session::watch_the_model() {
    if (!comes_up(kModelInDoubt, -1, snapshot_.model_in_doubt)) return;
    alerts_.raise(alert(kModelInDoubt, -1, static_cast<double>(snapshot_.model_steps.steps),
                        {exercise::words(snapshot_.model_steps)}));
}

} // namespace windlass::run
