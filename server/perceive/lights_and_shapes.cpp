// What she shows to all around her.

#include "server/perceive/perceive.hpp"

namespace windlass::perceive {

void perceive_lights_and_shapes(const exercise::Snapshot& from, LightsAndShapes& to) {
    to.tick(from.tick);
    to.time(from.time);
    to.anchor_ball(from.lights_and_shapes.anchor_ball);
    to.anchor_lights(from.lights_and_shapes.anchor_lights);
}

} // namespace windlass::perceive
