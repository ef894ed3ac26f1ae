// Session: alerts that the state of the exercise raises and ends.

#include "server/run/session.hpp"

#include <spdlog/fmt/fmt.h>

namespace windlass::server {

namespace {

constexpr const char* kWatchCircle = "watch.circle";
constexpr const char* kOwnShipLost = "own_ship.lost";

} // namespace

/// The bridge's anchor watch: the ship's outline has left the circle, or is back in it.
void Session::watch_the_circle() {
    const bool outside = snapshot_.outside_watch_circle;
    if (outside == outside_watch_circle_) return;
    outside_watch_circle_ = outside;
    if (!outside) {
        alerts_.rectify(kWatchCircle, -1, snapshot_.tick, snapshot_.time);
        return;
    }
    alerts_.raise(
        {.code = kWatchCircle,
         .side = -1,
         .tick = snapshot_.tick,
         .time = snapshot_.time,
         .raised_time = snapshot_.time,
         .priority = AlertPriority::warning,
         .condition = AlertCondition::active_unacknowledged,
         .value = snapshot_.watch_circle.radius,
         .text = "Outside anchor circle",
         .explanation = fmt::format("Part of the ship is outside the circle of {:.0f} m. Take bearings; call "
                                    "the master; engine and second anchor ready.",
                                    snapshot_.watch_circle.radius),
         .bridge_panel = true});
}

/// A foreign ship model that falls silent leaves the ship adrift: somebody must take the helm.
void Session::watch_the_foreign_ship() {
    for (const auto& event : snapshot_.events) {
        const std::string_view code = event.code;
        if (code == "own_ship.foreign" || code == "own_ship.handed_back")
            alerts_.rectify(kOwnShipLost, -1, snapshot_.tick, snapshot_.time);
        if (code != kOwnShipLost) continue;
        alerts_.raise({.code = kOwnShipLost,
                       .side = -1,
                       .tick = snapshot_.tick,
                       .time = snapshot_.time,
                       .raised_time = snapshot_.time,
                       .priority = AlertPriority::warning,
                       .condition = AlertCondition::active_unacknowledged,
                       .value = 0,
                       .text = "Foreign ship model lost",
                       .explanation =
                           "Nothing is heard of the simulator that moves the ship. She lies still; "
                           "move the helm to sail her by the server's own model."});
    }
}

} // namespace windlass::server
