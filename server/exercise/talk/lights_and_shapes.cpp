#include "server/exercise/talk/lights_and_shapes.hpp"

namespace windlass::exercise {

namespace {
constexpr double kSunrise = 6 * 3600, kSunset = 18 * 3600; // s since local midnight
} // namespace

void show(const LightsAndShapes& ordered, LightsAndShapes& shown, const EventLog& log) {
    if (ordered.anchor_ball != shown.anchor_ball)
        log("signals.anchor_ball", -1, ordered.anchor_ball ? 1 : 0,
            ordered.anchor_ball ? "anchor ball hoisted" : "anchor ball taken down");
    if (ordered.anchor_lights != shown.anchor_lights)
        log("signals.anchor_lights", -1, ordered.anchor_lights ? 1 : 0,
            ordered.anchor_lights ? "anchor lights switched on" : "anchor lights switched off");
    shown = ordered;
}

LightsAndShapes at_anchor_by(double time_of_day) {
    const bool day = time_of_day >= kSunrise && time_of_day < kSunset;
    return {.anchor_ball = day, .anchor_lights = !day};
}

} // namespace windlass::exercise
